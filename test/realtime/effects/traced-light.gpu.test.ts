import { expect, test } from 'vitest';
import type { Document } from '../../../src/scene/schema.ts';
import { evenLight, material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, type Picture } from './frames.ts';
import { finite, meanError, meanWithin, reduced, traced } from './reference.ts';

const SIZE = { width: 48, height: 32 };
const SCALE = 2;
const maker = await frameMaker(SIZE);

const plane = (size: number, position: number[], rotation: number[], m: string) => ({
  name: 'plane',
  material: m,
  position,
  rotation,
  geometry: { type: 'plane', width: size, height: size },
});
const floor = (size: number) => plane(size, [0, 0, 0], [-90, 0, 0], 'floor');
const ball = (x = 0) => ({
  name: 'ball',
  material: 'ball',
  position: [x, 0.8, 0],
  geometry: { type: 'sphere', radius: 0.6, widthSegments: 96, heightSegments: 64 },
});
const camera = { fov: 35, position: [0, 1.2, 4.5], target: [0, 0.6, 0] };
const red = material('lambert', { albedo: [0.8, 0.1, 0.1] }, { doubleSided: true });
const metal = (roughness: number) =>
  material('principled', { baseColor: [0.9, 0.9, 0.9], metallic: 1, roughness });
const night = { background: { type: 'color', color: [0, 0, 0] } };

const withRays = (parts: object, group: object = {}): Document => {
  const traces = { enabled: true, ...group };
  return scene({
    ...parts,
    view: { resolutionScale: SCALE },
    effects: {
      antialiasing: { method: 'none' },
      shadows: { enabled: false },
      reflections: traces,
      indirectLight: traces,
    },
  });
};

/** Frames of a scene that nothing is known of before. */
async function drawn(document: Document, frames: number): Promise<Picture> {
  const picture = await maker.draw(document, frames);
  expect(finite(picture)).toBe(true);
  return picture;
}

/** Low, so that what the floor shows of the ball is what the camera sees, too. */
const lowCamera = { fov: 35, position: [0, 0.5, 4.5], target: [0, 0.5, 0] };
const overFloor = { ...evenLight, camera: lowCamera, objects: { floor: floor(8), ball: ball() } };
/** The reflection on the floor, at the reference's size. */
const below = (x: number, y: number) => x > 11 && x < 37 && y > 20;

test.each([
  ['a mirror', metal(0.05), 0.07],
  ['a metal of roughness .2', metal(0.2), 0.08],
  ['a metal of roughness .5', metal(0.5), 0.05],
])('%s reflects a ball as the path tracer shows it', async (_, m, most) => {
  const document = withRays({ ...overFloor, materials: { floor: m, ball: red } });
  const reference = await traced(document, SIZE, 48, 8);
  const { error } = meanError(reduced(await drawn(document, 8), SCALE), reference, below);
  expect(error).toBeLessThan(most);
});

test('a red wall tints a white floor as the path tracer shows it', async () => {
  const white = material('lambert', { albedo: [0.8, 0.8, 0.8] }, { doubleSided: true });
  const document = withRays({
    ...evenLight,
    camera: { fov: 35, position: [2.6, 1.6, 4], target: [0.2, 0.6, 0] },
    objects: { floor: floor(3), wall: plane(2, [-1, 1, 0], [0, 90, 0], 'ball') },
    materials: { floor: white, ball: red },
  });
  // Of the first frame that has one before it light has bounced once: two bounces of a path.
  const once = meanError(reduced(await drawn(document, 2), SCALE), await traced(document, SIZE, 64, 2));
  const often = meanError(reduced(await drawn(document, 10), SCALE), await traced(document, SIZE, 48, 8));
  expect(once.error).toBeLessThan(0.03);
  expect(often.error).toBeLessThan(0.02);
  expect(Math.abs(often.bias)).toBeLessThan(0.01);
});

