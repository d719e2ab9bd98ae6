import { fold } from './construct.ts';
import type { Expr, FunctionIR, Stmt, Variable } from './ir.ts';
import { children } from './order.ts';
import { expressionsOf, functionOf, mapChildren, mapStatement, returns, someNode } from './rewrite.ts';

/** Functions larger than this, in nodes, stay calls: doubling calls would double without end. */
const MAX_NODES = 2000;

/**
 * A function with the calls of plain functions replaced by their bodies: those that run straight to one
 * return at their end. Others stay calls.
 */
export function inlineCalls(f: FunctionIR, parameters: readonly Variable[]): FunctionIR {
  return new Inliner(parameters).function(f);
}

class Inliner {
  private readonly done = new Map<FunctionIR, FunctionIR>();
  private readonly parameters: readonly Variable[];
  private nextId = 1_000_000;
  private out: Stmt[] = [];

  constructor(parameters: readonly Variable[]) {
    this.parameters = parameters;
  }

  function(f: FunctionIR): FunctionIR {
    let result = this.done.get(f);
    if (!result) {
      result = functionOf(f, { body: this.block(f.body) }, this.parameters);
      this.done.set(f, result);
    }
    return result;
  }

  private block(body: readonly Stmt[]): Stmt[] {
    const outer = this.out;
    this.out = [];
    for (const statement of body) this.statement(statement);
    const inner = this.out;
    this.out = outer;
    return inner;
  }

  private statement(s: Stmt): void {
    switch (s.kind) {
      case 'declare':
        this.out.push({ ...s, init: s.init && this.expression(s.init, true) });
        return;
      case 'expression':
        this.out.push({ ...s, expression: this.expression(s.expression, true) });
        return;
      case 'block':
        this.out.push({ ...s, body: this.block(s.body) });
        return;
      case 'if': {
        const test = this.expression(s.test, true);
        const branch = (b: Stmt): Stmt => ({
          kind: 'block',
          place: b.place,
          body: this.block(b.kind === 'block' ? b.body : [b]),
        });
        this.out.push({ ...s, test, yes: branch(s.yes), no: s.no && branch(s.no) });
        return;
      }
      // A loop's test runs again at every turn: what it calls stays a call.
      case 'for':
      case 'loop':
        this.out.push({ ...s, body: { kind: 'block', place: s.body.place, body: this.block([s.body]) } });
        return;
      case 'return':
        this.out.push({ ...s, value: s.value && this.expression(s.value, true) });
        return;
      default:
        this.out.push(s);
    }
  }

  /** @param always whether this is evaluated whenever its statement is: only then may statements precede it */
  private expression(e: Expr, always: boolean): Expr {
    if (e.kind === 'ternary') {
      return {
        ...e,
        test: this.expression(e.test, always),
        yes: this.expression(e.yes, false),
        no: this.expression(e.no, false),
      };
    }
    if (e.kind === 'binary' && (e.operator === '&&' || e.operator === '||')) {
      return { ...e, left: this.expression(e.left, always), right: this.expression(e.right, false) };
    }
    // What has effects must keep its order with its neighbours.
    if (someNode(e, (node) => node.kind === 'assign' || node.kind === 'step') && e.kind !== 'assign')
      return e;
    const inner = mapChildren(e, (child) =>
      e.kind === 'assign' && child === e.target ? child : this.expression(child, always),
    );
    return inner.kind === 'call' ? (this.inlined(inner, always) ?? inner) : inner;
  }

  private inlined(e: Extract<Expr, { kind: 'call' }>, always: boolean): Expr | null {
    const callee = this.function(e.callee);
    if (!isPlain(callee)) return null;
    const result = callee.body.at(-1) as Extract<Stmt, { kind: 'return' }>;
    const statements = callee.body.slice(0, -1);
    const replaced = new Map<Variable, Expr>();
    const declares: Stmt[] = [];
    for (const [i, { variable }] of callee.arguments.entries()) {
      const arg = e.args[i] as Expr;
      if (isAtom(arg) && !variable.assigned) {
        replaced.set(variable, arg);
      } else {
        const copy = this.copy(variable);
        replaced.set(variable, {
          kind: 'variable',
          place: arg.place,
          type: variable.type,
          constant: false,
          variable: copy,
        });
        declares.push({ kind: 'declare', place: arg.place, variable: copy, init: arg });
      }
    }
    if (!always && declares.length + statements.length > 0) return null;
    const copies = new Map<Variable, Variable>();
    const declared = (variable: Variable): Variable => {
      const copy = copies.get(variable) ?? this.copy(variable);
      copies.set(variable, copy);
      return copy;
    };
    const substitute = (node: Expr): Expr => {
      if (node.kind !== 'variable') return refold(mapChildren(node, substitute));
      const copy = copies.get(node.variable);
      return replaced.get(node.variable) ?? (copy ? { ...node, variable: copy } : node);
    };
    this.out.push(...declares);
    for (const statement of statements) {
      collectDeclared(statement, declared);
      this.out.push(mapStatement(statement, substitute, declared));
    }
    return substitute(result.value as Expr);
  }

  private copy(variable: Variable): Variable {
    return { ...variable, id: this.nextId++, role: 'local' };
  }
}

function collectDeclared(s: Stmt, declared: (v: Variable) => Variable): void {
  mapStatement(s, (e) => e, declared);
}

/** Nothing that evaluating it again, or later, could change or make dear. */
export function isAtom(e: Expr): boolean {
  if (e.constant) return true;
  if (e.kind === 'swizzle') return isAtom(e.object);
  return e.kind === 'variable' && !e.variable.assigned;
}

/** With constants for arguments, more may be constant than before; what WGSL refuses must be found now. */
function refold(e: Expr): Expr {
  if (e.kind === 'call' || e.kind === 'assign' || e.kind === 'step' || e.kind === 'sequence') return e;
  return fold({ ...e, constant: children(e).every((child) => child.constant) });
}

function isPlain(f: FunctionIR): boolean {
  const last = f.body.at(-1);
  if (last?.kind !== 'return' || !last.value) return false;
  if (f.arguments.some(({ qualifier }) => qualifier !== 'in')) return false;
  const nodes = f.body.flatMap(expressionsOf).reduce((sum, e) => sum + countNodes(e), 0);
  return nodes <= MAX_NODES && !f.body.slice(0, -1).some(returns);
}

function countNodes(e: Expr): number {
  return children(e).reduce((sum, child) => sum + countNodes(child), 1);
}
