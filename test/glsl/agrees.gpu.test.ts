import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { cornerParameters, hostilePairs, randomDirection, randomParameters } from '../models/hostile.ts';
import { testRenderer } from '../support/gpu.ts';
import { evaluateOnGpu, type Point, roundToFloat32 } from './gpu-evaluation.ts';

/**
 * A model on the GPU = the model in float64, for the same float32 inputs: every term, pdf() and sampleL().
 */

const { renderer } = await testRenderer(4, 4);

/** Relative error allowed where a value is above `floor`, and the absolute one below it. */
const TOLERANCE = 1e-3;
const FLOOR = 1e-4;

const POINTS = 4096;

function disagreement(gpu: number, cpu: number): number {
  return Math.abs(gpu - cpu) / Math.max(Math.abs(cpu), FLOOR);
}

describe.each([...shippedModels])('%s', (_name, model) => {
  const functions = [...model.terms, ...(model.hasSampling ? ['pdf', 'sampleL'] : [])];
  const evaluator = createEvaluator(model);

  it('is the same on the GPU as in float64, at random directions and parameters', async () => {
    const random = createRandom(51);
    const points = Array.from({ length: POINTS }, (_, i): Point => {
      const parameters = randomParameters(random, model.parameters);
      const v = randomDirection(random, 1e-3);
      const u = [random(), random()] as const;
      // Every other point lies where the model reflects most: in a peak, if it has one.
      evaluator.set(parameters);
      const sampled = i % 2 === 0 ? evaluator.sampleL(u, v) : null;
      return roundToFloat32({ l: sampled ?? randomDirection(random, 1e-3), v, u, parameters });
    });
    const results = await evaluateOnGpu(renderer, model, functions, points);
    const worst = new Map<string, { error: number; gpu: unknown; cpu: unknown; point: unknown }>();
    let elsewhere = 0;
    for (const [i, point] of points.entries()) {
      const { l, v, u, parameters } = point;
      evaluator.set(parameters);
      for (const name of functions) {
        const gpu = results.get(name)![i]!;
        if (name === 'sampleL') {
          const cpu = evaluator.sampleL(u, v) ?? [0, 0, 0];
          if (!cpu.every((value, c) => Math.abs(value - gpu[c]!) < 1e-3)) elsewhere++;
          continue;
        }
        const density = name === 'pdf' ? evaluator.pdf(l, v) : 0;
        const cpu = name === 'pdf' ? [density, density, density] : evaluator.f(l, v, undefined, name);
        const error = Math.max(...cpu.map((value, c) => disagreement(gpu[c]!, value)));
        if (!(error <= (worst.get(name)?.error ?? -1))) worst.set(name, { error, gpu, cpu, point });
      }
    }
    for (const [name, { error, ...at }] of worst)
      expect.soft(error, `${name} ${JSON.stringify(at)}`).toBeLessThan(TOLERANCE);
    // A sample on the border between two lobes, or at the horizon, may fall to either side.
    expect(elsewhere / POINTS).toBeLessThan(2e-3);
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
