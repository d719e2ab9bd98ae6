import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import type { DeformedResult } from './deformed-mesh.ts';

const harness = await pageHarness(new URL('./deformed-mesh.page.ts', import.meta.url));

test.each([
  ['WebGPU', false],
  ['WebGL 2', true],
])('instances, bones and morph targets move a mesh in the browser on %s', async (_, forceWebGL) => {
  const results = await harness.run<DeformedResult[]>({ forceWebGL });
  expect(results).toHaveLength(6);
  for (const { deformation, material, count, different } of results) {
    expect(count).toBeGreaterThan(1000);
    expect(different, `${deformation}, ${material}`).toBeLessThan(0.01);
  }
});
