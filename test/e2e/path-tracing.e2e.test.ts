/** The path traced picture in the page: on CPU threads, as the test's browser has no GPU. */
import { beforeAll, describe, expect, it } from 'vitest';
import { completed, parseRenderOptions } from '../../src/cli/render/options.ts';
import { planned } from '../../src/cli/render/plan.ts';
import { difference, fromAttributes } from '../../src/cli/render/record.ts';
import { decodeExr } from '../../src/io/exr.ts';
import { addLight, addObject } from '../../src/scene/commands.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { type LabPage, openLab } from './lab.ts';
import { outlinedOn } from './outline-pixels.ts';

/** One convex thing under one light: nothing that only a path tracer shows. */
function sphereUnderSun(): string {
  const store = new DocumentStore(createDocument());
  addLight(store, 'directional');
  addObject(store, 'sphere');
  store.edit('For a test', (draft) => {
    Object.assign(draft.pathTracing, { samples: 16, error: 0, maxDepth: 2 });
    draft.view.resolutionScale = 0.5;
  });
  return serializeDocument(store.document);
}

const lab = await openLab();
let page: LabPage;

async function openSphere(init = ''): Promise<LabPage> {
  const files = { '/scene.json': sphereUnderSun() };
  return (await lab.open({ query: '?scene=/scene.json', files, init, width: 720, height: 420 })).ready();
}

beforeAll(async () => {
  page = await openSphere();
});

const figures = () => page.page.locator('.tracing-text').innerText();
const mode = (name: string) => page.page.getByRole('radio', { name });
const counts = () =>
  page.page.evaluate<{ renderings: number; packed: number }>('irradia.viewport.tracing.counts');

/** Until the picture is what was asked for, with nothing left to do. */
async function complete(renderings: number, on = page): Promise<void> {
  await on.page.evaluate(`new Promise((resolve) => {
    const { tracing } = irradia.viewport;
    const look = () => {
      const { counts, state } = tracing;
      if (counts.renderings < ${renderings} || state.kind !== 'picture' || state.figures.reached === null) return;
      stop();
      resolve();
    };
    const stop = tracing.subscribe(look);
    look();
  })`);
}

/** The mean of the differences of the interactive and the path traced picture, sRGB, 0 to 255. */
function meanDifference(on = page): Promise<number> {
  return on.page.evaluate(`(async () => {
    const { renderer, viewport, store } = irradia;
    const { view } = store.document;
    const one = await renderer.readImage(view, null);
    const other = await renderer.readImage(view, { radiance: viewport.tracing.texture, from: 0 });
    return one.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / one.length;
  })()`);
}

it('is shown at a click, says by what, and is the interactive picture where that one is right', async () => {
  expect(await page.page.evaluate('crossOriginIsolated')).toBe(true);
  await mode('Path traced').click();
  await complete(1);
  expect(await figures()).toMatch(/^16 samples\/pixel · .* s · error .* % · complete$/);
  expect(await page.page.locator('.tracing-device').innerText()).toMatch(
    /^[\d.e+-]+ Mpaths\/s by \d+ CPU threads?, as WebGPU is only emulated here$/,
  );
  expect(await page.page.getByRole('progressbar').getAttribute('aria-valuenow')).toBe('100');
  expect(await meanDifference()).toBeLessThan(1);
  // What is selected has its outline here, too, and in no picture that is read.
  const { x, y, width, height } = (await page.page.locator('.viewport').boundingBox())!;
  await page.page.mouse.click(x + width / 2, y + height / 2);
  await expect.poll(() => outlinedOn(page)).toBeGreaterThan(100);
  expect(await meanDifference()).toBeLessThan(1);
});

