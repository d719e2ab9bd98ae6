import { inlineCalls } from './inline.ts';
import type { Expr, FunctionIR, Program, Stmt, Variable } from './ir.ts';
import { functionOf, mapChildren, mapStatement, someNode } from './rewrite.ts';
import { FLOAT } from './types.ts';

/**
 * A BRDF in two parts, for a surface point with many lights: what depends on the view, the frame and the
 * parameters alone is computed once, what depends on the light once per light.
 */
export interface SplitFunction {
  /** As the BRDF, without L; computes the shared variables. Its value (1) says nothing. */
  readonly perView: FunctionIR;
  /** As the BRDF; reads what perView left in the shared variables. */
  readonly perLight: FunctionIR;
}

const splits = new WeakMap<FunctionIR, SplitFunction>();

/** Splits BRDF() or a term. Its first argument is L. */
export function splitByLight(f: FunctionIR, program: Program): SplitFunction {
  let split = splits.get(f);
  if (!split) {
    split = new Splitter(inlineCalls(f, program.parameters), program).split();
    splits.set(f, split);
  }
  return split;
}

/** Where hoisted statements go: the tests that they stand under. */
type Guards = readonly Expr[];

class Splitter {
  private readonly hoisted: Stmt[] = [];
  private readonly varying = new Set<Variable>();
  private readonly shared = new Map<Variable, Variable>();
  /** Shared variables by the text of their expression, so that each is computed once. */
  private readonly known = new Map<string, Variable>();
  private nextId = 2_000_000;
  private readonly f: FunctionIR;
  private readonly program: Program;

  constructor(f: FunctionIR, program: Program) {
    this.f = f;
    this.program = program;
  }

  split(): SplitFunction {
    const [light, ...rest] = this.f.arguments;
    if (light) this.varying.add(light.variable);
    const body = this.statements(this.f.body, []);
    const one: Expr = { kind: 'literal', place: this.f.place, type: FLOAT, constant: true, value: 1 };
    const perView = functionOf(
      this.f,
      {
        name: `${this.f.name}View`,
        result: FLOAT,
        arguments: rest,
        body: [...this.hoisted, { kind: 'return', place: this.f.place, value: one }],
      },
      this.program.parameters,
    );
    return {
      perView,
      perLight: functionOf(this.f, { name: `${this.f.name}Light`, body }, this.program.parameters),
    };
  }

  private statements(body: readonly Stmt[], guards: Guards): Stmt[] {
    return body.flatMap((s): Stmt[] => {
      switch (s.kind) {
        case 'declare': {
          const init = s.init && this.rename(s.init);
          if (init && !s.variable.assigned && this.isInvariant(init)) {
            this.shared.set(s.variable, this.share(init, guards, s.variable));
            return [];
          }
          this.varying.add(s.variable);
          return [{ ...s, init: init && this.hoistWithin(init, guards) }];
        }
        case 'expression':
          return [{ ...s, expression: this.expression(s.expression, guards) }];
        case 'return':
          return [{ ...s, value: s.value && this.expression(s.value, guards) }];
        case 'block':
          return [{ ...s, body: this.statements(s.body, guards) }];
        case 'if': {
          const test = this.rename(s.test);
          // A test of parameters, such as `clearcoat > 0`: what stands under it is hoisted under it, too.
          if (!s.no && this.isInvariant(test)) {
            return [
              {
                ...s,
                test,
                yes: { kind: 'block', place: s.yes.place, body: this.statements([s.yes], [...guards, test]) },
              },
            ];
          }
          return [this.fixed(s)];
        }
        default:
          return [this.fixed(s)];
      }
    });
  }

  /** A statement in which nothing is hoisted. */
  private fixed(s: Stmt): Stmt {
    return mapStatement(
      s,
      (e) => this.rename(e),
      (variable) => {
        this.varying.add(variable);
        return variable;
      },
    );
  }

  private rename(e: Expr): Expr {
    if (e.kind !== 'variable') return mapChildren(e, (child) => this.rename(child));
    const shared = this.shared.get(e.variable);
    return shared ? { ...e, variable: shared } : e;
  }

  /** Replaces the largest invariant parts of an expression by shared variables. */
  private expression(e: Expr, guards: Guards): Expr {
    return this.hoistWithin(this.rename(e), guards);
  }

  private hoistWithin(e: Expr, guards: Guards): Expr {
    if (isWorthwhile(e) && this.isInvariant(e)) {
      const variable = this.share(e, guards);
      return { kind: 'variable', place: e.place, type: e.type, constant: false, variable };
    }
    if (e.kind === 'assign' || e.kind === 'step') {
      return e.kind === 'assign' ? { ...e, value: this.hoistWithin(e.value, guards) } : e;
    }
    return mapChildren(e, (child) => this.hoistWithin(child, guards));
  }

  private isInvariant(e: Expr): boolean {
    return !someNode(
      e,
      (node) =>
        node.kind === 'assign' ||
        node.kind === 'step' ||
        (node.kind === 'variable' &&
          (this.varying.has(node.variable) || (node.variable.assigned && node.variable.role !== 'shared'))) ||
        (node.kind === 'call' && node.callee.arguments.some(({ qualifier }) => qualifier !== 'in')),
    );
  }

  private share(init: Expr, guards: Guards, like?: Variable): Variable {
    const key = `${guards.map(textOf).join('&')}|${textOf(init)}`;
    const found = this.known.get(key);
    if (found) return found;
    const variable: Variable = {
      id: this.nextId++,
      name: `${this.f.name}${this.f.id}${like?.name ?? ''}`,
      type: init.type,
      role: 'shared',
      constant: null,
      assigned: true,
    };
    this.known.set(key, variable);
    const target: Expr = { kind: 'variable', place: init.place, type: init.type, constant: false, variable };
    const statement: Stmt = {
      kind: 'expression',
      place: init.place,
      expression: {
        kind: 'assign',
        place: init.place,
        type: init.type,
        constant: false,
        operator: null,
        target,
        value: init,
      },
    };
    this.hoisted.push(
      guards.reduceRight<Stmt>(
        (inner, test) => ({
          kind: 'if',
          place: test.place,
          test,
          yes: { kind: 'block', place: test.place, body: [inner] },
          no: null,
        }),
        statement,
      ),
    );
    return variable;
  }
}

/** Whether computing this costs more than reading a variable. */
function isWorthwhile(e: Expr): boolean {
  if (e.constant || e.type.kind === 'void' || e.type.kind === 'struct' || e.type.kind === 'array')
    return false;
  if (e.kind === 'variable' || e.kind === 'literal') return false;
  if (e.kind === 'swizzle' || e.kind === 'construct')
    return (e.kind === 'swizzle' ? [e.object] : e.args).some(isWorthwhile);
  return true;
}

/** A text that is equal for equal expressions. */
function textOf(e: Expr): string {
  const parts: unknown[] = [e.kind, e.type.name];
  if (e.kind === 'literal') parts.push(e.value);
  if (e.kind === 'variable') parts.push(e.variable.id);
  if ('operator' in e) parts.push(e.operator);
  if (e.kind === 'call') parts.push(e.callee.id);
  if (e.kind === 'builtin') parts.push(e.name);
  if (e.kind === 'swizzle') parts.push(e.components.join());
  if (e.kind === 'field') parts.push(e.field);
  const inner: string[] = [];
  mapChildren(e, (child) => {
    inner.push(textOf(child));
    return child;
  });
  return `${parts.join(' ')}(${inner.join(', ')})`;
}
