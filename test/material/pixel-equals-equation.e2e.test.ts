import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import { albedoCurve, BROAD_LIGHTS, STRIDE } from './broad-light.ts';
import type { CaseResult, Order } from './lit-sphere.page.ts';
import { LIGHT_CASES, MATERIAL_CASES } from './lit-sphere.ts';

/** Three of the materials: the fourth, a rough one, differs from them by less than they do from one another. */
const curves = Object.fromEntries(
  ['lambert', 'cook-torrance', 'principled, smooth'].map((name) => [name, albedoCurve(name)]),
);
const harness = await pageHarness(new URL('./lit-sphere.page.ts', import.meta.url));

// On WebGPU the same is tested in Node.
test('in the browser on WebGL 2, every pixel is the shading equation', async () => {
  const { backend, results } = await harness.run<{ backend: string; results: CaseResult[] }>({
    forceWebGL: true,
    curves,
  } satisfies Order);
  expect(backend).toBe('webgl');
  const fromOneDirection = Object.keys(LIGHT_CASES).length * Object.keys(MATERIAL_CASES).length;
  const fromMany = Object.keys(BROAD_LIGHTS).length * Object.keys(curves).length;
  expect(results).toHaveLength(fromOneDirection + fromMany);
  for (const { light, material, count, jumps, worst, where } of results) {
    expect(count).toBeGreaterThan(light in LIGHT_CASES ? 3000 : 3000 / STRIDE ** 2);
    expect(jumps / count).toBeLessThan(0.05);
    expect(worst, `${material} under ${light}: ${where}`).toBeLessThan(1e-3);
  }
});
