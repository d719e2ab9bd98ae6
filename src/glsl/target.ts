import { BrdfError } from '../brdf/error.ts';
import type { Expr } from './ir.ts';

/** Checks that an expression can be assigned to, and marks its variable. */
export function checkTarget(target: Expr): Expr {
  let root = target;
  while (root.kind === 'swizzle' || root.kind === 'index' || root.kind === 'field') {
    if (root.kind === 'swizzle' && new Set(root.components).size !== root.components.length) {
      throw new BrdfError(root.place, 'a component is assigned twice', 'different components');
    }
    root = root.object;
  }
  if (root.kind !== 'variable' || root.variable.role === 'parameter' || root.variable.role === 'constant') {
    const what =
      root.kind === 'variable'
        ? `'${root.variable.name}' (a ${root.variable.role})`
        : root.kind === 'literal'
          ? 'a constant'
          : root.kind === 'call'
            ? `'${root.callee.name}'`
            : 'this';
    throw new BrdfError(target.place, `${what} cannot be assigned`, 'a local variable');
  }
  root.variable.assigned = true;
  return target;
}
