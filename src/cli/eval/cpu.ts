import { createEvaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import type { Backend } from './query.ts';

/** The float64 evaluation. */
export function cpuBackend(model: Model, term: string): Backend {
  const evaluator = createEvaluator(model);
  return async (queries) =>
    queries.map(({ l, v, parameters }) => {
      evaluator.set(parameters);
      return evaluator.f(l, v, undefined, term);
    });
}
