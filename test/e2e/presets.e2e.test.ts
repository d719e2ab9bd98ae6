import { expect, test } from 'vitest';
import { openLab } from './lab.ts';

const lab = await openLab();

const ball = {
  format: 'irradia',
  version: 1,
  name: 'Ball',
  camera: { fov: 40, position: [0, 1.5, 4], target: [0, 0.4, 0] },
  materials: { m: { name: 'Clay', model: 'lambert' } },
  lights: { sun: { type: 'directional', name: 'Sun', position: [2, 4, 1], target: [0, 0, 0] } },
  objects: {
    floor: {
      name: 'Floor',
      material: 'm',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 6, height: 6 },
    },
    ball: { name: 'Ball', material: 'm', position: [0, 0.5, 0], geometry: { type: 'sphere', radius: 0.5 } },
  },
};
const files = { '/ball.json': JSON.stringify(ball) };
/** At a quarter of the resolution: the effects of a preset are many, and the GPU is made of software. */
const coarse = { ...ball, view: { resolutionScale: 0.25 } };
const query = '?scene=/ball.json';

test('a preset is chosen in the inspector and undone; the GPU’s times are beside the effects while they are asked for', async () => {
  const opened = await (
    await lab.open({ query, files: { '/ball.json': JSON.stringify(coarse) }, width: 880, height: 400 })
  ).ready();
  const { page } = opened;
  const preset = page.locator('select[aria-label=Preset]');
  const plain = await opened.picture();
  expect(await preset.inputValue()).toBe('low');
  await preset.selectOption('medium');
  expect((await opened.document()).effects.shadows.enabled).toBe(true);
  const shadowed = await opened.picture();
  expect(shadowed.hash).not.toBe(plain.hash);

  expect(await page.locator('.gpu-times').isVisible()).toBe(false);
  await page.click('[aria-label="GPU times"]');
  await opened.until("document.querySelectorAll('.gpu-times .figure').length > 3");
  // Of each part that was drawn; the sum is the first.
  const labels = await page.locator('.gpu-times dt').allInnerTexts();
  expect(labels[0]).toBe('GPU');
  expect(labels).toEqual(expect.arrayContaining(['Surfaces', 'Ambient occlusion', 'Scene', 'Output']));
  const header = page.locator('summary:has-text("Ambient occlusion") .gpu-time');
  expect(await header.innerText()).toMatch(/^\d+(\.\d+)? ms$/);
  await page.click('[aria-label="GPU times"]');
  expect(await header.innerText()).toBe('');

  await page.click('[data-action=undo]');
  expect(await preset.inputValue()).toBe('low');
  expect((await opened.picture()).hash).toBe(plain.hash);
  expect(opened.errors).toEqual([]);
});

test('while things move fewer pixels are drawn, to hold the target; a picture that stands still has all', async () => {
  const opened = await (await lab.open({ query, files, width: 880, height: 400 })).ready();
  const { page } = opened;
  const full = await opened.picture();
  const resolution = page.locator('.figure:has(dt:text-is("Resolution")) dd');
  const size = await resolution.innerText();
  // A time that no GPU holds.
  await page.evaluate(`(async () => {
    const { store } = irradia;
    store.edit('Target', (draft) => { draft.view.targetFrameTime = 0.001; });
    for (let i = 1; ; i++) {
      store.edit('Turn', (draft) => { draft.camera.position[0] = Math.sin(i / 100); }, { merge: 'turn' });
      if (document.querySelector('.figures dd').textContent.includes('%')) return;
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
  })()`);
  // Nothing moves now.
  await opened.until("!document.querySelector('.figures dd').textContent.includes('%')");
  expect(await resolution.innerText()).toBe(size);
  await page.evaluate(`irradia.store.undo(); irradia.store.undo();`);
  expect((await opened.picture()).hash).toBe(full.hash);
  expect(opened.errors).toEqual([]);
});

/** As if the GPU were one, and took so many ms for a plain frame. */
const fastDevice = (milliseconds: number) => `
  const info = { vendor: 'acme', architecture: '', device: '', description: '' };
  Object.defineProperty(GPUDevice.prototype, 'adapterInfo', { get: () => info });
  let lab;
  let viewport = null;
  Object.defineProperty(window, 'irradia', {
    get: () => lab,
    set(value) {
      lab = Object.defineProperty(value, 'viewport', {
        get: () => viewport,
        set(made) {
          viewport = Object.assign(made, { measureFrame: async () => ${milliseconds} });
        },
      });
    },
  });`;

test('a shipped scene gets the preset of the device after a plain first frame, and nothing to undo or to keep', async () => {
  const opened = await lab.open({
    query: '?scene=thesis-demo02',
    scenes: { 'thesis-demo02': coarse },
    init: fastDevice(2),
    width: 640,
    height: 400,
  });
  await opened.ready();
  await opened.until('irradia.store.document.effects.shadows.enabled');
  expect(await opened.page.locator('select[aria-label=Preset]').inputValue()).toBe('medium');
  const { colors } = await opened.picture();
  expect(colors).toBeGreaterThan(50);
  expect(await opened.page.evaluate('irradia.store.canUndo')).toBe(false);
  expect(await opened.page.locator('[data-action=undo]').isDisabled()).toBe(true);
  expect(opened.errors).toEqual([]);
});
