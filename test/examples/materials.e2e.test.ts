import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { pageHarness } from '../support/page.ts';

const harness = await pageHarness(new URL('./materials.page.ts', import.meta.url));

test('the example draws five lit spheres with the package as it is built', async () => {
  const brightness = await harness.run<number[]>();
  // The background's is 0.14.
  for (const value of brightness) expect(value).toBeGreaterThan(0.18);
  expect(new Set(brightness).size).toBe(5);
});

test('the example is short', () => {
  const text = readFileSync(new URL('../../examples/materials.ts', import.meta.url), 'utf8');
  expect(text.split('\n').length).toBeLessThan(60);
});
