import * as THREE from 'three/webgpu';
import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { writeCsail } from '../io/csail-writer.ts';
import { writeMerl } from '../io/merl-writer.ts';
import { writeRgl } from '../io/rgl-writer.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, drawSurface, LIGHT_CASES, SIZE, sphereGeometry, surfaceAt } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const surfaces = await drawSurface(renderer, geometry);

const model = shippedModels.get('cook-torrance') as Model;
const values = { roughness: 0.25, kd: 0.3, ior: 1.8 };
const merl = writeMerl(createQuickEvaluator(model, values).term('BRDF'));
const measured = loadMeasured(merl, 'gloss.binary');

test.each(Object.keys(LIGHT_CASES))(
  'a MERL file lights a sphere like the model it samples: %s',
  async (name) => {
    const light = LIGHT_CASES[name] as (typeof LIGHT_CASES)[string];
    const draw = (material: BrdfMaterial) => drawSphere(renderer, geometry, material, light.create());
    const expected = await draw(new BrdfMaterial(model, values));
    const got = await draw(new BrdfMaterial(measured));
    let [count, worst] = [0, 0];
    for (let i = 0; i < SIZE * SIZE; i++) {
      const surface = surfaceAt(surfaces, i % SIZE, Math.floor(i / SIZE));
      if (!surface) continue;
      const { V, frame, point } = surface;
      const cosV = V.reduce((sum, c, k) => sum + c * (frame.N[k] as number), 0);
      if (cosV < 0.25 || light.jumps?.(point)) continue;
      count++;
      for (let c = 0; c < 3; c++) {
        const [a, b] = [expected[i * 4 + c] as number, got[i * 4 + c] as number];
        worst = Math.max(worst, Math.abs(a - b) / Math.max(a, 1e-2));
      }
    }
    expect(count).toBeGreaterThan(3000);
    expect(worst).toBeLessThan(0.02);
  },
);

const matte = createQuickEvaluator(shippedModels.get('principled') as Model, {
  roughness: 0.8,
  anisotropic: 0.5,
}).term('BRDF');
/** A file of each format, by the name that tells it. */
const files: Record<string, () => Uint8Array> = {
  'gloss.binary': () => merl,
  'isotropic.bsdf': () => writeRgl(matte, { thetas: 8, resolution: 24 }),
  'anisotropic.bsdf': () => writeRgl(matte, { thetas: 4, phis: 5, symmetry: 2, resolution: 12 }),
  'brushed.dat': () => writeCsail(matte, { bins: [10, 10, 24, 12] }),
};

test.each(Object.keys(files))('the GPU’s lookup is the float64 one in every pixel: %s', async (name) => {
  const light = LIGHT_CASES.directional as (typeof LIGHT_CASES)[string];
  const model = loadMeasured((files[name] as () => Uint8Array)(), name);
  const pixels = await drawSphere(renderer, geometry, new BrdfMaterial(model), light.create());
  const lookup = createEvaluator(model);
  let [worst, lit] = [0, 0];
  for (let i = 0; i < SIZE * SIZE; i++) {
    const surface = surfaceAt(surfaces, i % SIZE, Math.floor(i / SIZE));
    const arriving = surface && light.arrives(surface.point);
    if (!surface || !arriving) continue;
    const { V, frame } = surface;
    const cosine = (w: typeof V) => w.reduce((sum, c, k) => sum + c * (frame.N[k] as number), 0);
    if (cosine(V) < 0.25) continue;
    const f = lookup.f(arriving.l, V, frame);
    f.forEach((x, c) => {
      const expected = x * arriving.E * Math.max(cosine(arriving.l), 0);
      lit += expected;
      worst = Math.max(worst, Math.abs((pixels[i * 4 + c] as number) - expected) / Math.max(expected, 1e-3));
    });
  }
  expect(lit).toBeGreaterThan(100);
  expect(worst).toBeLessThan(1e-3);
});

test('an environment lights it like the model too, by the generic sampler', async () => {
  // Brighter above and to one side, so that the highlight's place counts.
  const data = new Float32Array(16 * 8 * 4).map((_, i) =>
    i % 4 === 3 ? 1 : 1 + Math.cos(((i >> 2) % 16) / 2.6),
  );
  const environment = new THREE.DataTexture(data, 16, 8, THREE.RGBAFormat, THREE.FloatType);
  environment.mapping = THREE.EquirectangularReflectionMapping;
  environment.minFilter = environment.magFilter = THREE.LinearFilter;
  environment.needsUpdate = true;
  const draw = (material: BrdfMaterial) => drawSphere(renderer, geometry, material, [], environment);
  const expected = await draw(new BrdfMaterial(model, values));
  const got = await draw(new BrdfMaterial(measured));
  let [difference, sum] = [0, 0];
  for (let i = 0; i < SIZE * SIZE; i++) {
    const surface = surfaceAt(surfaces, i % SIZE, Math.floor(i / SIZE));
    if (!surface || surface.V.reduce((s, c, k) => s + c * (surface.frame.N[k] as number), 0) < 0.25) continue;
    for (let c = 0; c < 3; c++) {
      difference += Math.abs((got[i * 4 + c] as number) - (expected[i * 4 + c] as number));
      sum += expected[i * 4 + c] as number;
    }
  }
  expect(sum).toBeGreaterThan(100);
  expect(difference / sum).toBeLessThan(0.02);
});
