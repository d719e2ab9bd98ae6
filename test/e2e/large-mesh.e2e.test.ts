/** 100,000 triangles: what a hand does with them is found out in threads, and is right. */
import { expect, it } from 'vitest';
import type { Document } from '../../src/scene/schema.ts';
import { wavyGlb } from './glb.ts';
import { openLab } from './lab.ts';
import { outlinedOn, outlinePixels } from './outline-pixels.ts';

const lab = await openLab();

/** A floor, at a resolution that the software GPU draws at once. */
const scene = JSON.stringify({
  format: 'irradia',
  version: 1,
  name: 'Large',
  camera: { position: [0, 2, 6], target: [0, 1, 0] },
  materials: { clay: { name: 'Clay', model: 'lambert' } },
  lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 3] } },
  objects: {
    floor: {
      name: 'Floor',
      material: 'clay',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 8, height: 8 },
    },
  },
  view: { resolutionScale: 0.1 },
});

/** Notes each worker that is started, by the name of its script. */
const COUNT_WORKERS = `
  window.started = [];
  window.Worker = class extends Worker {
    constructor(url, options) {
      super(url, options);
      window.started.push(String(url).replace(/.*\\//, '').replace(/-.*/, ''));
    }
  };`;

it('a large mesh is outlined, picked, boxed in, dropped, undone, kept', async () => {
  const page = await (
    await lab.open({
      query: '?scene=/large.json',
      files: { '/large.json': scene },
      init: COUNT_WORKERS,
    })
  ).ready();
  const { page: browser } = page;
  await page.drop([{ name: 'wavy.glb', content: wavyGlb(100_000) }]);
  await page.until('Object.keys(irradia.store.document.objects).length === 2');
  const [, wavy = ''] = Object.keys((await page.document()).objects);
  const place = async (): Promise<number> => ((await page.document()) as Document).objects[wavy]!.position[1];
  const selected = () => browser.locator('.outliner-row.selected[data-entity]').allInnerTexts();
  await page.until(`irradia.mirror.objectFor('${wavy}').geometry.index.count > 290_000`);

  const box = (await browser.locator('.viewport canvas').first().boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await browser.keyboard.press('q');
  await browser.keyboard.press('Escape');
  expect(await selected()).toEqual([]);
  await expect.poll(() => outlinedOn(page)).toBe(0);
  await browser.mouse.click(x, y);
  await expect.poll(selected).toEqual(['Wavy']);
  await expect.poll(() => outlinedOn(page)).toBeGreaterThan(300);
  // Not in what is saved, and on the screen still.
  const saved = await browser.evaluate<string>(`(async () => {
    const bytes = new Uint8Array(await (await irradia.viewport.screenshot()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  })()`);
  expect(await outlinePixels(Buffer.from(saved, 'base64'))).toBe(0);
  expect(await outlinedOn(page)).toBeGreaterThan(300);

  await browser.keyboard.down('Shift');
  await browser.mouse.move(x + 30, y + 30);
  await browser.mouse.down();
  await browser.mouse.move(x - 30, y - 30, { steps: 3 });
  await browser.mouse.up();
  await browser.keyboard.up('Shift');
  // The floor, too, is there.
  await expect.poll(selected).toEqual(['Floor', 'Wavy']);

  // Its lowest point, of 0.9 + 0.1 sin 7 theta cos 9 phi about y = 1, is above the floor; what the copy falls onto is below it.
  await page.select('objects', wavy);
  await browser.focus('.viewport canvas');
  await browser.keyboard.press('End');
  await expect.poll(place).toBeLessThan(0);
  const lowest = Number(
    await browser.evaluate(`(() => {
      const { array } = irradia.mirror.objectFor('${wavy}').geometry.getAttribute('position');
      let low = Infinity;
      for (let i = 1; i < array.length; i += 3) low = Math.min(low, array[i]);
      return low;
    })()`),
  );
  expect(await place()).toBeCloseTo(-lowest, 3);
  await browser.keyboard.press('Control+z');
  expect(await place()).toBe(0);

  // What changes while it is looked for is looked at again.
  await browser.evaluate(`(() => {
    dispatchEvent(new KeyboardEvent('keydown', { key: 'End', code: 'End' }));
    irradia.store.edit('Raise', (draft) => { draft.objects['${wavy}'].position = [1, 2, 0]; });
  })()`);
  await expect.poll(place).toBeCloseTo(-lowest, 3);
  expect((await page.document()).objects[wavy]?.position[0]).toBe(1);

  await browser.waitForSelector('.document-button[data-keep=kept]');
  expect(await browser.evaluate('[...new Set(started)].sort().join()')).toContain('mesh');
  expect(page.errors).toEqual([]);
  await browser.context().close();
});
