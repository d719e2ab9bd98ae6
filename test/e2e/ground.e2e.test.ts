import { expect, test } from 'vitest';
import { openLab } from './lab.ts';

const lab = await openLab();

const ball = {
  format: 'irradia',
  version: 1,
  name: 'Ball',
  camera: { fov: 40, position: [0, 1.5, 4], target: [0, 0.4, 0] },
  // Quick to draw: what is tested is the page.
  view: { resolutionScale: 0.25 },
  environment: { source: { type: 'constant', color: [1, 1, 1] }, samples: 2 },
  background: { type: 'color', color: [0.5, 0.5, 0.5] },
  materials: { m: { name: 'Clay', model: 'lambert' } },
  objects: {
    ball: { name: 'Ball', material: 'm', position: [0, 0.8, 0], geometry: { type: 'sphere', radius: 0.5 } },
  },
};
const files = { '/ball.json': JSON.stringify(ball) };

test('one switch shows shadows on the ground; its height is its own or a number; undo takes it back', async () => {
  const opened = await (
    await lab.open({ query: '?scene=/ball.json', files, width: 900, height: 520 })
  ).ready();
  const { page } = opened;
  const without = await opened.picture();
  const height = page.getByLabel('Height by a number', { exact: true });
  expect(await height.count()).toBe(0);
  await page.getByLabel('Shadow catcher', { exact: true }).click();
  const shown = await opened.document();
  expect(shown.ground).toMatchObject({ shadowCatcher: true, height: null });
  expect(shown.effects.shadows.enabled).toBe(true);
  const withShadow = await opened.picture();
  expect(withShadow.hash).not.toBe(without.hash);

  await height.click();
  expect((await opened.document()).ground.height).toBe(0.3);
  await page.click('[data-action=undo]');
  await page.click('[data-action=undo]');
  expect((await opened.document()).ground.shadowCatcher).toBe(false);
  expect((await opened.picture()).hash).toBe(without.hash);
});
