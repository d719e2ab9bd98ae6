import { createEvaluator, type Evaluator, type Vector3 } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';

const TURNED = { N: [0, 0, 1], X: [0.6, 0.8, 0], Y: [-0.8, 0.6, 0] } as const;

/** Numbers in 0..1 that are the same each time (Numerical Recipes' linear congruential generator). */
function sequence(): () => number {
  let state = 1;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function direction(random: () => number): Vector3 {
  const [z, phi] = [0.2 + 0.8 * random(), 2 * Math.PI * random()];
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}

/**
 * Whether turning the tangent about N changes a term, with the evaluator's parameters. Found by trying:
 * a model may well read X and Y without depending on how they are turned.
 */
export function turnsWithTangent(evaluator: Evaluator, term: string, tries = 12): boolean {
  const random = sequence();
  for (let i = 0; i < tries; i++) {
    const [L, V] = [direction(random), direction(random)];
    const a = evaluator.f(L, V, undefined, term);
    const b = evaluator.f(L, V, TURNED, term);
    if (a.some((x, k) => Math.abs(x - (b[k] as number)) > 1e-6 * Math.max(Math.abs(x), 1e-3))) return true;
  }
  return false;
}

const known = new WeakMap<Model, boolean>();

/** As turnsWithTangent(), for any parameters and any term: whether a material may ever need tangents. */
export function dependsOnTangent(model: Model): boolean {
  let depends = known.get(model);
  if (depends === undefined) {
    const random = sequence();
    const evaluator = createEvaluator(model);
    depends = false;
    for (let i = 0; i < 64 && !depends; i++) {
      const values = model.parameters.map((p) => {
        if (p.type === 'float') return [p.name, p.min + (p.max - p.min) * random()];
        return [p.name, p.type === 'bool' ? random() < 0.5 : [random(), random(), random()]];
      });
      evaluator.set(Object.fromEntries(values));
      depends = model.terms.some((term) => turnsWithTangent(evaluator, term, 1));
    }
    known.set(model, depends);
  }
  return depends;
}
