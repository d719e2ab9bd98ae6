/** The camera's effects on both back ends of three.js. */
import { beforeAll, expect, test } from 'vitest';
import { material } from '../../pathtracer/scenes.ts';
import { pageHarness } from '../../support/page.ts';
import type { EffectsFrames, EffectsRequest } from './back-ends.page.ts';

const harness = await pageHarness(new URL('./back-ends.page.ts', import.meta.url));

/** A lit sphere before a pattern of light, with something nearer at the left. */
const document = (effects: object, view: object = {}): Record<string, unknown> => ({
  format: 'irradia',
  version: 1,
  camera: { fov: 40, position: [0, 0, 4], target: [0, 0, 0], fStop: 0.2, shutter: 1 / 60 },
  lights: { sun: { type: 'directional', illuminance: 4, position: [2, 3, 4], target: [0, 0, 0] } },
  objects: {
    sphere: { material: 'matte', geometry: { type: 'sphere', radius: 0.5 } },
    near: {
      material: 'lamp',
      position: [-0.7, 0.3, 1.5],
      geometry: { type: 'plane', width: 0.4, height: 0.3 },
    },
    far: {
      material: 'lamp',
      position: [0.8, -0.6, -2],
      geometry: { type: 'plane', width: 0.8, height: 0.9 },
    },
  },
  materials: {
    matte: material('principled', { baseColor: [0.6, 0.3, 0.2] }),
    lamp: material('lambert', {}, { emissive: [0.2, 0.5, 1], emissiveIntensity: 2 }),
  },
  effects: { antialiasing: { method: 'none' }, ...effects },
  view: { toneMapping: 'none', ...view },
});

const cases: Record<string, ReturnType<typeof document>> = {
  none: document({}),
  temporal: document({ antialiasing: { method: 'temporal' } }),
  smaa: document({ antialiasing: { method: 'smaa' } }),
  fxaa: document({ antialiasing: { method: 'fxaa' } }),
  'depth of field': document({ depthOfField: { enabled: true } }),
  'motion blur': document({ motionBlur: { enabled: true } }),
  lens: document({
    bloom: { enabled: true, strength: 0.2 },
    lens: { enabled: true, dispersion: 0.02, dirt: 0.5, vignette: 1 },
  }),
  'automatic exposure': document({}, { exposureMode: 'auto' }),
  'false colour': document({}, { show: 'luminance' }),
  'shadows on the ground': {
    ...document({ shadows: { enabled: true } }),
    ground: { shadowCatcher: true },
    environment: { source: { type: 'constant', color: [1, 0.8, 0.6] }, samples: 4 },
    background: { type: 'color', color: [0.5, 0.5, 0.5] },
    camera: { fov: 50, position: [0.4, 3, 4], target: [0, -0.8, -0.4], fStop: 0 },
  },
  ...Object.fromEntries(
    ['depth', 'shadingNormals', 'meshNormals', 'motion', 'lights'].map((show) => [
      show,
      document({}, { show }),
    ]),
  ),
};

const size = { width: 96, height: 64 };
let webgpu: EffectsFrames;
let webgl: EffectsFrames;

beforeAll(async () => {
  const draw = (forceWebGL: boolean) =>
    harness.run<EffectsFrames>({
      forceWebGL,
      documents: Object.values(cases),
      size,
    } satisfies EffectsRequest);
  webgpu = await draw(false);
  webgl = await draw(true);
});

test('both back ends are what they say', () => {
  expect([webgpu.backend, webgl.backend]).toEqual(['webgpu', 'webgl']);
});

test.each(Object.keys(cases))('%s: the same on both', (name) => {
  const i = Object.keys(cases).indexOf(name);
  const [a, b] = [webgpu.frames[i]!, webgl.frames[i]!];
  const share = (x: number[], y: number[], tolerance: number) =>
    x.filter((value, k) => Math.abs(value - y[k]!) > tolerance).length / x.length;
  // At edges the two rasterisers may differ by a pixel.
  expect(share(a.radiance, b.radiance, 0.02)).toBeLessThan(0.02);
  expect(share(a.image, b.image, 4)).toBeLessThan(0.02);
  expect(a.exposure).toBeCloseTo(b.exposure, 1);
  expect([...a.radiance, ...b.radiance].every(Number.isFinite)).toBe(true);
});

test.each(['temporal', 'smaa', 'fxaa', 'depth of field', 'motion blur', 'lens', 'automatic exposure'])(
  '%s changes the picture',
  (name) => {
    const i = Object.keys(cases).indexOf(name);
    expect(webgl.frames[i]!.image).not.toEqual(webgl.frames[0]!.image);
  },
);
