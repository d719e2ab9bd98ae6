import { expect, test } from 'vitest';
import { pageHarness } from './page.ts';

const harness = await pageHarness(new URL('./triangle.page.ts', import.meta.url));

test.each([
  ['webgpu', false],
  ['webgl', true],
])('a browser draws a triangle on %s', async (backend, forceWebGL) => {
  const result = await harness.run<{ backend: string; green: number[] }>({ forceWebGL });
  expect(result.backend).toBe(backend);
  const lit = result.green.filter((value) => value === 255).length;
  expect(lit).toBeGreaterThanOrEqual(28);
  expect(lit).toBeLessThanOrEqual(36);
});
