import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, meanRadiance, type Picture, shareThatDiffers } from './frames.ts';

const SIDE = 128;
const maker = await frameMaker({ width: SIDE, height: SIDE });

/** A white frame of light around the middle of the picture. */
const frame = (effects: object) =>
  scene({
    camera: { fov: 60, position: [0, 0, 2], target: [0, 0, 0] },
    background: { type: 'color', color: [0.2, 0.2, 0.2] },
    objects: {
      left: {
        name: 'l',
        material: 'm',
        position: [-0.9, 0, 0],
        geometry: { type: 'plane', width: 0.2, height: 2 },
      },
      right: {
        name: 'r',
        material: 'm',
        position: [0.9, 0, 0],
        geometry: { type: 'plane', width: 0.2, height: 2 },
      },
    },
    materials: { m: material('lambert', {}, { emissive: [1, 1, 1], emissiveIntensity: 5 }) },
    effects: { antialiasing: { method: 'none' }, ...effects },
  });
const lens = (more: object) => ({ lens: { enabled: true, dispersion: 0, dirt: 0, vignette: 0, ...more } });
const at = ({ pixels }: Picture, x: number, y: number) => [
  ...pixels.subarray(4 * (y * SIDE + x), 4 * (y * SIDE + x) + 3),
];

test('dispersion throws red larger than blue, and leaves white and the middle as they are', async () => {
  const off = await maker.draw(frame({}));
  const on = await maker.draw(frame(lens({ dispersion: 0.04 })));
  expect(at(on, 64, 64)).toEqual(at(off, 64, 64).map((value) => expect.closeTo(value, 3)));
  // Outside of the right bar, which is from 108.3 to 119.4, is its red; inside its blue.
  const row = Array.from({ length: SIDE }, (_, x) => at(on, x, 64));
  const fringe = row.slice(118, 122).reduce((sum, [r, , b]) => sum + r! - b!, 0);
  const inner = row.slice(106, 110).reduce((sum, [r, , b]) => sum + b! - r!, 0);
  expect(fringe).toBeGreaterThan(0.5);
  expect(inner).toBeGreaterThan(0.5);
  const [before, after] = [meanRadiance(off), meanRadiance(on)];
  for (const c of [0, 1, 2] as const) expect(after[c] / before[c]).toBeCloseTo(1, 1);
});

test('vignetting is the fourth power of the cosine', async () => {
  const off = await maker.draw(frame({}));
  const on = await maker.draw(frame(lens({ vignette: 1 })));
  const tangent = Math.tan(Math.PI / 6) * ((0.5 - 64) / 64);
  const cosine2 = 1 / (1 + 2 * tangent ** 2);
  expect(at(on, 0, 0)[0]! / at(off, 0, 0)[0]!).toBeCloseTo(cosine2 ** 2, 2);
  expect(at(on, 64, 64)[0]).toBeCloseTo(0.2, 3);
});

test('dirt is seen in the glow alone, and keeps the light', async () => {
  const bloom = { enabled: true, strength: 0.1, radius: 0.8 };
  const clean = await maker.draw(frame({ bloom }));
  const dirty = await maker.draw(frame({ bloom, ...lens({ dirt: 1 }) }));
  expect(shareThatDiffers(clean, dirty, 1e-3)).toBeGreaterThan(0.1);
  expect(meanRadiance(dirty)[0] / meanRadiance(clean)[0]).toBeCloseTo(1, 1);
  const alone = await maker.draw(frame(lens({ dirt: 1 })));
  expect(alone.pixels).toEqual((await maker.draw(frame({}))).pixels);
});

test('a lens that is switched off changes no bit', async () => {
  const off = await maker.draw(frame({ lens: { enabled: false, dispersion: 0.1, dirt: 1, vignette: 1 } }));
  expect(off.pixels).toEqual((await maker.draw(frame({}))).pixels);
});
