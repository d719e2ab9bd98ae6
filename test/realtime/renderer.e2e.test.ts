import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import { type Frame, type FrameRequest, SIZE } from './frame.page.ts';
import type { Likeness } from './repeated.ts';

const harness = await pageHarness(new URL('./frame.page.ts', import.meta.url));

/** The canvas after the frame, too: WebGL's rows start at the bottom, the parts of a canvas that are drawn on as well. */
test.each([
  ['webgpu', false],
  ['webgl', true],
])('the page reads back radiance and picture, %s', async (backend, forceWebGL) => {
  const view = { exposure: -3, toneMapping: 'none', resolutionScale: 2 } as const;
  const request: FrameRequest = { forceWebGL, view };
  const frame = await harness.run<Frame>(request);
  expect(frame.backend).toBe(backend);
  expect(frame.radiance).toMatchObject({ width: SIZE.width * 2, height: SIZE.height * 2 });
  const at = (pixels: number[], width: number, x: number, y: number) =>
    pixels.slice((y * width + x) * 4, (y * width + x) * 4 + 3);
  expect(at(frame.radiance.pixels, SIZE.width * 2, 60, 2)).toEqual([8, 0.5, 0.125]);
  expect(at(frame.radiance.pixels, SIZE.width * 2, 60, 29)).toEqual([0, 0, 0.25]);
  // sRGB of 1, 1/16, 1/64 and 1/32.
  expect(at(frame.image, SIZE.width, 30, 1)).toEqual([255, 71, 34]);
  expect(at(frame.image, SIZE.width, 30, 14)).toEqual([0, 0, 49]);
  const column = [7, 8, 9, 10, 11].map((y) => at(frame.outlined, SIZE.width, 3, y));
  const [red, black, ground] = [
    [255, 0, 0],
    [0, 0, 0],
    [0, 0, 49],
  ];
  expect(column).toEqual([[255, 71, 34], red, red, black, ground]);
});

test('WebGL draws many that are alike as instances, too', async () => {
  const page = await pageHarness(new URL('./repeated.page.ts', import.meta.url));
  const found = await page.run<Readonly<Record<string, Likeness>>>({ forceWebGL: true });
  for (const { differing, mean, calls, single } of Object.values(found)) {
    expect(differing).toBeLessThan(0.02);
    expect(mean).toBeLessThan(2e-3);
    expect(calls).toBeLessThan(single / 4);
  }
});
