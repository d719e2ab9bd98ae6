import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import type { CaseResult } from './lit-sphere.page.ts';
import { LIGHT_CASES, MATERIAL_CASES } from './lit-sphere.ts';

const harness = await pageHarness(new URL('./lit-sphere.page.ts', import.meta.url));

test.each([
  ['webgpu', false],
  ['webgl', true],
])('in the browser on %s, every pixel is the shading equation', async (name, forceWebGL) => {
  const { backend, results } = await harness.run<{ backend: string; results: CaseResult[] }>({ forceWebGL });
  expect(backend).toBe(name);
  expect(results).toHaveLength(Object.keys(LIGHT_CASES).length * Object.keys(MATERIAL_CASES).length);
  for (const { light, material, count, worst, where } of results) {
    expect(count).toBeGreaterThan(3000);
    expect(worst, `${material} under ${light}: ${where}`).toBeLessThan(1e-3);
  }
});