it('begins anew for another material, which packs the scene, and for another camera, which does not', async () => {
  const before = await counts();
  const light = await page.page.evaluate<number>(`(() => {
    const { store } = irradia;
    const [id] = Object.keys(store.document.materials);
    store.edit('Black', (draft) => { draft.materials[id].emissive = [1, 0, 0]; draft.materials[id].emissiveIntensity = 1; });
    return store.document.materials[id].emissive[0];
  })()`);
  expect(light).toBe(1);
  await complete(before.renderings + 1);
  expect(await counts()).toEqual({ renderings: before.renderings + 1, packed: before.packed + 1 });
  await page.page.evaluate(`irradia.store.edit('Move', (draft) => { draft.camera.position[0] += 0.5; })`);
  await complete(before.renderings + 2);
  expect(await counts()).toEqual({ renderings: before.renderings + 2, packed: before.packed + 1 });
  expect(await meanDifference()).toBeLessThan(1);
  await page.page.evaluate(`irradia.store.edit('Expose', (draft) => { draft.view.exposure = 1; })`);
  await page.picture();
  expect(await counts()).toEqual({ renderings: before.renderings + 2, packed: before.packed + 1 });
  expect(await meanDifference()).toBeLessThan(1);
});

it('pauses, goes on, and has keys for both and for the renderings', async () => {
  await page.page.keyboard.press('p');
  await page.page.getByRole('button', { name: 'Go on path tracing' }).waitFor();
  await page.page.keyboard.press('p');
  await page.page.getByRole('button', { name: 'Pause path tracing' }).waitFor();
  await page.page.keyboard.press('1');
  expect(await mode('Interactive').getAttribute('aria-checked')).toBe('true');
  await page.page.locator('.tracing-progress').waitFor({ state: 'hidden' });
  await page.page.keyboard.press('3');
  expect(await mode('Split').getAttribute('aria-checked')).toBe('true');
  await expect.poll(() => outlinedOn(page)).toBeGreaterThan(100);
});

describe('Split', () => {
  it('has a divider for mouse and keyboard', async () => {
    const divider = page.page.getByRole('separator', { name: /Divider/ });
    expect(await divider.getAttribute('aria-valuenow')).toBe('50');
    await divider.focus();
    await page.page.keyboard.press('ArrowRight');
    await page.page.keyboard.press('Shift+ArrowRight');
    expect(await divider.getAttribute('aria-valuenow')).toBe('62');
    const [bar, view] = [await divider.boundingBox(), await page.page.locator('.viewport').boundingBox()];
    if (!bar || !view) throw new Error('no divider');
    // An arrow of what is selected lies under the middle of it, and is in front; the divider's own handle is at its end.
    const [x, middle, end] = [bar.x + bar.width / 2, bar.y + bar.height / 2, bar.y + bar.height - 20];
    await page.page.mouse.move(x, middle);
    expect(
      await page.page.evaluate(`document.elementFromPoint(${x}, ${middle}).matches('.viewport canvas')`),
    ).toBe(true);
    await page.page.mouse.move(x, end);
    await page.page.mouse.down();
    await page.page.mouse.move(view.x + view.width / 4, end);
    await page.page.mouse.up();
    expect(await divider.getAttribute('aria-valuenow')).toBe('25');
  });

  it('shows the interactive picture left of it and the path traced one right of it', async () => {
    const same = await page.page.evaluate<boolean[]>(`(async () => {
      const { renderer, viewport, store } = irradia;
      const { view } = store.document;
      await viewport.nextFrame();
      const radiance = viewport.tracing.texture;
      const [one, other, both] = [
        await renderer.readImage(view, null),
        await renderer.readImage(view, { radiance, from: 0 }),
        await renderer.readImage(view),
      ];
      const { width, height } = renderer.canvas;
      const equal = (a, b, from, to) => {
        for (let y = 0; y < height; y++)
          for (let i = 4 * (y * width + from); i < 4 * (y * width + to); i++) if (a[i] !== b[i]) return false;
        return true;
      };
      const edge = Math.round(width / 4);
      return [
        equal(both, one, 0, edge - 1),
        equal(both, other, edge + 1, width),
        equal(one, other, 0, width),
      ];
    })()`);
    expect(same).toEqual([true, true, false]);
  });
});

describe('Difference', () => {
  it('shows a map and its mean, which is small here', async () => {
    await mode('Difference').click();
    const mean = page.page.locator('.difference-mean');
    await mean.getByText(/mean 0\.\d{4}/).waitFor();
    expect(Number((await mean.innerText()).slice(5))).toBeLessThan(0.05);
    const colors = await page.page.evaluate<number>(`(() => {
      const canvas = document.querySelector('.difference-map');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    })()`);
    expect(colors).toBeGreaterThan(10);
    await expect.poll(() => outlinedOn(page, '.difference-lines')).toBeGreaterThan(100);
  });
});

