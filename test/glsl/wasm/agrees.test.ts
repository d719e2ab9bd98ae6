import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import type { Vec3 } from '../../../src/analysis/vector.ts';
import { LOCAL_FRAME } from '../../../src/glsl/evaluator.ts';
import { compare, functionsOf, randomPoints } from '../comparison.ts';
import { modelCalls } from './calls.ts';

/** As agrees.gpu.test.ts, with the same bounds: a model as WebAssembly = the model in float64. */
describe.each([...shippedModels])('%s', (_name, model) => {
  it('is the same as WebAssembly as in float64, at random directions and parameters', () => {
    const functions = functionsOf(model);
    const points = randomPoints(model, 2048);
    const call = modelCalls(model, functions);
    const { N, X, Y } = LOCAL_FRAME;
    const results = new Map(
      functions.map((name) => {
        const values = points.map(({ l, v, u, parameters }) => {
          const value = call(name, parameters, name === 'sampleL' ? u : l, v, N, X, Y);
          return (value.length === 1 ? [value[0], value[0], value[0]] : value) as unknown as Vec3;
        });
        return [name, values] as const;
      }),
    );
    const { worst, elsewhere } = compare(model, points, results);
    for (const [name, { error, ...at }] of Object.entries(worst)) {
      expect.soft(error, `${name} ${JSON.stringify(at)}`).toBeLessThan(1e-3);
    }
    expect(elsewhere).toBeLessThan(2e-3);
  });
});
