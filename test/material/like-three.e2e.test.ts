import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';
import type { Likeness } from './like-three.page.ts';

const harness = await pageHarness(new URL('./like-three.page.ts', import.meta.url));

test.each([
  ['webgpu', false],
  ['webgl', true],
])('in the browser on %s, maps and meshes look as with MeshLambertMaterial', async (name, forceWebGL) => {
  const { backend, features, whiteMaps } = await harness.run<Likeness>({ forceWebGL });
  expect(backend).toBe(name);
  expect(Object.keys(features)).toHaveLength(7);
  for (const [feature, { fromThree, fromPlain }] of Object.entries(features)) {
    expect(fromThree, feature).toBeLessThan(0.002);
    expect(fromPlain, feature).toBeGreaterThan(0.01);
  }
  expect(whiteMaps).toBe(0);
});
