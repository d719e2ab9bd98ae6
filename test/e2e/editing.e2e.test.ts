/** A person edits a scene. */
import { readFile } from 'node:fs/promises';
import { beforeAll, describe, expect, it } from 'vitest';
import { encodePng } from '../../src/io/png.ts';
import { addableGeometries, geometryNames } from '../../src/scene/geometry-schema.ts';
import { lightDefaults, lightTypes } from '../../src/scene/light-schema.ts';
import { type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
let page: LabPage;

/** A ball and a box under a lamp. */
const scene = small({
  camera: { position: [0, 1, 4], target: [0, 0, 0] },
  lights: {
    ambient: { type: 'ambient' },
    lamp: { type: 'point', name: 'Lamp', position: [2, 2, 2], intensity: 20 },
  },
  materials: {
    gloss: { name: 'Gloss', model: 'principled', parameters: { roughness: 0.3 } },
    clay: { name: 'Clay', model: 'lambert' },
  },
  objects: {
    box: { name: 'Box', material: 'clay', position: [1.5, 0, -1], geometry: { type: 'box' } },
    ball: { name: 'Ball', material: 'gloss', geometry: { type: 'sphere', radius: 0.8 } },
  },
});

beforeAll(async () => {
  page = await (await lab.open(scene)).ready();
});

/** Black and white squares. */
function checkerPng(): Uint8Array {
  const size = 16;
  const pixels = new Uint8Array(size * size * 4).fill(255);
  for (let i = 0; i < size * size; i++) {
    if (((i >> 2) + (i >> 6)) % 2 === 0) pixels.fill(0, 4 * i, 4 * i + 3);
  }
  return encodePng(pixels, size, size);
}

/** The first object of the scene that has the principled model, selected. */
async function selectPrincipled(): Promise<void> {
  const { objects, materials } = await page.document();
  const found = Object.entries(objects).find(
    ([, object]) => materials[object.material]?.model === 'principled',
  );
  await page.select('objects', found?.[0] ?? '');
}

describe('the default scene', () => {
  let page: LabPage;
  beforeAll(async () => {
    page = await (await lab.open()).ready();
    return () => page.page.close();
  });

  it('is not blank and reports no error', async () => {
    const { colors } = await page.picture();
    expect(colors).toBeGreaterThan(100);
    expect(page.errors).toEqual([]);
    expect(await page.toasts()).toEqual([]);
  });

  it('has the lights of the thesis: one ambient, two directional, one point, one spot', async () => {
    const types = Object.values((await page.document()).lights).map((light) => light.type);
    expect(types.sort()).toEqual(['ambient', 'directional', 'directional', 'point', 'spot']);
  });

  it('shows its figures', async () => {
    const text = await page.page.locator('.status').textContent();
    for (const figure of ['Resolution', 'Vertices', 'Triangles', 'Draw calls', 'WebGPU', 'p95']) {
      expect(text).toContain(figure);
    }
  });

  it('folds its frame time graph away, and out again', async () => {
    const [fold, graph] = [page.page.getByLabel('Frame time graph'), page.page.locator('.timing')];
    await fold.click();
    await graph.waitFor({ state: 'hidden' });
    await fold.click();
    await graph.waitFor({ state: 'visible' });
  });
});

describe('a slider', () => {
  it('changes the picture when it is dragged, and one undo brings the picture back', async () => {
    await selectPrincipled();
    const before = await page.picture();
    await page.dragSlider('[data-parameter=roughness]', 0.95);
    const dragged = await page.picture();
    expect(dragged.hash).not.toBe(before.hash);
    await page.page.keyboard.press('Control+z');
    expect((await page.picture()).hash).toBe(before.hash);
    await page.page.keyboard.press('Control+Shift+z');
    expect((await page.picture()).hash).toBe(dragged.hash);
    await page.page.keyboard.press('Control+y');
    await page.page.keyboard.press('Control+z');
    expect((await page.picture()).hash).toBe(before.hash);
  });

  it('takes a typed number beyond its range, and a double click on the label resets it', async () => {
    await selectPrincipled();
    const input = page.page.locator('[data-parameter=roughness] .number input');
    await input.click();
    await input.fill('3/2');
    await input.press('Enter');
    const material = () =>
      page.page.evaluate<number | undefined>(`(() => {
        const { objects, materials } = irradia.store.document;
        const row = document.querySelector('.outliner-row.selected').dataset.entity.split('/')[1];
        return materials[objects[row].material].parameters.roughness;
      })()`);
    expect(await material()).toBe(1.5);
    await page.page.dblclick('[data-parameter=roughness] .row-label');
    expect(await material()).toBeUndefined();
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
  });

  it('keeps shortcuts out of what is typed', async () => {
    await selectPrincipled();
    const before = Object.keys((await page.document()).objects);
    const input = page.page.locator('.inspector-header input');
    await input.click();
    await input.press('Delete');
    await input.press('f');
    await input.press('Escape');
    expect(Object.keys((await page.document()).objects)).toEqual(before);
  });
});

describe('adding and deleting', () => {
  // One sphere: every light type is a new program for every material, and the GPU is made of software.
  let page: LabPage;
  beforeAll(async () => {
    const materials = { clay: { name: 'Clay', model: 'lambert' } };
    const objects = { ball: { name: 'Ball', material: 'clay', geometry: { type: 'sphere' } } };
    page = await (await lab.open(small({ materials, objects }))).ready();
    return () => page.page.close();
  });

  it.each(addableGeometries)('a %s', async (type) => {
    const before = await page.document();
    await page.menu('Add', geometryNames[type]);
    const after = await page.document();
    const added = Object.keys(after.objects).filter((id) => !(id in before.objects));
    expect(added).toHaveLength(1);
    expect(after.objects[added[0] ?? '']?.geometry.type).toBe(type);
    await page.page.keyboard.press('Delete');
    expect(Object.keys((await page.document()).objects)).toEqual(Object.keys(before.objects));
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
  });

  it.each(lightTypes)('a %s light', async (type) => {
    const before = await page.document();
    await page.menu('Add', lightDefaults[type].name);
    const after = await page.document();
    const added = Object.keys(after.lights).filter((id) => !(id in before.lights));
    expect(added).toHaveLength(1);
    expect(after.lights[added[0] ?? '']?.type).toBe(type);
    await page.picture();
    await page.page.keyboard.press('Delete');
    expect(await page.document()).toEqual(before);
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
  });
});

describe('the outliner', () => {
  it('renames with F2, hides with the eye, duplicates with Ctrl+D', async () => {
    const [id = ''] = Object.keys((await page.document()).objects);
    await page.select('objects', id);
    await page.page.keyboard.press('F2');
    await page.page.keyboard.type('Renamed');
    await page.page.keyboard.press('Enter');
    expect((await page.document()).objects[id]?.name).toBe('Renamed');
    await page.page.hover(`[data-entity="objects/${id}"]`);
    await page.page.click(`[data-entity="objects/${id}"] .eye`);
    expect((await page.document()).objects[id]?.visible).toBe(false);
    const count = Object.keys((await page.document()).objects).length;
    await page.page.keyboard.press('Control+d');
    expect(Object.keys((await page.document()).objects)).toHaveLength(count + 1);
    for (let i = 0; i < 3; i++) await page.page.keyboard.press('Control+z');
    expect((await page.document()).objects[id]?.name).not.toBe('Renamed');
  });
});

describe('the viewport', () => {
  it('selects the object that is clicked, and nothing where there is none', async () => {
    const at = await page.page.evaluate<{ id: string; x: number; y: number } | null>(`(() => {
      const { mirror, store } = irradia;
      const canvas = document.querySelector('.viewport canvas').getBoundingClientRect();
      for (const id of Object.keys(store.document.objects)) {
        const object = mirror.objectFor(id);
        const place = object.getWorldPosition(object.position.clone()).project(mirror.camera);
        if (store.document.objects[id].geometry.type === 'sphere')
          return { id, x: canvas.left + ((place.x + 1) / 2) * canvas.width, y: canvas.top + ((1 - place.y) / 2) * canvas.height };
      }
      return null;
    })()`);
    if (!at) throw new Error('the default scene has no sphere');
    await page.page.keyboard.press('Escape');
    await page.page.mouse.click(at.x, at.y);
    const selected = () => page.page.locator('.outliner-row.selected').getAttribute('data-entity');
    await expect.poll(selected).toBe(`objects/${at.id}`);
    await page.page.keyboard.press('Escape');
    expect(await page.page.locator('.outliner-row.selected').textContent()).toBe('Scene');
  });

  it('writes the camera to the document once a drag ends, as one undo step', async () => {
    const before = await page.document();
    const box = await page.page.locator('.viewport').boundingBox();
    if (!box) throw new Error('no viewport');
    await page.page.mouse.move(box.x + 60, box.y + 60);
    await page.page.mouse.down();
    await page.page.mouse.move(box.x + 100, box.y + 70);
    await page.page.mouse.move(box.x + 160, box.y + 80);
    expect((await page.document()).camera).toEqual(before.camera);
    await page.page.mouse.up();
    expect((await page.document()).camera).not.toEqual(before.camera);
    await page.page.keyboard.press('Control+z');
    expect((await page.document()).camera).toEqual(before.camera);
  });
});

describe('a texture', () => {
  it('goes on a parameter by drop, shows in the picture, and comes off again', async () => {
    await selectPrincipled();
    const before = await page.document();
    const picture = await page.picture();
    await page.drop(
      [{ name: 'dots.png', content: checkerPng() }],
      '[data-parameter=baseColor] .texture-slot',
    );
    await page.page.waitForSelector('[data-parameter=baseColor] .texture-slot img');
    expect((await page.picture()).hash).not.toBe(picture.hash);
    await page.page.click('[data-parameter=baseColor] .texture-slot');
    await page.page.click('.texture-popup >> text=Remove');
    expect((await page.picture()).hash).toBe(picture.hash);
    await page.page.keyboard.press('Control+z');
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
  });

  it('that is no image is refused with a message', async () => {
    const before = await page.document();
    await page.drop([{ name: 'fake.png', content: 'not a png' }], '[data-parameter=baseColor] .texture-slot');
    await page.waitForToast('fake.png');
    expect(await page.document()).toEqual(before);
    await page.page.click('.toast .icon-button');
  });
});

describe('the units of a light', () => {
  it('are another way to read and type the same value', async () => {
    const point = Object.entries((await page.document()).lights).find(([, light]) => light.type === 'point');
    await page.select('lights', point?.[0] ?? '');
    const intensity = async () => {
      const light = (await page.document()).lights[point?.[0] ?? ''];
      return light?.type === 'point' ? light.intensity : Number.NaN;
    };
    const before = await intensity();
    await page.page.selectOption('.with-unit select', 'lm');
    const input = page.inspector().locator('.with-unit .number input');
    expect(Number(await input.inputValue())).toBeCloseTo(4 * Math.PI * before, 1);
    await input.click();
    await input.fill('1000');
    await input.press('Enter');
    expect(await intensity()).toBeCloseTo(1000 / (4 * Math.PI), 6);
    await page.page.keyboard.press('Control+z');
    expect(await intensity()).toBe(before);
    await page.page.selectOption('.with-unit select', 'cd');
  });
});

describe('saving', () => {
  it('gives a file that opens as the same document after a reload', async () => {
    await page.menu('Add', 'Torus');
    const saved = await page.document();
    const download = page.page.waitForEvent('download');
    await page.page.keyboard.press('Control+s');
    const text = await readFile(await (await download).path(), 'utf8');

    const fresh = await (await lab.open(small())).ready();
    expect(await fresh.document()).not.toEqual(saved);
    await fresh.drop([{ name: 'saved.json', content: text }]);
    await fresh.waitForToast('Opened');
    expect(await fresh.document()).toEqual(saved);
    expect((await fresh.picture()).hash).toBe((await page.picture()).hash);
    expect([...page.errors, ...fresh.errors]).toEqual([]);
  });
});
