import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { writeMerl } from '../io/merl-writer.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, drawSurface, LIGHT_CASES, SIZE, sphereGeometry, surfaceAt } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const surfaces = await drawSurface(renderer, geometry);

const model = shippedModels.get('cook-torrance') as Model;
const values = { roughness: 0.25, kd: 0.3, ior: 1.8 };
const evaluator = createEvaluator(model, values);
const measured = loadMeasured(
  writeMerl((L, V) => evaluator.f(L, V)),
  'gloss.binary',
);

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
