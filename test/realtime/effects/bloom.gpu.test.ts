import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, meanRadiance, shareThatDiffers } from './frames.ts';

const maker = await frameMaker({ width: 128, height: 128 });

/** A small bright square in the middle of the dark. */
const lamp = (bloom: object) =>
  scene({
    camera: { fov: 40, position: [0, 0, 4], target: [0, 0, 0] },
    background: { type: 'color', color: [0, 0, 0] },
    objects: { lamp: { name: 'lamp', material: 'm', geometry: { type: 'plane', width: 0.2, height: 0.2 } } },
    materials: { m: material('lambert', {}, { emissive: [1, 0.5, 0.25], emissiveIntensity: 100 }) },
    effects: { bloom },
  });

test('bloom spreads light over the dark and keeps the picture’s mean', async () => {
  const off = await maker.draw(lamp({ enabled: false }));
  const on = await maker.draw(lamp({ enabled: true, strength: 0.2, radius: 0.7 }));
  expect(shareThatDiffers(off, on, 1e-5)).toBeGreaterThan(0.5);
  const [before, after] = [meanRadiance(off), meanRadiance(on)];
  for (const c of [0, 1, 2] as const) expect(after[c] / before[c]).toBeCloseTo(1, 1);
  // In the middle of the lamp a fifth is gone, but for what comes back.
  const centre = 4 * (64 * 128 + 64);
  expect(on.pixels[centre]! / off.pixels[centre]!).toBeGreaterThan(0.79);
  expect(on.pixels[centre]! / off.pixels[centre]!).toBeLessThan(0.95);
  // Farther away there is less of it.
  const at = (x: number) => on.pixels[4 * (64 * 128 + x)]!;
  expect(at(80)).toBeGreaterThan(at(95));
  expect(at(95)).toBeGreaterThan(at(120));
  expect(at(120)).toBeGreaterThan(0);
});

test('bloom of strength 0, or switched off, changes no pixel', async () => {
  const off = await maker.draw(lamp({ enabled: false }));
  const none = await maker.draw(lamp({ enabled: true, strength: 0 }));
  expect(none.pixels).toEqual(off.pixels);
});
