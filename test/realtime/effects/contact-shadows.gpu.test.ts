import { expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker } from './frames.ts';
import { finite, meanError, reduced, traced } from './reference.ts';

const SIZE = { width: 96, height: 64 };
const SCALE = 3;
const maker = await frameMaker(SIZE);

/** Low things on a floor: their shadows are all shorter than what is looked through. */
const things = (contactShadows: object, lamp: object) =>
  scene({
    camera: { fov: 30, position: [0.5, 0.9, 1.2], target: [0.05, 0, 0] },
    background: { type: 'color', color: [0.2, 0.2, 0.2] },
    objects: {
      floor: {
        name: 'floor',
        material: 'm',
        rotation: [-90, 0, 0],
        geometry: { type: 'plane', width: 9, height: 9 },
      },
      ball: {
        name: 'ball',
        material: 'm',
        position: [-0.2, 0.08, 0],
        geometry: { type: 'sphere', radius: 0.08, widthSegments: 48, heightSegments: 32 },
      },
      box: {
        name: 'box',
        material: 'm',
        position: [0.15, 0.04, 0.05],
        rotation: [0, 30, 0],
        geometry: { type: 'box', width: 0.12, height: 0.08, depth: 0.12 },
      },
    },
    materials: { m: material('lambert', { albedo: [0.5, 0.5, 0.5] }) },
    lights: { lamp: { type: 'directional', illuminance: 3, position: [-3, 3, 1], ...lamp } },
    view: { resolutionScale: SCALE },
    effects: {
      shadows: { enabled: false },
      contactShadows: { length: 0.3, thickness: 0.2, steps: 48, ...contactShadows },
    },
  });

test('shadows of low things are where the path tracer has them', async () => {
  const on = await maker.draw(things({ enabled: true }, {}));
  expect(finite(on)).toBe(true);
  const reference = await traced(things({}, {}), SIZE, 32, 1);
  const { error } = meanError(reduced(on, SCALE), reference);
  const off = meanError(reduced(await maker.draw(things({}, {})), SCALE), reference);
  expect(error).toBeLessThan(0.02);
  expect(off.error).toBeGreaterThan(2 * error);
});

test('a lamp that casts no shadows has none; nor has a floor with nothing on it', async () => {
  const none = { castShadow: false };
  const on = await maker.draw(things({ enabled: true }, none));
  expect(on.pixels).toEqual((await maker.draw(things({}, none))).pixels);
  const empty = (contactShadows: object) => {
    const document = things(contactShadows, {});
    return { ...document, objects: { floor: document.objects.floor! } };
  };
  const bare = await maker.draw(empty({ enabled: true }));
  expect(bare.pixels).toEqual((await maker.draw(empty({}))).pixels);
});
