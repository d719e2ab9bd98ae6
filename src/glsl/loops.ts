import { evaluateExpression } from './float64.ts';
import type { Expr, Variable } from './ir.ts';
import { checkBinary } from './operators.ts';

const MAX_TURNS = 4096;
const COMPARISONS = new Set(['<', '>', '<=', '>=', '!=']);

/**
 * How often `for (variable = first; test; step)` turns, or null if that is not known before running it:
 * the test must compare the variable with a constant and the step must change it by a constant.
 */
export function countTurns(variable: Variable, first: Expr, test: Expr, step: Expr): number | null {
  if (!first.constant || test.kind !== 'binary' || !COMPARISONS.has(test.operator)) return null;
  const reads = (e: Expr) => e.kind === 'variable' && e.variable === variable;
  if (!((reads(test.left) && test.right.constant) || (reads(test.right) && test.left.constant))) return null;
  const next = nextValue(step);
  if (!next || !reads(next.target) || !readsOnly(next.value, variable)) return null;
  let value = evaluateExpression(first);
  for (let count = 0; count <= MAX_TURNS; count++) {
    if (!evaluateExpression(test, variable, value)) return count;
    value = evaluateExpression(next.value, variable, value);
  }
  return null;
}

/** The assignment that a step makes, written out as `target = value`. */
function nextValue(step: Expr): { target: Expr; value: Expr } | null {
  if (step.kind === 'step') {
    const one: Expr = { kind: 'literal', place: step.place, type: step.type, constant: true, value: 1 };
    return {
      target: step.target,
      value: checkBinary(step.operator === '++' ? '+' : '-', step.target, one, step.place),
    };
  }
  if (step.kind !== 'assign') return null;
  const value =
    step.operator === null ? step.value : checkBinary(step.operator, step.target, step.value, step.place);
  return { target: step.target, value };
}

function readsOnly(e: Expr, variable: Variable): boolean {
  if (e.constant) return true;
  if (e.kind === 'variable') return e.variable === variable;
  return e.kind === 'binary' && readsOnly(e.left, variable) && readsOnly(e.right, variable);
}
