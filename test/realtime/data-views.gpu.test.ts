import { expect, test } from 'vitest';
import type { View } from '../../src/scene/schema.ts';
import { material, scene } from '../pathtracer/scenes.ts';
import { frameMaker } from './effects/frames.ts';

const SIZE = 32;
const maker = await frameMaker({ width: SIZE, height: SIZE });

/** Two upright walls, one before a half of the other, lit by two lamps and a third that reaches the near one alone. */
const walls = (show: View['show']) =>
  scene({
    camera: { fov: 90, position: [0, 0, 4], target: [0, 0, 0], near: 0.1, far: 100 },
    view: { show },
    objects: {
      far: {
        name: 'far',
        material: 'm',
        position: [0, 0, 0],
        geometry: { type: 'plane', width: 6, height: 6 },
      },
      near: {
        name: 'near',
        material: 'm',
        position: [1.5, 0, 1],
        geometry: { type: 'plane', width: 3, height: 6 },
      },
    },
    lights: {
      a: { type: 'directional', illuminance: 1, position: [0, 0, 5], target: [0, 0, 0] },
      b: { type: 'directional', illuminance: 1, position: [1, 0, 5], target: [0, 0, 0] },
      behind: { type: 'directional', illuminance: 1, position: [0, 0, -5], target: [0, 0, 0] },
      between: { type: 'point', intensity: 10, position: [-1, 0, 0.5], range: 0, falloff: 'inverse-square' },
    },
    materials: { m: material('principled', { anisotropic: 0.5 }) },
  });

async function shown(show: View['show']) {
  const { pixels } = await maker.draw(walls(show));
  const at = (x: number, y: number) => [...pixels.subarray(4 * (y * SIZE + x), 4 * (y * SIZE + x) + 4)];
  // The far wall, the near one, the background.
  return { far: at(10, 16), near: at(20, 16), nothing: at(0, 0), at };
}

test('distances along the view, in metres', async () => {
  const { far, near, nothing } = await shown('depth');
  expect(far[0]).toBeCloseTo(4, 3);
  expect(near[0]).toBeCloseTo(3, 3);
  expect(nothing).toEqual([0, 0, 0, 0]);
});

test.each(['shadingNormals', 'meshNormals'] as const)('%s in world space', async (show) => {
  const { far, nothing } = await shown(show);
  for (const [i, expected] of [0, 0, 1, 1].entries()) expect(far[i]).toBeCloseTo(expected, 2);
  expect(nothing).toEqual([0, 0, 0, 0]);
});

test('tangents in world space', async () => {
  const { far } = await shown('tangents');
  for (const [i, expected] of [1, 0, 0, 1].entries()) expect(far[i]).toBeCloseTo(expected, 2);
});

test('texture coordinates', async () => {
  const { at } = await shown('textureCoordinates');
  // The far wall is 6 m wide, 4 m away, where the picture is 8 m wide: 24 pixels from the fifth on.
  expect(at(4, 16)[0]).toBeCloseTo(0.5 / 24, 2);
  expect(at(10, 16)[0]).toBeCloseTo(6.5 / 24, 2);
  expect(at(10, 10)[1]).toBeCloseTo(1 - 6.5 / 24, 2);
});

test('how often each pixel is drawn', async () => {
  const { far, near, nothing } = await shown('overdraw');
  // The near wall is drawn first and hides the other one.
  expect([far[0], near[0], nothing[0]]).toEqual([1, 1, 0]);
});

test('how many lamps reach each pixel', async () => {
  const { far, near, nothing } = await shown('lights');
  expect([far[0], near[0], nothing[0]]).toEqual([3, 2, 0]);
});

test('which of the sun’s shadow maps a pixel has, and how much of its surroundings is open', async () => {
  const lit = (show: View['show'], effects: object) => {
    const { effects: _, ...document } = walls(show);
    return scene({ ...document, lights: { sun: { ...document.lights.a } }, effects });
  };
  const at = ({ pixels }: { pixels: Float32Array }, x: number, y: number) => pixels[4 * (y * SIZE + x)]!;
  const none = await maker.draw(lit('cascades', { shadows: { enabled: false } }));
  expect(at(none, 10, 16)).toBe(0);
  const cascades = await maker.draw(lit('cascades', { shadows: { enabled: true } }));
  expect(at(cascades, 20, 16)).toBeGreaterThanOrEqual(1);
  expect(at(cascades, 10, 16)).toBeGreaterThanOrEqual(at(cascades, 20, 16));
  expect(at(await maker.draw(lit('ambientOcclusion', {})), 10, 16)).toBe(1);
  const open = await maker.draw(lit('ambientOcclusion', { ambientOcclusion: { enabled: true, radius: 3 } }));
  const seen = open.pixels.filter((_, i) => i % 4 === 0 && open.pixels[i + 3]! > 0);
  expect(Math.max(...seen)).toBeGreaterThan(0.95);
  expect(Math.max(...seen)).toBeLessThanOrEqual(1.001);
  expect(Math.min(...seen)).toBeLessThan(0.995);
  expect(Math.min(...seen)).toBeGreaterThan(0);
});

test('motion in pixels a frame, and none of what stands still', async () => {
  const { far } = await shown('motion');
  for (const [i, expected] of [0, 0, 0, 1].entries()) expect(far[i]).toBeCloseTo(expected);
  const mirror = await maker.mirror(walls('motion'));
  const size = { width: SIZE, height: SIZE };
  maker.renderer.render(mirror, walls('motion'), size);
  mirror.camera.position.x += 0.5;
  maker.renderer.render(mirror, walls('motion'), size);
  const { pixels } = await maker.renderer.readRadiance();
  mirror.dispose();
  const i = 4 * (16 * SIZE + 8);
  // Half a metre of 8 that 32 pixels show.
  expect([pixels[i], pixels[i + 1]]).toEqual([expect.closeTo(-2, 2), expect.closeTo(0, 2)]);
});

test('the picture itself is as it was, after any of them', async () => {
  const before = await maker.draw(walls('picture'));
  for (const show of ['textureCoordinates', 'overdraw', 'depth'] as const) await maker.draw(walls(show));
  expect(await maker.draw(walls('picture'))).toEqual(before);
});
