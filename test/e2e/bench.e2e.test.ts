/** The bench under the viewport, used with the keyboard and the mouse. */
import { readFile } from 'node:fs/promises';
import { beforeAll, describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { lightSliceAt } from '../../src/analysis/plots/light-slice.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
let page: LabPage;

const scene = {
  format: 'irradia',
  version: 1,
  materials: { gloss: { name: 'Gloss', model: 'cook-torrance', parameters: { roughness: 0.4 } } },
  objects: { ball: { name: 'Ball', material: 'gloss', geometry: { type: 'sphere' } } },
};

beforeAll(async () => {
  page = await lab.open({
    query: '?scene=/scene.json',
    files: { '/scene.json': JSON.stringify(scene) },
    width: 1100,
    height: 760,
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
    expect(page.page.workers()).toHaveLength(1);
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

  it('reported no error', async () => {
    expect(page.errors).toEqual([]);
    expect(await page.toasts()).toEqual([]);
  });
});
