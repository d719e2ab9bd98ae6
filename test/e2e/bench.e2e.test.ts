/** The bench under the viewport, used with the keyboard and the mouse. */
import { readFile } from 'node:fs/promises';
import { beforeAll, describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { lightSliceAt } from '../../src/analysis/plots/light-slice.ts';
import { viewerSliceAt } from '../../src/analysis/plots/viewer-slice.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
let page: LabPage;

const tooBright = `analytic
# Lambert, and up to twice as much light as comes in
::begin parameters
float gain 0 2 1
float shade 0 .9 0
float haze 0 1 0
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    float glow = haze * dot(N, L) * dot(N, V);
    return vec3(gain * (1.0 - shade) / 3.14159265358979 + .001 * glow);
}
::end shader
`;

const scene = {
  format: 'irradia',
  version: 1,
  materials: {
    gloss: { name: 'Gloss', model: 'cook-torrance', parameters: { roughness: 0.4 } },
    bright: { name: 'Bright', model: 'too bright' },
  },
  models: { 'too bright': { source: tooBright } },
  lights: { sun: { type: 'directional', name: 'Sun', position: [0, 4, 0], target: [0, 0, 0] } },
  objects: { ball: { name: 'Ball', material: 'gloss', geometry: { type: 'sphere' } } },
  // Little work for the software GPU, which is not what is looked at here.
  view: { resolutionScale: 0.25 },
};

beforeAll(async () => {
  page = await lab.open({
    query: '?scene=/scene.json',
    files: { '/scene.json': JSON.stringify(scene) },
    width: 1000,
    height: 700,
  });
  await page.ready();
  await page.select('materials', 'gloss');
});

/** The plot's pixels, after the next frame. */
const plot = () =>
  page.page.evaluate<string>(`new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() =>
    resolve(document.querySelector('.bench-plot').toDataURL()))))`);

async function exported(kind: 'SVG' | 'PNG' | 'CSV'): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.page.waitForEvent('download');
  await page.page.click('.bench-bar >> text="Export"');
  await page.page.click(`.menu button >> text="${kind}"`);
  const file = await waiting;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

async function table(): Promise<{ head: string[]; rows: number[][] }> {
  const [head = '', ...rows] = (await exported('CSV')).bytes.toString().trim().split('\n');
  return { head: head.split(','), rows: rows.map((row) => row.split(',').map(Number)) };
}

describe('the bench', () => {
  it('opens and closes by its key and its button', async () => {
    const dock = page.page.locator('.bench');
    expect(await dock.isVisible()).toBe(false);
    await page.page.keyboard.press('b');
    expect(await dock.isVisible()).toBe(true);
    await page.page.click('[aria-label="BRDF bench"].icon-button');
    expect(await dock.isVisible()).toBe(false);
    await page.page.keyboard.press('b');
    expect(await dock.isVisible()).toBe(true);
  });

  it('follows a slider of the material', async () => {
    const before = await plot();
    await page.dragSlider('[data-parameter=roughness]', 0.15);
    expect(await plot()).not.toBe(before);
  });

  it('turns the viewer when the plot is dragged, and with the arrow keys', async () => {
    const box = await page.page.locator('.bench-plot').boundingBox();
    if (!box) throw new Error('no plot');
    const radius = Math.min(box.height - 58, box.width / 2 - 40);
    const surface = box.y + box.height - 30 - (box.height - 58 - radius) / 2;
    await page.page.mouse.move(box.x + box.width / 2 - 60, surface - 60);
    await page.page.mouse.down();
    await page.page.mouse.move(box.x + box.width / 2 - 60, surface - 40);
    await page.page.mouse.up();
    const angle = () => page.page.inputValue('[data-bench=thetaV] .number input');
    await plot();
    const dragged = Number(await angle());
    expect(dragged).toBeGreaterThan(50);
    expect(dragged).toBeLessThan(60);
    await page.page.focus('.bench-plot');
    await page.page.keyboard.press('ArrowLeft');
    await plot();
    expect(Number(await angle())).toBeCloseTo(dragged - 1, 6);
  });

  it('keeps a pinned curve while the material changes, solo draws one alone, and a pin goes away', async () => {
    await page.page.click('.bench >> text="Pin"');
    await page.dragSlider('[data-parameter=roughness]', 0.9);
    const both = await plot();
    const pinned = await table();
    expect(pinned.head).toHaveLength(9);
    expect(pinned.rows.some((row) => Math.abs((row[1] ?? 0) - (row[5] ?? 0)) > 0.01)).toBe(true);
    await page.page.click('[aria-label="Solo Gloss 1"]');
    expect(await plot()).not.toBe(both);
    expect((await table()).head).toHaveLength(5);
    await page.page.click('[aria-label="Solo Gloss 1"]');
    expect((await table()).head).toHaveLength(9);
    await page.page.click('[aria-label="Remove Gloss 1"]');
    expect((await table()).head).toHaveLength(5);
  });

  it('exports the numbers of the evaluator', async () => {
    const { head, rows } = await table();
    expect(head.slice(0, 2)).toEqual(['theta_l_deg', '"Gloss red"']);
    const { parameters } = (await page.document()).materials.gloss ?? {};
    const evaluator = createEvaluator(shippedModels.get('cook-torrance') as Model, parameters);
    const thetaV = Number(await page.page.inputValue('[data-bench=thetaV] .number input'));
    const options = { thetaV, phiV: 0, cosine: false };
    expect(rows.length).toBeGreaterThan(180);
    for (const [angle = 0, ...values] of rows) {
      const { rgb } = lightSliceAt((l, v) => evaluator.f(l, v), angle, options);
      for (const c of [0, 1, 2] as const) expect(values[c]).toBeCloseTo(rgb[c], 9);
    }
  });

  it('moves the viewer instead, and the light by a drag', async () => {
    const before = await plot();
    await page.page.selectOption('[aria-label="What moves"]', 'viewer');
    expect(await plot()).not.toBe(before);
    await page.page.focus('.bench-plot');
    await page.page.keyboard.press('ArrowRight');
    await plot();
    expect(Number(await page.page.inputValue('[data-bench=thetaL] .number input'))).toBe(21);
    const { head, rows } = await table();
    expect(head[0]).toBe('theta_v_deg');
    const { parameters } = (await page.document()).materials.gloss ?? {};
    const evaluator = createEvaluator(shippedModels.get('cook-torrance') as Model, parameters);
    const options = { thetaL: 21, phiL: 180, cosine: false };
    for (const [angle = 0, red] of rows)
      expect(red).toBeCloseTo(viewerSliceAt((l, v) => evaluator.f(l, v), angle, options).rgb[0], 9);
    await page.page.selectOption('[aria-label="What moves"]', 'light');
  });

  it('exports a drawing and a picture', async () => {
    const svg = await exported('SVG');
    expect(svg.name).toBe('Gloss-polar.svg');
    expect(svg.bytes.toString()).toMatch(/^<svg [\s\S]*<polyline [\s\S]*<\/svg>\n$/);
    const png = await exported('PNG');
    expect([...png.bytes.subarray(1, 4)]).toEqual([...Buffer.from('PNG')]);
  });

  it('shows the values under the pointer', async () => {
    await page.page.click('[data-view=thetaL]');
    const box = await page.page.locator('.bench-plot').boundingBox();
    if (!box) throw new Error('no plot');
    await page.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await plot();
    expect(await page.page.textContent('.bench-where')).toMatch(/^θl −?\d+\.\d°$/);
    expect(Number(await page.page.textContent('.bench-value'))).toBeGreaterThan(0);
  });

  it.each(['thetaL', 'thetaH', 'thetaD'])('draws %s', async (view) => {
    await page.page.click('[data-view=polar]');
    const before = await plot();
    await page.page.click(`[data-view=${view}]`);
    expect(await plot()).not.toBe(before);
    expect((await table()).rows.length).toBeGreaterThan(150);
  });

  it('computes the albedo in a worker', async () => {
    await page.page.click('[data-view=albedo]');
    await plot();
    await page.page.waitForSelector('.bench-progress', { state: 'hidden' });
    const { rows } = await table();
    // Others make the pictures of the scene's materials, and what is kept of the document.
    const workers = page.page.workers().filter((worker) => worker.url().includes('/worker-'));
    expect(workers).toHaveLength(1);
    expect(rows).toHaveLength(31);
    for (const [, red = 0] of rows) {
      expect(red).toBeGreaterThan(0);
      expect(red).toBeLessThan(1.001);
    }
  });

  it('computes the image slice', async () => {
    await page.page.click('[data-view=image]');
    await plot();
    await page.page.waitForSelector('.bench-progress', { state: 'hidden' });
    expect((await table()).rows).toHaveLength(128 ** 2);
    expect((await exported('SVG')).bytes.toString()).toContain('data:image/png;base64,');
  });

  describe('the views over two angles', () => {
    const settle = async () => {
      await plot();
      await page.page.waitForSelector('.bench-progress', { state: 'hidden' });
      await plot();
    };
    const roughness = async (value: string) => {
      await page.page.fill('[data-parameter=roughness] .number input', value);
      await page.page.keyboard.press('Enter');
    };

    it.each([
      ['lobe', 'theta_l_deg,phi_l_deg', '<polygon'],
      ['phi', 'phi_l_deg', '<polyline'],
      ['azimuth', 'phi_l_deg', '<polyline'],
      ['sweep', 'roughness,theta_v_deg', '<polyline'],
      ['map', 'phi_l_deg,theta_l_deg', '<image'],
      ['sphere', 'x,y', '<image'],
      ['object', 'x,y', '<image'],
    ])('%s draws, follows a slider, and exports', async (view, head, mark) => {
      await roughness('0.5');
      await page.page.click(`[data-view=${view}]`);
      await settle();
      const before = await plot();
      await roughness('0.2');
      await settle();
      expect(await plot()).not.toBe(before);
      const data = await table();
      expect(data.head.join()).toMatch(new RegExp(`^${head},"Gloss red"`));
      expect(data.rows.length).toBeGreaterThan(50);
      expect((await exported('SVG')).bytes.toString()).toContain(mark);
    });

    it('shows the Fresnel reflectance of a substance beside Schlick', async () => {
      await page.page.click('[data-view=fresnel]');
      const gold = await plot();
      await page.page.selectOption('[aria-label="Substance in the plot"]', 'water');
      expect(await plot()).not.toBe(gold);
      const { head, rows } = await table();
      expect(head.join()).toMatch(/^theta_i_deg,"Water at 20 degrees, exact red"/);
      // ((n - 1)/(n + 1))^2 with n = 1.333
      expect(rows[0]?.[1]).toBeCloseTo(0.02, 3);
      expect(rows.at(-1)?.[1]).toBeCloseTo(1, 6);
    });

    it('turns the lobe with the keys and with the mouse, and moves l by its handle', async () => {
      await page.page.click('[data-view=lobe]');
      await settle();
      const pictures = [await plot()];
      await page.page.focus('.bench-plot');
      await page.page.keyboard.press('ArrowRight');
      pictures.push(await plot());
      const box = await page.page.locator('.bench-plot').boundingBox();
      if (!box) throw new Error('no plot');
      await page.page.mouse.move(box.x + 12, box.y + box.height - 12);
      await page.page.mouse.down();
      await page.page.mouse.move(box.x + 50, box.y + box.height - 12);
      await page.page.mouse.up();
      pictures.push(await plot());
      expect(new Set(pictures).size).toBe(3);

      await page.page.click('[data-view=sphere]');
      await settle();
      const angle = () => page.page.inputValue('[data-bench=thetaL] .number input');
      const first = await angle();
      await page.page.focus('.bench-plot');
      await page.page.keyboard.press('ArrowUp');
      await plot();
      expect(Number(await angle())).toBe(Number(first) + 1);
    });

    it('keeps l and the light of the scene in step, as one undo step', async () => {
      const light = async () => {
        const [first] = Object.values((await page.document()).lights);
        return first?.type === 'directional' ? first : undefined;
      };
      const before = await light();
      await page.page.click('[data-bench=light] .switch');
      await plot();
      // The light of the scene stands in the zenith: l goes there.
      expect(Number(await page.page.inputValue('[data-bench=thetaL] .number input'))).toBe(0);
      await page.page.focus('.bench-plot');
      for (let i = 0; i < 3; i++) await page.page.keyboard.press('Shift+ArrowUp');
      await plot();
      const [x = 0, y = 0] = (await light())?.position ?? [];
      expect(Math.atan2(Math.abs(x), y) * (180 / Math.PI)).toBeCloseTo(30, 6);
      // Alt and a drag over the viewport: 50 pixels down are 15 degrees.
      const { camera } = await page.document();
      const box = (await page.page.locator('.viewport canvas').first().boundingBox()) ?? { x: 0, y: 0 };
      await page.page.keyboard.down('Alt');
      await page.page.mouse.move(box.x + 60, box.y + 100);
      await page.page.mouse.down();
      await page.page.mouse.move(box.x + 60, box.y + 150);
      await page.page.mouse.up();
      await page.page.keyboard.up('Alt');
      await plot();
      expect(Number(await page.page.inputValue('[data-bench=thetaL] .number input'))).toBe(45);
      const [x2 = 0, y2 = 0] = (await light())?.position ?? [];
      expect(Math.atan2(Math.abs(x2), y2) * (180 / Math.PI)).toBeCloseTo(45, 6);
      expect((await page.document()).camera).toEqual(camera);
      await page.page.click('[data-bench=light] .switch');
      await page.page.keyboard.press('Control+z');
      expect(await light()).toEqual(before);
    });

    it('fills the page with six views by its key, each of its own choice', async () => {
      await page.page.keyboard.press('Shift+B');
      await settle();
      expect(await page.page.locator('.bench-plot').count()).toBe(6);
      await page.page.selectOption('[aria-label="View 1"]', 'polar');
      await page.page.selectOption('[aria-label="View 2"]', 'thetaD');
      await settle();
      const drawn = await page.page.evaluate<string[]>(
        `[...document.querySelectorAll('.bench-plot')].map((canvas) => canvas.toDataURL())`,
      );
      expect(new Set(drawn).size).toBe(6);
      expect((await exported('CSV')).name).toBe('Gloss-thetaD.csv');
      await page.page.keyboard.press('Shift+B');
      await plot();
      expect(await page.page.locator('.bench-plot').count()).toBe(1);
    });
  });

  it('says where a model breaks physics, and shows it', async () => {
    await page.select('materials', 'bright');
    await page.page.click('[data-view=verdict]');
    const energy = page.page.locator('.verdict-list [data-property=energy]');
    await energy.waitFor();
    expect(await energy.getAttribute('data-outcome')).toBe('fail');
    expect(await energy.innerText()).toContain('albedo up to 2');
    const gpu = page.page.locator('.verdict-list [data-property=gpu]');
    expect(await gpu.getAttribute('data-outcome')).toBe('pass');
    const figure = await gpu.locator('.verdict-figure').innerText();
    expect(figure).toMatch(/^differs by \d/);
    expect(Number(figure.replace('differs by ', ''))).toBeLessThan(1e-4);
    await page.page.click('[aria-label="Show the worst case of Conserves energy"]');
    const { parameters } = (await page.document()).materials.bright ?? {};
    expect(parameters).toMatchObject({ gain: 2, shade: 0 });
    await page.page.waitForSelector('[data-view=lobe][aria-selected=true]');
    await page.page.keyboard.press('Control+z');
    expect((await page.document()).materials.bright?.parameters).toEqual({});
  });

  it('maps a law over two parameters: a cell is read and put on the material', async () => {
    await page.page.click('[data-view=verdict]');
    const picture = page.page.locator('.heat-map-picture');
    await picture.waitFor();
    const reading = page.page.locator('.heat-map-reading');
    expect(await reading.innerText()).toMatch(/^Worst: largest albedo/);
    await page.page.selectOption('[aria-label="Parameter to the right"]', 'haze');
    await page.page.selectOption('[aria-label="Parameter upwards"]', 'shade');
    await page.until(`/haze.*shade/.test(document.querySelector('.heat-map-reading')?.textContent ?? '')`);
    // What was read may be of a map that is made once more.
    await page.page.locator('.heat-map progress').waitFor({ state: 'hidden' });
    const { width, height } = (await picture.boundingBox()) ?? { width: 0, height: 0 };
    // The right edge and the bottom: the most of the first, the least of the other.
    const position = { x: width - 3, y: height - 3 };
    await picture.hover({ position });
    expect(await reading.innerText()).toMatch(/^largest albedo 1(\.0\d*)? at haze 1, shade 0$/);
    const before = (await page.document()).materials.bright?.parameters;
    await picture.click({ position });
    expect((await page.document()).materials.bright?.parameters).toMatchObject({ haze: 1, shade: 0 });
    await page.page.keyboard.press('Control+z');
    expect((await page.document()).materials.bright?.parameters).toEqual(before);
  });

  it('reported no error', async () => {
    expect(page.errors).toEqual([]);
    expect(await page.toasts()).toEqual([]);
  });
});
