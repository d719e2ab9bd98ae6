import type { Expr, FunctionIR, Variable } from '../ir.ts';
import { children } from '../order.ts';
import { expressionsOf } from '../rewrite.ts';
import { cellsOf } from './layout.ts';

/** What must be known of functions before they are written. */

const writers = new WeakMap<FunctionIR, boolean>();

/** Whether a call changes anything but its own variables: the invocation's variables or the film. */
function writesState(f: FunctionIR): boolean {
  let known = writers.get(f);
  if (known === undefined) {
    known = f.body.flatMap(expressionsOf).some((e) => changes(e, (v) => v.role === 'shared'));
    writers.set(f, known);
  }
  return known;
}

/** Whether evaluating this changes what other expressions read. */
export function hasEffects(e: Expr): boolean {
  return changes(e, () => true);
}

function changes(e: Expr, counts: (variable: Variable) => boolean): boolean {
  if (e.kind === 'assign' || e.kind === 'step') {
    if (counts(rootOf(e.target))) return true;
  }
  if (e.kind === 'builtin' && e.name === 'filmStore') return true;
  if (e.kind === 'call') {
    if (writesState(e.callee)) return true;
    const isWritten = (i: number) => e.callee.arguments[i]?.qualifier !== 'in';
    if (e.args.some((arg, i) => isWritten(i) && counts(rootOf(arg)))) return true;
  }
  return children(e).some((child) => changes(child, counts));
}

/** The variable that a target is a part of. */
export function rootOf(target: Expr): Variable {
  if (target.kind === 'variable') return target.variable;
  if (target.kind === 'swizzle' || target.kind === 'index' || target.kind === 'field')
    return rootOf(target.object);
  throw new Error('unreachable: the checker refuses this target');
}

export function isVariablePart(e: Expr): boolean {
  if (e.kind === 'variable') return true;
  return (e.kind === 'swizzle' || e.kind === 'index' || e.kind === 'field') && isVariablePart(e.object);
}

/** Arrays of more cells than this lie in memory however they are indexed. */
const MAX_CELLS = 64;

const addressed = new WeakMap<FunctionIR, ReadonlySet<Variable>>();

/** Variables whose elements are chosen while the function runs: they lie in memory. */
export function addressedVariables(f: FunctionIR): ReadonlySet<Variable> {
  let found = addressed.get(f);
  if (!found) {
    const variables = new Set<Variable>();
    const visit = (e: Expr): void => {
      if (e.kind === 'index' && isVariablePart(e)) {
        const { kind } = e.object.type;
        if (!e.index.constant && (kind === 'array' || kind === 'matrix')) variables.add(rootOf(e));
      }
      for (const child of children(e)) visit(child);
    };
    for (const e of f.body.flatMap(expressionsOf)) visit(e);
    found = variables;
    addressed.set(f, found);
  }
  return found;
}

export function isLarge(variable: Variable): boolean {
  return cellsOf(variable.type).length > MAX_CELLS;
}

const weights = new WeakMap<FunctionIR, number>();

/** The size of a function in nodes of the syntax tree, with all that it calls. */
export function weightOf(f: FunctionIR): number {
  let weight = weights.get(f);
  if (weight === undefined) {
    const count = (e: Expr): number =>
      children(e).reduce((sum, child) => sum + count(child), e.kind === 'call' ? weightOf(e.callee) : 1);
    weight = f.body.flatMap(expressionsOf).reduce((sum, e) => sum + count(e), 0);
    weights.set(f, weight);
  }
  return weight;
}
