import type { ParameterValues, Rgb } from '../brdf/model.ts';
import { resolveParameters } from '../brdf/values.ts';
import { Float64Program } from './float64.ts';
import type { Value } from './ir.ts';
import { findFunction, type Model } from './model.ts';
import { TABLE } from './types.ts';

export type Vector3 = readonly [number, number, number];

/** The local frame: shading normal, tangent and bitangent. */
export interface Frame {
  readonly N: Vector3;
  readonly X: Vector3;
  readonly Y: Vector3;
}

/** N = +z, X = +x, Y = +y. */
export const LOCAL_FRAME: Frame = { N: [0, 0, 1], X: [1, 0, 0], Y: [0, 1, 0] };

/** A model with values for its parameters, evaluated in float64 on the CPU. */
export interface Evaluator {
  readonly model: Model;
  /** New values; parameters that are not named take their defaults. @throws BrdfParameterError */
  set(values: Readonly<Record<string, unknown>>): void;
  /** The model, or one of its terms, in 1/sr without the cosine. @throws RangeError for an unknown term */
  f(L: Vector3, V: Vector3, frame?: Frame, term?: string): Rgb;
  /** A direction L for a point of the unit square, or null. @throws RangeError without a sampling section */
  sampleL(u: readonly [number, number], V: Vector3, frame?: Frame): Vector3 | null;
  /** The density of sampleL() at L, in 1/sr. @throws RangeError without a sampling section */
  pdf(L: Vector3, V: Vector3, frame?: Frame): number;
}

/** @throws BrdfParameterError if a value does not suit its parameter */
export function createEvaluator(model: Model, values: Readonly<Record<string, unknown>> = {}): Evaluator {
  const program = new Float64Program(model.program);
  const set = (next: Readonly<Record<string, unknown>>): void => {
    const resolved: ParameterValues = resolveParameters(model.file, next);
    for (const variable of model.program.parameters) {
      const value = variable.type === TABLE ? model.data : resolved[variable.name];
      program.cell(variable).value = value as Value;
    }
  };
  const callables = new Map<string, (...args: Value[]) => Value>();
  const callable = (name: string) => {
    let found = callables.get(name);
    if (!found) {
      const f = findFunction(model, name);
      if (!f)
        throw new RangeError(
          `${model.name} has no function ${name}(); its terms are ${model.terms.join(', ')}`,
        );
      found = program.callable(f);
      callables.set(name, found);
    }
    return found;
  };
  set(values);
  return {
    model,
    set,
    f: (L, V, { N, X, Y } = LOCAL_FRAME, term = 'BRDF') => callable(term)(L, V, N, X, Y) as unknown as Rgb,
    sampleL: (u, V, { N, X, Y } = LOCAL_FRAME) => {
      const L = callable('sampleL')(u, V, N, X, Y) as unknown as Vector3;
      return L[0] === 0 && L[1] === 0 && L[2] === 0 ? null : L;
    },
    pdf: (L, V, { N, X, Y } = LOCAL_FRAME) => callable('pdf')(L, V, N, X, Y) as number,
  };
}
