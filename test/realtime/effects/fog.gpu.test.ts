import { describe, expect, test } from 'vitest';
import { material, scene } from '../../pathtracer/scenes.ts';
import { frameMaker, type Picture } from './frames.ts';
import { finite, meanError, reduced, traced } from './reference.ts';

/** Fog against the path tracer, whose paths of one scattering see what the effect computes. */

const [WIDTH, HEIGHT] = [48, 32];
const size = { width: WIDTH, height: HEIGHT };
const maker = await frameMaker(size);

const lights = {
  spot: {
    type: 'spot',
    intensity: 120,
    position: [0, 4.6, -1],
    target: [0, 0, 0.2],
    cutoff: 18,
    penumbra: 0.3,
    radius: 0,
  },
  sun: { type: 'directional', illuminance: 6, position: [2, 4, 1], angularDiameter: 0 },
  point: { type: 'point', intensity: 40, position: [1.4, 4.4, 0.4], radius: 0 },
  rectangle: {
    type: 'rectangle',
    luminance: 20,
    position: [-1.5, 4.2, 0],
    target: [0, 0.6, 0],
    width: 1,
    height: 0.5,
  },
};

const objects = {
  floor: {
    name: 'floor',
    material: 'm',
    rotation: [-90, 0, 0],
    geometry: { type: 'plane', width: 8, height: 8 },
  },
  ball: {
    name: 'ball',
    material: 'm',
    position: [0.15, 1.5, -0.4],
    geometry: { type: 'sphere', radius: 0.45, widthSegments: 96, heightSegments: 48 },
  },
};

const stage = (light: object, fog: object, effects: object = {}) =>
  scene({
    camera: { fov: 50, position: [0, 1.6, 5.5], target: [0, 1.3, 0] },
    background: { type: 'color', color: [0.05, 0.06, 0.08] },
    objects,
    materials: { m: material('lambert', { albedo: [0.5, 0.45, 0.4] }, { doubleSided: true }) },
    lights: { light },
    fog: { density: 0.12, color: [0.9, 0.8, 0.7], anisotropy: 0, ...fog },
    effects: {
      shadows: { enabled: true, resolution: 512 },
      fog: { steps: 32, halfResolution: false },
      ...effects,
    },
  });

/** Blocks of pixels hide the noise of both, and the edges that half the resolution softens. */
async function compared(document: ReturnType<typeof stage>, samples = 128) {
  const shown = await maker.draw(document);
  expect(finite(shown)).toBe(true);
  const reference = await traced(document, size, samples, 1);
  return meanError(reduced(shown, 4), reduced(reference, 4));
}

describe('the light of lamps in fog, once scattered', () => {
  test.each([
    ['spot', 0.6, {}],
    ['sun', 0, {}],
    ['point', 0, {}],
    ['rectangle', 0, {}],
    ['sun', 0.6, { height: 0.8, base: 0.4, density: 0.4 }],
  ] as const)('%s, anisotropy %f, %o', async (kind, anisotropy, fog) => {
    const { bias, error } = await compared(stage(lights[kind], { anisotropy, ...fog }));
    expect(Math.abs(bias)).toBeLessThan(0.01);
    // Most of it is noise of the paths: those that meet the spot's cone are few.
    expect(error).toBeLessThan(kind === 'spot' ? 0.06 : 0.02);
  });
});

/** One colour channel of a pixel, from the left and the top. */
const at = ({ width, pixels }: Picture, x: number, y: number, channel = 0) =>
  pixels[4 * (y * width + x) + channel]!;

test('half the resolution shows the same, softer', async () => {
  const document = stage(lights.spot, { anisotropy: 0.6 });
  const half = scene({
    ...document,
    effects: { ...document.effects, fog: { steps: 32, halfResolution: true } },
  });
  const whole = await maker.draw(document);
  const { bias, error } = meanError(reduced(await maker.draw(half), 4), reduced(whole, 4));
  expect(Math.abs(bias)).toBeLessThan(0.03);
  expect(error).toBeLessThan(0.05);
});

describe('what fog takes', () => {
  const wall = (fog: object) =>
    scene({
      camera: { fov: 2, position: [0, 0, 4], target: [0, 0, 0] },
      background: { type: 'color', color: [0, 0, 0] },
      objects: {
        wall: { name: 'wall', material: 'm', geometry: { type: 'plane', width: 20, height: 20 } },
      },
      materials: {
        m: material('lambert', { albedo: [0, 0, 0] }, { emissive: [1, 1, 1], emissiveIntensity: 1 }),
      },
      fog,
    });

  test('is exp(-sigma d) where nothing is scattered', async () => {
    const picture = await maker.draw(wall({ density: 0.3, color: [0, 0, 0] }));
    expect(at(picture, 24, 16)).toBeCloseTo(Math.exp(-0.3 * 4), 3);
  });

  test('is nothing where there is none: not a bit is another', async () => {
    const plain = await maker.draw(wall({ density: 0 }));
    const off = scene({ ...wall({ density: 0.3 }), effects: { fog: { enabled: false } } });
    expect((await maker.draw(off)).pixels).toEqual(plain.pixels);
  });

  test('falls with height as the path tracer says', async () => {
    const fog = { density: 0.5, color: [0, 0, 0], height: 0.7, base: -1 };
    const picture = await maker.draw(wall(fog));
    const density = 0.5 * Math.exp(-1 / 0.7);
    expect(at(picture, 24, 16)).toBeCloseTo(Math.exp(-density * 4), 2);
  });
});

test('light from everywhere, scattered and never absorbed, is as bright as without fog', async () => {
  const even = scene({
    camera: { fov: 40, position: [0, 1, 4], target: [0, 0.5, 0] },
    background: { type: 'environment', blur: 0 },
    environment: { source: { type: 'constant', color: [1, 1, 1] } },
    objects,
    materials: { m: material('lambert', { albedo: [1, 1, 1] }) },
    fog: { density: 0.4, color: [1, 1, 1] },
  });
  const { pixels } = await maker.draw(even);
  const colors = pixels.filter((_, i) => i % 4 < 3);
  expect(colors.every((x) => Math.abs(x - 1) < 0.02)).toBe(true);
});
