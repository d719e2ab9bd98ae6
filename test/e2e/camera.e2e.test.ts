/** The camera as a person uses it: what is shown, what is in focus, what exposes the picture. */
import { beforeAll, expect, it } from 'vitest';
import { addLight, addObject } from '../../src/scene/commands.ts';
import { createDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { type LabPage, openLab } from './lab.ts';

const lab = await openLab();
let page: LabPage;

/** A sphere 3 m before the camera, in the middle of the picture. */
function sphere(): string {
  const store = new DocumentStore(createDocument());
  addLight(store, 'directional');
  const id = addObject(store, 'sphere');
  store.edit('For a test', (draft) => {
    const object = draft.objects[id]!;
    object.position = [0, 0, 0];
    Object.assign(object.geometry, { radius: 1 });
    Object.assign(draft.camera, { position: [0, 0, 4], target: [0, 0, 0] });
    draft.view.resolutionScale = 0.25;
    draft.environment.samples = 2;
  });
  return serializeDocument(store.document);
}

beforeAll(async () => {
  const files = { '/scene.json': sphere() };
  // High enough for a legend with all its words.
  page = await (await lab.open({ query: '?scene=/scene.json', files, height: 620 })).ready();
});

const middle = async (): Promise<[number, number]> => {
  const box = await page.page.locator('.viewport canvas').first().boundingBox();
  if (!box) throw new Error('no viewport');
  return [box.x + box.width / 2, box.y + box.height / 2];
};

it('a click sets what is in focus, as one step that can be undone', async () => {
  await page.page.keyboard.press('Shift+F');
  await page.page.mouse.click(...(await middle()));
  await expect.poll(async () => (await page.document()).camera.focusDistance).toBeCloseTo(3, 2);
  // The click chose a focus, not an object.
  expect(await page.page.evaluate('irradia.store.undoLabel')).toContain('Focus the lens on');
  await page.page.keyboard.press('Control+z');
  expect((await page.document()).camera.focusDistance).toBe(0);
});

it('Escape lets the focus be', async () => {
  await page.page.keyboard.press('Shift+F');
  await page.page.keyboard.press('Escape');
  await page.page.mouse.click(...(await middle()));
  expect((await page.document()).camera.focusDistance).toBe(0);
  await page.page.keyboard.press('Escape');
});

it('the key V goes through all that can be shown; the legend and the pointer say what it is', async () => {
  await page.page.keyboard.press('v');
  expect((await page.document()).view.show).toBe('luminance');
  await page.picture();
  await page.page.locator('.show-row >> text="middle grey"').waitFor();
  const [x, y] = await middle();
  await page.page.mouse.move(x - 5, y);
  await page.page.mouse.move(x, y);
  await page.until(`/^[\\d.]+ nits$/.test(document.querySelector('.show-reading').textContent)`);
  await page.page.keyboard.press('v');
  await page.picture();
  await page.page.mouse.move(x - 4, y);
  await page.page.mouse.move(x, y);
  await page.until(`Math.abs(parseFloat(document.querySelector('.show-reading').textContent) - 3) < 0.02`);
  await page.page.keyboard.press('Shift+V');
  await page.page.keyboard.press('Shift+V');
  expect((await page.document()).view.show).toBe('picture');
});

it('a focal length is typed as such and kept as an angle', async () => {
  const field = page.page.getByLabel('Focal length, number');
  await field.scrollIntoViewIfNeeded();
  await field.fill('50');
  await field.press('Enter');
  expect((await page.document()).camera.fov).toBeCloseTo(26.99, 1);
});

it('a picture that is gathered over time becomes complete, and the page then rests', async () => {
  await page.page.evaluate(
    `irradia.store.edit('Temporal', (draft) => { draft.effects.antialiasing.method = 'temporal'; })`,
  );
  await page.page.evaluate('irradia.viewport.nextFrame()');
  await page.until('!irradia.renderer.unsettled');
  const { hash } = await page.picture();
  expect((await page.picture()).hash).toBe(hash);
});

it('the automatic exposure arrives, and shows the sphere', async () => {
  await page.page.evaluate(
    `irradia.store.edit('Expose', (draft) => { draft.view.exposureMode = 'auto'; for (const id in draft.lights) draft.lights[id].illuminance = 50000; })`,
  );
  await page.page.evaluate('irradia.viewport.nextFrame()');
  await page.until('!irradia.renderer.adapting');
  expect(await page.page.evaluate('irradia.renderer.exposure(irradia.store.document.view)')).toBeLessThan(
    -10,
  );
  expect(page.errors).toEqual([]);
});
