/** The values of a model for several sets of parameters at many pairs of directions. */
import type { ParameterValues } from '../../brdf/model.ts';
import { createEvaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import type { Pace } from '../pace.ts';
import { createQuickEvaluator } from '../quick-evaluator.ts';
import type { Pair } from './samples.ts';

/**
 * For each set f (n.l) of each pair in turn, red, green, blue; in 1/sr. What is negative or no number counts
 * as 0: no metric could compare it.
 */
export type EvaluateSets = (
  sets: readonly ParameterValues[],
  pairs: readonly Pair[],
) => Promise<Float64Array[]>;

const reflected = (f: number, cosine: number) => (f > 0 && f < Number.POSITIVE_INFINITY ? f * cosine : 0);

/** In float64. */
export function exactEvaluation(model: Model, pace: Pace): EvaluateSets {
  const evaluator = createEvaluator(model);
  return async (sets, pairs) => {
    const results: Float64Array[] = [];
    for (const set of sets) {
      const values = new Float64Array(3 * pairs.length);
      evaluator.set(set);
      for (const [i, { l, v }] of pairs.entries()) {
        if (i % 128 === 127) await pace.rest();
        const f = evaluator.f(l, v);
        for (let c = 0; c < 3; c++) values[3 * i + c] = reflected(f[c] as number, l[2]);
      }
      results.push(values);
    }
    return results;
  };
}

/** In float32, as WebAssembly: some forty times as fast. */
export function quickEvaluation(model: Model, pace: Pace): EvaluateSets {
  const evaluator = createQuickEvaluator(model);
  const f = evaluator.term('BRDF');
  return async (sets, pairs) => {
    const results: Float64Array[] = [];
    for (const set of sets) {
      const values = new Float64Array(3 * pairs.length);
      evaluator.set(set);
      for (const [i, { l, v }] of pairs.entries()) {
        if (i % 1024 === 1023) await pace.rest();
        const rgb = f(l, v);
        for (let c = 0; c < 3; c++) values[3 * i + c] = reflected(rgb[c] as number, l[2]);
      }
      await pace.rest();
      results.push(values);
    }
    return results;
  };
}
