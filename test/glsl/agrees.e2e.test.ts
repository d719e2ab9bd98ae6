import { expect, it } from 'vitest';
import { pageHarness } from '../support/page.ts';
import type { Comparison } from './comparison.ts';

/** agrees.gpu.test.ts on the other back end: WebGL 2, in a browser. */

const harness = await pageHarness(new URL('./agrees.page.ts', import.meta.url));

it('every model is the same on WebGL 2 as in float64', async () => {
  const comparisons = await harness.run<Record<string, Comparison>>(64);
  expect(Object.keys(comparisons).length).toBeGreaterThan(3);
  for (const [model, { worst, elsewhere }] of Object.entries(comparisons)) {
    for (const [name, { error, ...at }] of Object.entries(worst)) {
      expect.soft(error, `${model} ${name} ${JSON.stringify(at)}`).toBeLessThan(1e-3);
    }
    expect(elsewhere, model).toBeLessThan(2e-3);
  }
});
