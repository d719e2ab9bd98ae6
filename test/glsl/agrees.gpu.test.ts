import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { cornerParameters, hostilePairs } from '../models/hostile.ts';
import { testRenderer } from '../support/gpu.ts';
import { compare, functionsOf, randomPoints, roundToFloat32 } from './comparison.ts';
import { evaluateOnGpu } from './gpu-evaluation.ts';

/**
 * A model on the GPU = the model in float64, for the same float32 inputs: every term, pdf() and sampleL().
 *
 * The relative error allowed is 1e-3; seen were 2e-4 (cook-torrance's pdf far out in its exponential) and
 * below 5e-5 elsewhere, peaks of roughness 0 included.
 */

const { renderer } = await testRenderer(4, 4);

describe.each([...shippedModels])('%s', (_name, model) => {
  const functions = functionsOf(model);

  it('is the same on the GPU as in float64, at random directions and parameters', async () => {
    const points = randomPoints(model, 4096);
    const { worst, elsewhere } = compare(
      model,
      points,
      await evaluateOnGpu(renderer, model, functions, points),
    );
    for (const [name, { error, ...at }] of Object.entries(worst)) {
      expect.soft(error, `${name} ${JSON.stringify(at)}`).toBeLessThan(1e-3);
    }
    // A sample on the border between two lobes, or at the horizon, may fall to either side.
    expect(elsewhere).toBeLessThan(2e-3);
  });

  it('is finite and not negative on the GPU wherever its formulas might not be', async () => {
    const pairs = hostilePairs();
    const points = cornerParameters(model.parameters, 4).flatMap((parameters) =>
      pairs.map(([l, v]) => roundToFloat32({ l, v, u: [0.5, 0.5], parameters })),
    );
    const names = functions.filter((name) => name !== 'sampleL');
    const results = await evaluateOnGpu(renderer, model, names, points);
    for (const name of names) {
      for (const [i, value] of results.get(name)!.entries()) {
        if (!value.every((x) => x >= 0 && Number.isFinite(x))) {
          expect.soft(value, `${name} ${JSON.stringify(points[i])}`).toBe('finite and not negative');
          break;
        }
      }
    }
  });
});
