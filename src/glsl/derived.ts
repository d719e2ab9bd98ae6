import type { ParameterValues } from '../brdf/model.ts';
import { Float64Program } from './float64.ts';
import { splitByLight } from './hoist.ts';
import type { Value } from './ir.ts';
import { findFunction, type Model } from './model.ts';
import { componentCount } from './types.ts';

/** What a term's evaluation derives from the parameters alone, for a material to keep in uniforms. */
export interface DerivedQuantities {
  /** Components of each quantity, 1 to 4. */
  readonly sizes: readonly number[];
  /** The quantities for complete parameter values, in float64. */
  compute(values: ParameterValues): (number | readonly number[])[];
}

const known = new WeakMap<Model, Map<string, DerivedQuantities>>();

/** @param term BRDF or another term of the model */
export function derivedQuantities(model: Model, term: string): DerivedQuantities {
  const byTerm = known.get(model) ?? new Map<string, DerivedQuantities>();
  known.set(model, byTerm);
  const quantities = byTerm.get(term) ?? create(model, term);
  byTerm.set(term, quantities);
  return quantities;
}

function create(model: Model, term: string): DerivedQuantities {
  const f = findFunction(model, term);
  if (!f) throw new RangeError(`${model.name} has no term ${term}`);
  const { derived } = splitByLight(f, model.program, true);
  const program = new Float64Program(model.program);
  const steps = derived.map(({ variable, init }) => ({
    cell: program.cell(variable),
    run: program.expression(init),
  }));
  return {
    sizes: derived.map(({ variable }) => componentCount(variable.type)),
    compute: (values) => {
      for (const variable of model.program.parameters) {
        const value = values[variable.name];
        if (value !== undefined) program.cell(variable).value = value as Value;
      }
      return steps.map(({ cell, run }) => {
        cell.value = run();
        return cell.value as number | readonly number[];
      });
    },
  };
}
