import { BrdfError } from '../brdf/error.ts';
import type { Expr, FunctionIR, Stmt, Variable } from './ir.ts';

/**
 * A bound on the work of one call, in nodes of the syntax tree: loops and calls multiply, and a file from
 * a stranger must not hang the page or the GPU. Disney's principled model needs about 400.
 */
const MAX_WORK = 1_000_000;
/** A chain of calls is followed by recursion here. */
const MAX_FUNCTIONS = 1000;

/**
 * Orders functions so that each comes after those that it calls, and completes `uses` with what the
 * called ones read.
 *
 * @param maxWork the bound; endless for a kernel, whose loops are its own affair
 * @throws BrdfError for recursion (which GLSL forbids), a function without a body, or too much work
 */
export function orderFunctions(
  functions: readonly FunctionIR[],
  parameters: readonly Variable[],
  maxWork = MAX_WORK,
): FunctionIR[] {
  const ordered: FunctionIR[] = [];
  const work = new Map<FunctionIR, number>();
  const active = new Set<FunctionIR>();
  const defined = new Set(functions);

  const visit = (f: FunctionIR): void => {
    if (work.has(f)) return;
    if (active.has(f)) throw new BrdfError(f.place, `${f.name} calls itself`, 'no recursion');
    if (!defined.has(f)) throw new BrdfError(f.place, `${f.name} is declared but has no body`, "'{'");
    active.add(f);
    for (const callee of f.calls) visit(callee);
    active.delete(f);
    const uses = new Set([...f.uses, ...f.calls.flatMap((callee) => callee.uses)]);
    f.uses = parameters.filter((parameter) => uses.has(parameter));
    const cost = f.body.reduce((sum, statement) => sum + statementWork(statement, work), 1);
    if (cost > maxWork)
      throw new BrdfError(
        f.place,
        `${f.name} does too much: about ${cost} operations a call`,
        `at most ${maxWork}`,
      );
    work.set(f, cost);
    ordered.push(f);
  };
  if (functions.length > MAX_FUNCTIONS)
    throw new BrdfError(
      (functions[MAX_FUNCTIONS] as FunctionIR).place,
      'too many functions',
      `at most ${MAX_FUNCTIONS}`,
    );
  for (const f of functions) visit(f);
  return ordered;
}

function statementWork(s: Stmt, work: ReadonlyMap<FunctionIR, number>): number {
  switch (s.kind) {
    case 'declare':
      return s.init ? expressionWork(s.init, work) : 1;
    case 'expression':
      return expressionWork(s.expression, work);
    case 'block':
      return s.body.reduce((sum, inner) => sum + statementWork(inner, work), 0);
    case 'if':
      return (
        expressionWork(s.test, work) + statementWork(s.yes, work) + (s.no ? statementWork(s.no, work) : 0)
      );
    case 'for':
      return (
        1 +
        s.count * (expressionWork(s.test, work) + expressionWork(s.step, work) + statementWork(s.body, work))
      );
    case 'loop':
      return 1 + expressionWork(s.test, work) + statementWork(s.body, work);
    case 'return':
      return s.value ? expressionWork(s.value, work) : 1;
    default:
      return 1;
  }
}

function expressionWork(e: Expr, work: ReadonlyMap<FunctionIR, number>): number {
  const own = e.kind === 'call' ? (work.get(e.callee) ?? 0) : 1;
  return children(e).reduce((sum, child) => sum + expressionWork(child, work), own);
}

/** The expressions directly inside an expression. */
export function children(e: Expr): readonly Expr[] {
  switch (e.kind) {
    case 'literal':
    case 'variable':
      return [];
    case 'unary':
      return [e.operand];
    case 'binary':
      return [e.left, e.right];
    case 'ternary':
      return [e.test, e.yes, e.no];
    case 'call':
    case 'builtin':
    case 'construct':
      return e.args;
    case 'swizzle':
    case 'field':
      return [e.object];
    case 'index':
      return [e.object, e.index];
    case 'assign':
      return [e.target, e.value];
    case 'step':
      return [e.target];
    case 'sequence':
      return e.items;
  }
}

/** These functions and all that they call, each after those that it calls. */
export function reachable(entries: readonly FunctionIR[]): FunctionIR[] {
  const found = new Set<FunctionIR>();
  const visit = (f: FunctionIR): void => {
    if (found.has(f)) return;
    for (const callee of f.calls) visit(callee);
    found.add(f);
  };
  for (const f of entries) visit(f);
  return [...found];
}
