import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import { type Frame, type FrameRequest, SIZE } from './frame.page.ts';

const harness = await pageHarness(new URL('./frame.page.ts', import.meta.url));

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
});
