import type { Expr, FunctionIR, Stmt, Variable } from './ir.ts';
import { children } from './order.ts';

/** Copies of the typed program with parts replaced. */

/** An expression with its children replaced by what `f` makes of them. */
export function mapChildren(e: Expr, f: (child: Expr) => Expr): Expr {
  switch (e.kind) {
    case 'literal':
    case 'variable':
      return e;
    case 'unary':
      return { ...e, operand: f(e.operand) };
    case 'binary':
      return { ...e, left: f(e.left), right: f(e.right) };
    case 'ternary':
      return { ...e, test: f(e.test), yes: f(e.yes), no: f(e.no) };
    case 'call':
    case 'builtin':
    case 'construct':
      return { ...e, args: e.args.map(f) };
    case 'swizzle':
    case 'field':
      return { ...e, object: f(e.object) };
    case 'index':
      return { ...e, object: f(e.object), index: f(e.index) };
    case 'assign':
      return { ...e, target: f(e.target), value: f(e.value) };
    case 'step':
      return { ...e, target: f(e.target) };
    case 'sequence':
      return { ...e, items: e.items.map(f) };
  }
}

/** A statement with every expression and declared variable in it replaced, at any depth. */
export function mapStatement(
  s: Stmt,
  expression: (e: Expr) => Expr,
  declared: (v: Variable) => Variable,
): Stmt {
  const inner = (t: Stmt) => mapStatement(t, expression, declared);
  switch (s.kind) {
    case 'declare':
      return { ...s, variable: declared(s.variable), init: s.init && expression(s.init) };
    case 'expression':
      return { ...s, expression: expression(s.expression) };
    case 'block':
      return { ...s, body: s.body.map(inner) };
    case 'if':
      return { ...s, test: expression(s.test), yes: inner(s.yes), no: s.no && inner(s.no) };
    case 'for':
      return {
        ...s,
        variable: declared(s.variable),
        first: expression(s.first),
        test: expression(s.test),
        step: expression(s.step),
        body: inner(s.body),
      };
    case 'loop':
      return { ...s, test: expression(s.test), body: inner(s.body) };
    case 'return':
      return { ...s, value: s.value && expression(s.value) };
    default:
      return s;
  }
}

/** Every expression of a statement, at any depth. */
export function expressionsOf(s: Stmt): Expr[] {
  const found: Expr[] = [];
  mapStatement(
    s,
    (e) => {
      found.push(e);
      return e;
    },
    (v) => v,
  );
  return found;
}

/** Whether any node of an expression fits. */
export function someNode(e: Expr, fits: (node: Expr) => boolean): boolean {
  return fits(e) || children(e).some((child) => someNode(child, fits));
}

/** A function made of new statements: what it reads and calls is found in them. */
export function functionOf(
  base: FunctionIR,
  changes: Partial<FunctionIR> & Pick<FunctionIR, 'body'>,
  parameters: readonly Variable[],
): FunctionIR {
  const read = new Set<Variable>();
  const derived = new Set<Variable>();
  const calls = new Set<FunctionIR>();
  const visit = (e: Expr): void => {
    if (e.kind === 'variable' && e.variable.role === 'parameter') read.add(e.variable);
    if (e.kind === 'variable' && e.variable.role === 'derived') derived.add(e.variable);
    if (e.kind === 'call') {
      calls.add(e.callee);
      for (const variable of e.callee.uses) read.add(variable);
    }
    for (const child of children(e)) visit(child);
  };
  for (const statement of changes.body) for (const e of expressionsOf(statement)) visit(e);
  return {
    ...base,
    ...changes,
    uses: [...parameters.filter((variable) => read.has(variable)), ...derived],
    calls: [...calls],
  };
}

/** Whether a statement returns somewhere inside. */
export function returns(s: Stmt): boolean {
  switch (s.kind) {
    case 'return':
      return true;
    case 'block':
      return s.body.some(returns);
    case 'if':
      return returns(s.yes) || (s.no !== null && returns(s.no));
    case 'for':
    case 'loop':
      return returns(s.body);
    default:
      return false;
  }
}