async function save(item: string): Promise<Buffer> {
  await page.page.getByRole('button', { name: 'Screenshot' }).click();
  const download = page.page.waitForEvent('download');
  await page.page.click(`.menu button >> text="${item}"`);
  const chunks: Buffer[] = [];
  for await (const chunk of await (await download).createReadStream()) chunks.push(chunk as Buffer);
  return Buffer.concat(chunks);
}

async function saveExr() {
  return decodeExr(await save('Path traced radiance, EXR'), 'a.exr');
}

it('is saved as PNG and as EXR', async () => {
  expect((await save('Path traced picture, PNG')).subarray(1, 4).toString()).toBe('PNG');
  const { channels, attributes } = await saveExr();
  expect(channels.map(({ name }) => name)).toEqual(['B', 'G', 'R']);
  expect(attributes).toMatchObject({ 'irradia:samples': '0:16' });
  // What `irradia render` would say of the document: `irradia merge` takes them for parts of one rendering.
  const document = parseDocument(
    JSON.parse(await page.page.evaluate('JSON.stringify(irradia.store.document)')),
    'a.json',
  );
  const words = { output: 'b.exr', renderer: 'pathtracer', size: '4x4', device: 'auto', samples: '16:32' };
  const plans = await planned(document, completed(parseRenderOptions(words), document.pathTracing));
  expect(difference(fromAttributes(attributes ?? {}, 'a.exr'), plans[0]!.record)).toBeNull();
});

it('is denoised where that is asked for, says so, and is saved with its noise in a layer', async () => {
  const checksum = () =>
    page.page.evaluate<number>(
      'irradia.viewport.tracing.texture.image.data.reduce((sum, half) => (31 * sum + half) | 0, 0)',
    );
  await mode('Path traced').click();
  await complete(1);
  const noisy = await checksum();
  await page.page.getByRole('button', { name: 'Denoise' }).click();
  await page.page
    .locator('.tracing-text')
    .getByText(/complete · denoised$/)
    .waitFor();
  expect(await checksum()).not.toBe(noisy);
  expect(await meanDifference()).toBeLessThan(1);
  const { channels, attributes } = await saveExr();
  expect(channels.map(({ name }) => name)).toEqual(['B', 'G', 'R', 'noisy.B', 'noisy.G', 'noisy.R']);
  expect(attributes).toMatchObject({ 'irradia:samples': '0:16', 'irradia:denoised': 'yes' });
  await page.page.getByRole('button', { name: 'Denoise' }).click();
  await page.page
    .locator('.tracing-text')
    .getByText(/complete$/)
    .waitFor();
  expect(await checksum()).toBe(noisy);
});

it('says what is wrong with a scene, keeps the interactive view, and recovers', async () => {
  await mode('Path traced').click();
  await complete(1);
  const { renderings } = await counts();
  await page.page.evaluate(`irradia.store.edit('Break', (draft) => {
    draft.assets.broken = { name: 'broken.png', mediaType: 'image/png', data: 'AAAA' };
    const [id] = Object.keys(draft.materials);
    draft.materials[id].emissiveMap = {
      scale: 1,
      asset: 'broken', texture: null, channel: null, colorSpace: 'srgb', repeat: [1, 1], offset: [0, 0], rotation: 0,
      wrap: 'repeat', uv: 0,
    };
  })`);
  await page.page.locator('.tracing-text.error').getByText('broken.png').waitFor();
  await page.page.evaluate('irradia.store.undo()');
  await complete(renderings + 2);
  // What the page itself says of the broken image.
  expect(page.errors).toEqual([]);
});

it('is shown by WebGL 2, too', async () => {
  await page.page.close();
  const old = await openSphere("Object.defineProperty(navigator, 'gpu', { value: undefined });");
  await old.page.keyboard.press('2');
  await complete(1, old);
  expect(await meanDifference(old)).toBeLessThan(1);
  expect(old.errors).toEqual([]);
});
