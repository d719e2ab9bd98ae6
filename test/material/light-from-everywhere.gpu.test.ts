import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { loadModel } from '../../models/index.ts';
import { integrateHemisphere } from '../../src/analysis/quadrature.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import type { Frame, Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, drawSurface, modelNamed, SIZE, sphereGeometry, surfaceAt } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const surfaces = await drawSurface(renderer, geometry);

/** A model of a stranger: no sampler of its own. */
const imported = loadModel(
  `analytic
::begin parameters
float n 1 1000 60
color tint .9 .5 .2
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  vec3 H = normalize(L + V);
  return tint * .3 / 3.14159265 + (n + 8) / (8 * 3.14159265) * pow(max(0, dot(N, H)), n) * .5;
}
::end shader`,
  'stranger.brdf',
);

const CASES: Readonly<Record<string, { model: Model; values: Record<string, unknown> }>> = {
  lambert: { model: modelNamed('lambert'), values: {} },
  principled: { model: modelNamed('principled'), values: {} },
  'principled, a polished metal': {
    model: modelNamed('principled'),
    values: { metallic: 1, roughness: 0.15 },
  },
  'principled, every lobe': {
    model: modelNamed('principled'),
    values: { subsurface: 0.6, sheen: 1, clearcoat: 1, roughness: 0.6 },
  },
  'cook-torrance': { model: modelNamed('cook-torrance'), values: { roughness: 0.4 } },
  'a model without a sampler': { model: imported, values: {} },
};

/** Pixels across the sphere, down to grazing views (cosines from 1 to 0.2). */
const PIXELS = [48, 60, 70, 78, 82].map((x) => [x, 44] as const);

/**
 * The reflected radiance by quadrature, for light of this radiance from each direction in world space. In float32, whose
 * rounding is a hundredth of the least tolerance.
 */
function reflected(
  model: Model,
  values: Record<string, unknown>,
  V: Vector3,
  frame: Frame,
  radiance: (l: Vector3) => number,
  tolerance: number,
): Vector3 {
  const reflect = createQuickEvaluator(model, values).term('BRDF');
  const toFrame = (w: Vector3): Vector3 =>
    [frame.X, frame.Y, frame.N].map(
      (axis) => axis[0] * w[0] + axis[1] * w[1] + axis[2] * w[2],
    ) as unknown as Vector3;
  const toWorld = (w: Vector3): Vector3 =>
    [0, 1, 2].map(
      (c) => w[0] * (frame.X[c] as number) + w[1] * (frame.Y[c] as number) + w[2] * (frame.N[c] as number),
    ) as unknown as Vector3;
  const v = toFrame(V);
  const { value } = integrateHemisphere(
    (l) => {
      const f = reflect(l, v);
      const weight = l[2] * radiance(toWorld(l));
      return [f[0] * weight, f[1] * weight, f[2] * weight];
    },
    { tolerance, maxEvaluations: 50_000, focus: [[-v[0], -v[1], v[2]], v, toFrame([0, 1, 0])] },
  );
  return value as unknown as Vector3;
}

function environmentOf(radiance: (y: number) => number): THREE.DataTexture {
  const [width, height] = [256, 128];
  const data = new Float32Array(width * height * 4);
  for (let row = 0; row < height; row++) {
    const y = Math.sin(((row + 0.5) / height - 0.5) * Math.PI);
    for (let x = 0; x < width; x++)
      data.set([radiance(y), radiance(y), radiance(y), 1], (row * width + x) * 4);
  }
  const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.FloatType);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

async function expectReflected(
  name: string,
  tolerance: number,
  radiance: (l: Vector3) => number,
  environment: THREE.Texture,
  places: readonly (readonly [number, number])[] = PIXELS,
): Promise<void> {
  const { model, values } = CASES[name] as (typeof CASES)[string];
  const pixels = await drawSphere(renderer, geometry, new BrdfMaterial(model, values), [], environment);
  for (const [x, y] of places) {
    const { V, frame } = surfaceAt(surfaces, x, y) as NonNullable<ReturnType<typeof surfaceAt>>;
    const expected = reflected(model, values, V, frame, radiance, Math.min(tolerance / 10, 2e-3));
    for (let c = 0; c < 3; c++) {
      const got = pixels[(y * SIZE + x) * 4 + c] as number;
      const error = Math.abs(got / (expected[c] as number) - 1);
      expect(error, `pixel ${x}, ${y}: ${got} is not ${expected[c]}`).toBeLessThan(tolerance);
    }
  }
}

describe.each(Object.keys(CASES))('%s', (name) => {
  // The table is within 1e-3; the quadrature that it is held to is asked for 1e-4.
  test('in a white furnace reflects its directional albedo', () =>
    expectReflected(
      name,
      0.0015,
      () => 1,
      environmentOf(() => 1),
    ));

  test('under a sky that brightens upward reflects what quadrature says', () =>
    expectReflected(
      name,
      0.02,
      (l) => 1 + 0.8 * l[1],
      environmentOf((y) => 1 + 0.8 * y),
    ));
});

/** A sun of 15 degrees' width (at half of its radiance), 60 times as bright as its sky, overhead. */
const sunny = (y: number) => 0.3 + 18 * Math.exp(40 * (y - 1));
/** Pixels from the middle to where the sphere reflects the sun, and past it. */
const UPWARDS = [44, 34, 28, 24, 20, 14].map((y) => [48, y] as const);

test.each([
  // A smooth surface's samples are close together; a matte one's 32 are 25 degrees apart, twice the sun's width.
  ['principled, a polished metal', 0.05],
  ['lambert', 0.2],
  ['cook-torrance', 0.25],
  ['principled', 0.4],
] as const)('%s under a sun errs by no more than is known', (name, tolerance) =>
  expectReflected(name, tolerance, ([, y]) => sunny(y), environmentOf(sunny), UPWARDS),
);

test('a material may have an environment of its own, turned and scaled', async () => {
  const environment = environmentOf((y) => 1 + 0.8 * y);
  const material = new BrdfMaterial(modelNamed('principled'), { roughness: 0.3 });
  const fromScene = await drawSphere(renderer, geometry, material, [], environment);
  const own = new BrdfMaterial(modelNamed('principled'), { roughness: 0.3 });
  own.envMap = environment;
  expect(await drawSphere(renderer, geometry, own, [])).toEqual(fromScene);
  own.envMapIntensity = 2;
  const bright = await drawSphere(renderer, geometry, own, []);
  const middle = (SIZE / 2) * SIZE * 4 + (SIZE / 2) * 4;
  expect((bright[middle] as number) / (fromScene[middle] as number)).toBeCloseTo(2, 3);
});
