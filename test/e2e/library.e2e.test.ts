import { expect, test } from 'vitest';
import { materialLibrary } from '../../src/analysis/library/library.ts';
import { openLab, small } from './lab.ts';

const lab = await openLab();

/** What the canvas shows, as sums over the left and the right half, away from the divider. */
const HALVES = `(async () => {
  const { viewport, renderer, store } = irradia;
  await viewport.whole();
  await viewport.nextFrame();
  const pixels = await renderer.readImage(store.document.view);
  const { width } = renderer.canvas;
  const hashes = [0, 0];
  for (let i = 0; i < pixels.length; i++) {
    const x = ((i >> 2) % width) / width;
    if (Math.abs(x - 0.5) < 0.01) continue;
    const half = x < 0.5 ? 0 : 1;
    hashes[half] = (Math.imul(hashes[half], 31) + pixels[i]) | 0;
  }
  return hashes;
})()`;

test('materials of the library: assigned, dragged, compared, varied, kept', async () => {
  const page = await (await lab.open(small())).ready();
  const { page: browser } = page;
  const card = (name: string) => `[data-material="${name}"]`;
  const undoLabel = () => browser.evaluate<string | null>('irradia.store.undoLabel');
  const halves = () => browser.evaluate<[number, number]>(HALVES);
  await page.menu('File', 'New');
  await page.until('Object.keys(irradia.store.document.objects).length === 1');
  const [sphere = ''] = Object.keys((await page.document()).objects);
  const materialOf = async () => {
    const { objects, materials } = await page.document();
    return materials[objects[sphere]!.material]!;
  };

  // Search and assign by a click; what was only tried does not stay.
  await page.select('objects', sphere);
  await browser.keyboard.press('m');
  await browser.fill('.library input[type=search]', 'gold');
  await expect.poll(() => browser.locator('.library .material-card').count()).toBe(2);
  await browser.click(card('library gold-polished'));
  expect(await undoLabel()).toBe('Assign Gold, polished');
  expect((await materialOf()).name).toBe('Gold, polished');
  expect(await browser.innerText('.library-source')).toContain('Johnson');
  // The list is made anew for the material that the scene has now; the keys stay on the card.
  const inScene = browser.locator('.library [data-section=scene] .material-card');
  await inScene.filter({ hasText: 'Gold, polished' }).waitFor();
  await browser.click(card('library gold-satin'));
  expect((await materialOf()).name).toBe('Gold, satin');
  const names = Object.values((await page.document()).materials).map(({ name }) => name);
  expect(names).not.toContain('Gold, polished');
  await inScene.filter({ hasText: 'Gold, satin' }).waitFor();
  expect(await browser.evaluate('document.activeElement.dataset.material')).toBe('library gold-satin');
  // Its picture comes from a worker.
  await page.until(
    `document.querySelector('${card('library gold-satin')} canvas').classList.contains('made')`,
  );

  // Keys: from the field into the grid, and Enter.
  await browser.fill('.library input[type=search]', 'copper');
  await browser.press('.library input[type=search]', 'ArrowDown');
  await browser.keyboard.press('ArrowRight');
  await browser.keyboard.press('Enter');
  expect((await materialOf()).name).toMatch(/Copper|copper/);

  // Dragged onto the object in the middle of the picture.
  await browser.fill('.library input[type=search]', 'chromium');
  await browser.dragAndDrop(card('library chromium'), '.viewport canvas');
  expect((await materialOf()).name).toBe('Chromium plate');

  // Compared: A is the left half, and B the right half is what the picture is once B is kept.
  const before = await halves();
  await browser.fill('.library input[type=search]', 'enamel');
  await browser.focus(card('library paint-red'));
  await browser.click('.library-actions >> text="Compare"');
  await browser.locator('.compare-bar').waitFor();
  const compared = await halves();
  expect(compared[0]).toBe(before[0]);
  expect(compared[1]).not.toBe(before[1]);
  expect((await materialOf()).name).toBe('Chromium plate');
  await browser.click('.compare-bar >> text="Keep B"');
  expect((await materialOf()).parameters.roughness).toBe(0.14);
  expect((await halves())[1]).toBe(compared[1]);
  await browser.keyboard.press('Control+z');
  expect(await halves()).toEqual(before);
  // Another model of the same values; Escape leaves all as it is.
  await browser.click('.model-about >> text="Compare…"');
  await browser.click('.menu >> text="lambert"');
  await browser.locator('.compare-bar').waitFor();
  expect((await halves())[1]).not.toBe(before[1]);
  await browser.focus(card('library paint-red'));
  await browser.keyboard.press('Escape');
  expect(await halves()).toEqual(before);
  expect(await browser.locator('.compare-bar:visible').count()).toBe(0);

  // Randomised, and blended with another: an undo step each.
  await browser.click('.model-about >> text="Vary…"');
  await browser.click('.vary-panel >> text="Randomise"');
  expect(await undoLabel()).toMatch(/Randomise, seed \d+/);
  await browser.selectOption('.vary-panel select', 'library tyre');
  await page.dragSlider('.vary-panel [data-label="Blend"]', 1);
  expect(await undoLabel()).toContain('Blend with Tyre');
  const tyre = materialLibrary.get('tyre')!.look.parameters.baseColor;
  await expect.poll(async () => (await materialOf()).parameters.baseColor).toEqual(tyre);
  await browser.keyboard.press('Control+z');
  expect(await undoLabel()).toMatch(/Randomise, seed \d+/);
  await browser.click('.vary-panel >> text="Close"');

  // Kept for other documents, deleted, and brought back.
  await browser.fill('.library input[type=search]', '');
  await browser.focus('.library [data-section=scene] .material-card >> nth=0');
  await browser.click('.library-actions >> text="Keep"');
  await browser.locator('.library [data-section=own] .material-card').waitFor();
  await browser.focus('.library [data-section=own] .material-card');
  await browser.click('.library-actions >> text="Delete"');
  await browser.locator('.library [data-section=own]').waitFor({ state: 'detached' });
  await page.takeOffer('Undo');
  await browser.locator('.library [data-section=own] .material-card').waitFor();

  // The picture keeps its room: the library has the outliner's place, which a search takes back; in a low window it lies beside the
  // picture, and what lies on the picture keeps apart.
  const boxes = (selectors: string[]) =>
    browser.evaluate<{ left: number; top: number; right: number; bottom: number }[]>(
      `${JSON.stringify(selectors)}.map((selector) => document.querySelector(selector).getBoundingClientRect().toJSON())`,
    );
  const [picture] = await boxes(['.viewport']);
  expect(picture!.right - picture!.left).toBeGreaterThan(300);
  await browser.setViewportSize({ width: 640, height: 360 });
  const [view, library, modes, tools] = await boxes(['.viewport', '.library', '.mode-switch', '.tool-bar']);
  expect(view!.right).toBeLessThanOrEqual(library!.left);
  expect(view!.right).toBeGreaterThan(300);
  expect(view!.bottom - view!.top).toBeGreaterThan(250);
  expect(modes!.bottom).toBeLessThan(tools!.top);
  await browser.keyboard.press('Control+f');
  expect(await browser.evaluate(`document.activeElement.closest('.panel-left') !== null`)).toBe(true);
  expect(await browser.locator('.library').isVisible()).toBe(false);
  expect(page.errors).toEqual([]);
});
