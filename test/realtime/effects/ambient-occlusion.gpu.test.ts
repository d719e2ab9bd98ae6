import { expect, test } from 'vitest';
import { evenLight, material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker } from './frames.ts';
import { finite, meanError, meanWithin, reduced, traced } from './reference.ts';

const SIZE = { width: 72, height: 48 };
/** Pixels of the frame beside each of the path traced picture's; what mirrors show is finer than that. */
const SCALE = 2;
const MIRRORS = 3;
const maker = await frameMaker(SIZE);

const plane = (width: number, rotation: number[], position: number[]) => ({
  name: 'plane',
  material: 'm',
  rotation,
  position,
  geometry: { type: 'plane', width, height: width },
});
const floor = plane(8, [-90, 0, 0], [0, 0, 0]);
const ball = {
  name: 'ball',
  material: 'm',
  position: [0, 0.7, 0],
  geometry: { type: 'sphere', radius: 0.7, widthSegments: 96, heightSegments: 64 },
};
const suzanne = { position: [0, 0.75, 0], rotation: [-20, 15, 0], geometry: { type: 'suzanne' } };
const camera = { fov: 35, position: [0, 1.8, 4.5], target: [0, 0.5, 0] };
const scenes = {
  corner: {
    camera: { fov: 35, position: [4, 3.2, 4.8], target: [0.9, 0.8, 0.9] },
    objects: {
      floor: plane(2, [-90, 0, 0], [1, 0, 1]),
      back: plane(2, [0, 0, 0], [1, 1, 0]),
      side: plane(2, [0, 90, 0], [0, 1, 1]),
    },
  },
  ball: { camera, objects: { floor, ball } },
  suzanne: { camera, objects: { floor, suzanne: { name: 'suzanne', material: 'm', ...suzanne } } },
  open: { camera, objects: { floor } },
};
const plain = material('lambert', { albedo: [0.5, 0.5, 0.5] }, { doubleSided: true });
const gloss = material('principled', { baseColor: [0.5, 0.5, 0.5], roughness: 0.5 }, { doubleSided: true });
const metal = (roughness: number) =>
  material('principled', { baseColor: [0.9, 0.9, 0.9], metallic: 1, roughness }, { doubleSided: true });
const white = material('lambert', { albedo: [1, 1, 1] }, { doubleSided: true });

/** Nothing is too far away to count, and nothing bounces: what the path tracer's first bounce sees. */
const lit = (parts: object, m: object, ambientOcclusion: object = {}, resolutionScale = SCALE) =>
  scene({
    ...evenLight,
    ...parts,
    materials: { m },
    view: { resolutionScale },
    effects: {
      ambientOcclusion: { enabled: true, bounces: false, radius: 100, ...ambientOcclusion },
    },
  });

test.each([
  ['a corner', 'corner', plain, SCALE, 0.04],
  ['a ball on a floor', 'ball', plain, SCALE, 0.04],
  ['Suzanne', 'suzanne', plain, SCALE, 0.05],
  ['a glossy ball on a glossy floor', 'ball', gloss, SCALE, 0.05],
  ['a mirror ball on a mirror', 'ball', metal(0.1), MIRRORS, 0.06],
  ['a metal ball on metal', 'ball', metal(0.3), MIRRORS, 0.06],
] as const)('%s is as dark under an even sky as the path tracer makes it', async (_, key, m, scale, most) => {
  const document = lit(scenes[key], m, {}, scale);
  const shown = await maker.draw(document);
  expect(finite(shown)).toBe(true);
  const reference = await traced(document, SIZE, 64, 1);
  const { error } = meanError(reduced(shown, scale), reference);
  expect(error).toBeLessThan(most);
});

test('an open floor in a white furnace stays white; where it is closed, bounces make up for most', async () => {
  const open = await maker.draw(lit(scenes.open, white));
  expect(open.pixels.every((x) => Math.abs(x - 1) < 0.005)).toBe(true);
  const floorNearBall = (x: number, y: number) => x > 20 * SCALE && x < 50 * SCALE && y > 32 * SCALE;
  const dark = meanWithin(await maker.draw(lit(scenes.ball, white)), floorNearBall);
  const tinted = meanWithin(await maker.draw(lit(scenes.ball, white, { bounces: true })), floorNearBall);
  expect(dark).toBeLessThan(0.95);
  expect(tinted).toBeGreaterThan(dark + (1 - dark) / 2);
  expect(tinted).toBeLessThan(1);
});

test('off, it changes no pixel', async () => {
  const off = await maker.draw(lit(scenes.ball, plain, { enabled: false }));
  const { effects: _, ...rest } = lit(scenes.ball, plain);
  const without = await maker.draw(scene(rest));
  expect(off.pixels).toEqual(without.pixels);
});
