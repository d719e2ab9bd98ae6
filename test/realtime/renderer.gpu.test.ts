import { afterAll, describe, expect, test } from 'vitest';
import { RealtimeRenderer, type ViewSettings } from '../../src/realtime/renderer.ts';
import { testRenderer } from '../support/gpu.ts';
import { halves, SIZE } from './frame.page.ts';

const { renderer: three, readCanvas } = await testRenderer(SIZE.width, SIZE.height);
const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
afterAll(() => renderer.dispose());

const view = (change: Partial<ViewSettings> = {}): ViewSettings => ({
  exposure: 0,
  toneMapping: 'none',
  resolutionScale: 1,
  ...change,
});

describe('the interactive renderer', () => {
  const content = halves();

  test('shows on the canvas what it reads back', async () => {
    renderer.render(content, { view: view() }, SIZE);
    expect(await readCanvas()).toEqual(await renderer.readImage(view()));
  });

  test('exposure changes the picture, not the radiance', async () => {
    renderer.render(content, { view: view() }, SIZE);
    const before = await renderer.readRadiance();
    const dark = await renderer.readImage(view());
    renderer.render(content, { view: view({ exposure: 1 }) }, SIZE);
    expect(await renderer.readRadiance()).toEqual(before);
    const bright = await renderer.readImage(view({ exposure: 1 }));
    const blue = (image: Uint8Array) => image[image.length - 2];
    // sRGB of 1/4 and of 1/2.
    expect([blue(dark), blue(bright)]).toEqual([137, 188]);
  });

  test.each(['aces', 'agx', 'neutral'] as const)(
    '%s keeps bright radiance below white',
    async (toneMapping) => {
      renderer.render(content, { view: view({ toneMapping }) }, SIZE);
      const image = await renderer.readImage(view({ toneMapping }));
      const clipped = await renderer.readImage(view());
      expect(image).not.toEqual(clipped);
      expect([...image.subarray(0, 4)].every((value) => value > 0)).toBe(true);
    },
  );

  test('refuses several samples of float precision, which WebGPU does not have', () => {
    expect(() => new RealtimeRenderer(three, { samples: 4, precision: 'float' })).toThrow('half precision');
  });
});
