/** Every scene that ships opens without a word of complaint and shows something, on both back ends. */
import { readdirSync } from 'node:fs';
import { expect, it } from 'vitest';
import { openLab, small } from './lab.ts';

const lab = await openLab();
/** The scenes are as they ship, and the GPU is made of software: so few pixels. */
const size = { width: 720, height: 400 };
const scenes = readdirSync(new URL('../../scenes', import.meta.url))
  .filter((name) => name.endsWith('.json'))
  .map((name) => name.replace('.json', ''));

it.each(scenes)('%s opens', async (scene) => {
  const page = await lab.open({ query: `?scene=${scene}`, ...size });
  await page.ready();
  expect((await page.picture()).colors).toBeGreaterThan(50);
  expect(page.errors).toEqual([]);
  expect(await page.toasts()).toEqual([]);
  await page.page.close();
});

it('the menu opens another scene', async () => {
  const page = await (await lab.open(small({}, size))).ready();
  await page.menu('File', 'Thesis demo02');
  await page.until(`irradia.store.document.name === 'Three spots'`);
  expect((await page.picture()).colors).toBeGreaterThan(50);
  expect(page.errors).toEqual([]);
});

it('the lab runs on WebGL 2 where there is no WebGPU', async () => {
  const page = await lab.open({
    init: "Object.defineProperty(navigator, 'gpu', { value: undefined });",
    ...size,
  });
  await page.ready();
  expect((await page.picture()).colors).toBeGreaterThan(100);
  expect(await page.page.locator('.status').textContent()).toContain('WebGL 2');
  expect(page.errors).toEqual([]);
});
