import { expect, test } from 'vitest';
import { openLab, small } from './lab.ts';

const lab = await openLab();

const ball = {
  format: 'irradia',
  version: 1,
  name: 'Ball',
  camera: { fov: 40, position: [0, 1, 4], target: [0, 0.4, 0] },
  // Quick to draw: what is tested is the page.
  view: { resolutionScale: 0.25 },
  environment: { samples: 2 },
  materials: { m: { name: 'Clay', model: 'lambert' } },
  objects: {
    ball: { name: 'Ball', material: 'm', position: [0, 0.5, 0], geometry: { type: 'sphere', radius: 0.5 } },
  },
};
const files = { '/ball.json': JSON.stringify(ball) };

test('a sky is chosen, its sun placed by a clock, the environment turned by hand; each is one step to undo', async () => {
  const opened = await (
    await lab.open({ query: '?scene=/ball.json', files, width: 900, height: 520 })
  ).ready();
  const { page } = opened;
  const dark = await opened.picture();
  await page.locator('select[aria-label=Environment]').selectOption('sky');
  const sky = await opened.document();
  expect(sky.environment.source.type).toBe('sky');
  expect(sky.background.type).toBe('environment');
  expect(sky.effects.shadows.enabled).toBe(true);
  const noon = await opened.picture();
  expect(noon.hash).not.toBe(dark.hash);

  await page.locator('select[aria-label=Sun]').selectOption('place');
  await page.getByLabel('Date', { exact: true }).fill('2026-12-21');
  const { source } = (await opened.document()).environment;
  expect(source).toMatchObject({ sun: { type: 'place', date: '2026-12-21' } });
  // Paris at its darkest, 15:00 by a clock two hours ahead: the sun is past its highest, 17.7 degrees.
  const stands = await page.locator('.placed-sun').innerText();
  const [, azimuth, elevation] = (/([\d.]+)° around, ([\d.]+)° high/.exec(stands) ?? []).map(Number);
  expect(azimuth).toBeGreaterThan(180);
  expect(elevation).toBeGreaterThan(12);
  expect(elevation).toBeLessThan(17.7);
  await opened.picture();

  const canvas = page.locator('.viewport canvas').first();
  const box = (await canvas.boundingBox()) as { x: number; y: number; width: number; height: number };
  const before = (await opened.document()).camera;
  await page.keyboard.down('Alt');
  await page.mouse.move(box.x + box.width / 2, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 100, box.y + 60, { steps: 4 });
  expect(await page.locator('.environment-readout').innerText()).toBe('Environment 40.0°');
  await page.mouse.up();
  await page.keyboard.up('Alt');
  const turned = await opened.document();
  expect(turned.environment.rotation).toBe(40);
  expect(turned.camera).toEqual(before);
  await page.click('[data-action=undo]');
  expect((await opened.document()).environment.rotation).toBe(0);
  expect(opened.errors).toEqual([]);
});

test('soft boxes are arranged by pointer and by keys; a transparent background is said in the picture', async () => {
  const opened = await (
    await lab.open({ query: '?scene=/ball.json', files, width: 900, height: 640 })
  ).ready();
  const { page } = opened;
  await page.locator('select[aria-label=Environment]').selectOption('studio');
  const boxes = async () => {
    const { source } = (await opened.document()).environment;
    return source.type === 'studio' ? source.boxes : [];
  };
  const picture = page.locator('.studio-picture');
  await picture.waitFor();
  expect((await boxes()).length).toBe(3);
  expect(await page.locator('.studio-picture g').count()).toBe(3);
  const key = page.locator('.studio-picture g').first();
  await key.focus();
  const [first] = await boxes();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowUp');
  expect((await boxes())[0]).toMatchObject({
    azimuth: first!.azimuth + 5,
    elevation: first!.elevation + 5,
  });
  expect(await page.locator('select[aria-label=Arrangement]').inputValue()).toBe('own');

  await picture.scrollIntoViewIfNeeded();
  const outline = (await key.locator('path').boundingBox()) as {
    x: number;
    y: number;
    width: number;
    height: number;
  };
  const frame = (await picture.boundingBox()) as { x: number; y: number; width: number; height: number };
  // The path is drawn three times, across both edges: its middle is the picture's place of the box.
  const box = (await boxes())[0]!;
  const x = frame.x + (frame.width * (180 - (box.azimuth - 180))) / 360;
  const y = frame.y + (frame.height * (90 - box.elevation)) / 180;
  expect(outline.height).toBeGreaterThan(10);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - (frame.width * 20) / 360, y, { steps: 3 });
  await page.mouse.up();
  expect(Math.abs((await boxes())[0]!.azimuth - (box.azimuth + 20))).toBeLessThan(3);
  await page.click('[data-action=undo]');
  expect((await boxes())[0]).toEqual(box);

  await page.click('[aria-label="Choose an environment by its picture"]');
  const options = page.locator('.environment-option');
  await options.first().waitFor();
  expect(await options.count()).toBe(20);
  // The present one has the focus; upwards and to its left is the sky.
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  expect((await opened.document()).environment.source.type).toBe('sky');
  expect(await options.count()).toBe(0);

  await page.locator('select[aria-label=Background]').selectOption('transparent');
  expect(await page.locator('.viewport canvas').first().getAttribute('class')).toContain('transparent');
  await opened.picture();
  expect(opened.errors).toEqual([]);
});

test('a sky that comes while the first frame is drawn is in the picture when the page is ready', async () => {
  const sky = { environment: { samples: 1, source: { type: 'sky' } }, view: { resolutionScale: 0.25 } };
  const page = await (await lab.open(small(sky))).ready();
  const seen = 'irradia.renderer.readPixel(0.5, 0.1).then(([r, g, b, a]) => [b > r, a])';
  expect(await page.page.evaluate(seen)).toEqual([true, 1]);
  await page.page.close();
});
