/** "Fit to...": a material is fitted to another one, in the page. */
import { beforeAll, describe, expect, it } from 'vitest';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
let page: LabPage;

const scene = {
  format: 'irradia',
  version: 1,
  materials: {
    truth: {
      name: 'Truth',
      model: 'cook-torrance',
      parameters: { albedo: [0.7, 0.3, 0.1], roughness: 0.25, kd: 0.6, metallic: 0.3 },
    },
    mine: { name: 'Mine', model: 'lambert', parameters: {} },
  },
  lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 3], target: [0, 0, 0] } },
  objects: {
    ball: { name: 'Ball', material: 'mine', geometry: { type: 'sphere' } },
    other: { name: 'Other', material: 'truth', geometry: { type: 'sphere' }, position: [2.5, 0, 0] },
  },
};

beforeAll(async () => {
  page = await lab.open({
    query: '?scene=/scene.json',
    files: { '/scene.json': JSON.stringify(scene) },
    width: 1200,
    height: 800,
  });
  await page.ready();
  await page.select('materials', 'mine');
});

describe('fitting a material', () => {
  it('can be cancelled, and changes nothing then', async () => {
    await page.page.getByRole('button', { name: 'Fit to…' }).click();
    const panel = page.page.getByRole('region', { name: 'Fit Mine' });
    expect(await panel.getByLabel('Target').inputValue()).toBe('material truth');
    expect(await panel.getByLabel('Model that is fitted').inputValue()).toBe('lambert');
    await panel.getByLabel('Model that is fitted').selectOption('principled');
    // A thread that never answers: one that does may be done before it is cancelled.
    await page.page.evaluate(
      'window.AnsweringWorker = Worker; window.Worker = class extends Worker { postMessage() {} };',
    );
    await panel.getByRole('button', { name: 'Fit', exact: true }).click();
    await panel.getByRole('progressbar').waitFor();
    await panel.getByRole('button', { name: 'Cancel' }).click();
    await panel.getByRole('button', { name: 'Fit', exact: true }).waitFor();
    await page.page.evaluate('window.Worker = AnsweringWorker');
    expect((await page.document()).materials.mine?.model).toBe('lambert');
  });

  it('puts what was found into the material as one step, with the target pinned beside it', async () => {
    const panel = page.page.getByRole('region', { name: 'Fit Mine' });
    await panel.getByLabel('Model that is fitted').selectOption('cook-torrance');
    await panel.getByRole('button', { name: 'Fit', exact: true }).click();
    await panel.getByRole('button', { name: 'Copy as code' }).waitFor({ timeout: 120_000 });
    const { mine, truth } = (await page.document()).materials;
    expect(mine?.model).toBe('cook-torrance');
    for (const name of ['roughness', 'kd', 'metallic'])
      expect(mine?.parameters[name]).toBeCloseTo(truth?.parameters[name] as number, 3);
    expect(await panel.getByRole('img').count()).toBe(2);
    expect(await panel.innerText()).toMatch(/Pictures differ by less than 0.01 \(the defaults by \d+\)/);
    await page.page.getByRole('region', { name: 'BRDF bench' }).getByText('Truth').first().waitFor();
    await page.page.keyboard.press('Escape');
    expect(await panel.count()).toBe(0);
    await page.page.keyboard.press('Control+z');
    expect((await page.document()).materials.mine).toMatchObject({ model: 'lambert', parameters: {} });
  });
});