test('what glows lights its surroundings where there is no lamp and no sky', async () => {
  const glow = material('lambert', { albedo: [0.5, 0.5, 0.5] }, { emissive: [1, 0.3, 0.1] });
  const gloss = material('principled', { baseColor: [0.5, 0.5, 0.5], roughness: 0.3 });
  const document = withRays({
    ...night,
    camera,
    objects: { floor: floor(8), ball: ball() },
    materials: { floor: gloss, ball: glow },
  });
  const { error, bias } = meanError(
    reduced(await drawn(document, 8), SCALE),
    await traced(document, SIZE, 48, 8),
  );
  // The underside of the ball, which lights the floor below it, is not in the picture.
  expect(error).toBeLessThan(0.12);
  expect(bias).toBeLessThan(0);
});

test('a ball that has moved leaves nothing behind', async () => {
  const at = (x: number) =>
    withRays({
      ...overFloor,
      objects: { floor: floor(8), ball: ball(x) },
      materials: { floor: metal(0.3), ball: red },
    });
  const mirror = await maker.mirror(at(-1));
  maker.renderer.cut();
  for (let x = -1; x <= 0.81; x += 0.2) {
    const document = at(x);
    mirror.apply(document);
    maker.renderer.render(mirror, document, SIZE);
  }
  const moved = await maker.renderer.readRadiance();
  for (let i = 0; i < 4; i++) maker.renderer.render(mirror, at(0.8), SIZE);
  const later = await maker.renderer.readRadiance();
  mirror.dispose();
  const fresh = await drawn(at(0.8), 12);
  const empty = await drawn(
    withRays({ ...overFloor, objects: { floor: floor(8) }, materials: { floor: metal(0.3) } }),
    2,
  );
  // Where it was and is not any more.
  const left = (x: number, y: number) => x < 48 && y > 35;
  expect(meanError(moved, empty, left).error).toBeLessThan(0.004);
  // Nor is there a trail of a few pixels, four frames later.
  let farthest = 0;
  for (let i = 0; i < later.pixels.length; i++) {
    const [x, y] = [(i >> 2) % later.width, Math.floor((i >> 2) / later.width)];
    if (left(x, y)) farthest = Math.max(farthest, Math.abs(later.pixels[i]! - fresh.pixels[i]!));
  }
  expect(farthest).toBeLessThan(0.06);
  const behind = (x: number, y: number) => x < 60 && y > 35;
  expect(meanError(moved, fresh, behind).error).toBeLessThan(0.02);
});

test('a floor with nothing on it is as without rays; switched off, nothing changes', async () => {
  const parts = { ...evenLight, camera, objects: { floor: floor(8) }, materials: { floor: metal(0.3) } };
  const off = await drawn(withRays(parts, { enabled: false }), 1);
  const on = await drawn(withRays(parts), 3);
  expect(on.pixels).toEqual(off.pixels);
});

/** As the BRDF Explorer's files are written. */
const stranger = `analytic
::begin parameters
color diffuse .3 .3 .3
float n 1 1000 40
::end parameters
::begin shader
const float PI = 3.14159265358979323846;
vec3 BRDF( vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y )
{
    vec3 H = normalize(L+V);
    float val = pow(max(0,dot(N,H)),n) * (n+2) / (8*PI);
    return diffuse/PI + vec3(.6*val);
}
::end shader
`;

test('a model from a file of Disney’s format traces rays as well', async () => {
  const parts = {
    ...overFloor,
    models: { stranger: { source: stranger } },
    materials: { floor: material('stranger'), ball: material('lambert', { albedo: [0.8, 0.1, 0.1] }) },
  };
  const on = meanWithin(reduced(await drawn(withRays(parts), 6), SCALE), below);
  const off = meanWithin(reduced(await drawn(withRays(parts, { enabled: false }), 1), SCALE), below);
  // The path tracer's floor is 7 % darker than one that sees the sky alone.
  expect(on / off).toBeGreaterThan(0.9);
  expect(on / off).toBeLessThan(0.96);
});
