import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { trace } from '../../pathtracer/tracer.ts';
import { frameMaker, meanRadiance, type Picture, shareThatDiffers } from './frames.ts';

const SIZE = { width: 144, height: 96 };
const maker = await frameMaker(SIZE);

const glowing = (color: readonly number[]) =>
  material('lambert', {}, { emissive: color, emissiveIntensity: 1 });

/** Walls of light with patterns: one before the focus, one in it, one behind it. */
const depths = (enabled: boolean, { fStop = 0.15, blades = 0, focus = 3 } = {}) => {
  const stripes = (name: string, x: number, z: number, count: number, size: number) =>
    Object.fromEntries(
      Array.from({ length: count }, (_, i) => [
        `${name}${i}`,
        {
          name,
          material: i % 2 ? 'dim' : name,
          position: [x, (i - (count - 1) / 2) * size, z],
          geometry: { type: 'plane', width: 4 * size, height: size },
        },
      ]),
    );
  return scene({
    camera: {
      fov: 30,
      position: [0, 0, 3],
      target: [0, 0, 0],
      near: 0.1,
      fStop,
      focusDistance: focus,
      apertureBlades: blades,
    },
    background: { type: 'color', color: [0.05, 0.05, 0.08] },
    objects: {
      ...stripes('near', -0.45, 1.2, 4, 0.16),
      ...stripes('sharp', 0, 0, 6, 0.16),
      ...stripes('far', 1.6, -4, 8, 0.5),
      spark: {
        name: 'spark',
        material: 'spark',
        position: [-0.2, 1.5, -4],
        geometry: { type: 'plane', width: 0.08, height: 0.08 },
      },
    },
    materials: {
      near: glowing([0.9, 0.3, 0.1]),
      sharp: glowing([0.3, 0.8, 0.3]),
      far: glowing([0.2, 0.4, 1]),
      dim: glowing([0.02, 0.02, 0.02]),
      spark: material('lambert', {}, { emissive: [1, 1, 1], emissiveIntensity: 5 }),
    },
    effects: { depthOfField: { enabled }, antialiasing: { method: 'none' } },
  });
};

async function traced(document: ReturnType<typeof depths>): Promise<Picture> {
  const film = await trace(document, { ...SIZE, samples: 32, maxDepth: 1 });
  const rgb = film.mean();
  const pixels = new Float32Array((rgb.length / 3) * 4).map((_, i) =>
    i % 4 === 3 ? 1 : rgb[3 * Math.floor(i / 4) + (i % 4)]!,
  );
  return { ...SIZE, pixels };
}

/** The mean of the absolute differences over the mean of the second. */
function relativeError(a: Picture, b: Picture): number {
  let [sum, total] = [0, 0];
  for (let i = 0; i < a.pixels.length; i++) {
    if (i % 4 === 3) continue;
    sum += Math.abs(a.pixels[i]! - b.pixels[i]!);
    total += b.pixels[i]!;
  }
  return sum / total;
}

test.each([0, 5])('it is what the path tracer sees through the same lens: %i blades', async (blades) => {
  const document = depths(true, { blades });
  const truth = await traced(document);
  const on = await maker.draw(document);
  const off = await maker.draw(depths(false, { blades }));
  const [error, without] = [relativeError(on, truth), relativeError(off, truth)];
  expect(error).toBeLessThan(0.12);
  expect(error).toBeLessThan(without / 2.5);
});

test('a pinhole, or the effect switched off, changes no pixel', async () => {
  const off = await maker.draw(depths(false));
  expect((await maker.draw(depths(true, { fStop: 0 }))).pixels).toEqual(off.pixels);
});

test('what is in focus stays as it is, and the picture’s light is kept', async () => {
  const off = await maker.draw(depths(false));
  const on = await maker.draw(depths(true, { fStop: 2 }));
  expect(shareThatDiffers(off, on, 0.02)).toBeLessThan(0.12);
  const wide = await maker.draw(depths(true));
  const [before, after] = [meanRadiance(off), meanRadiance(wide)];
  for (const c of [0, 1, 2] as const) expect(Math.abs(after[c] / before[c] - 1)).toBeLessThan(0.1);
  expect(wide.pixels.every((value) => value >= 0 && value < 1000)).toBe(true);
});
