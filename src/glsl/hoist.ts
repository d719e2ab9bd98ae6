import { hasEffects } from './emit.ts';
import { evaluateExpression } from './float64.ts';
import { inlineCalls } from './inline.ts';
import type { Expr, FunctionIR, Program, Stmt, Variable } from './ir.ts';
import { functionOf, mapChildren, mapStatement, someNode } from './rewrite.ts';
import { componentCount, FLOAT, scalarOf, TABLE } from './types.ts';

/** A quantity that depends on the model's parameters alone, and on earlier ones of its kind. */
export interface Derived {
  readonly variable: Variable;
  readonly init: Expr;
}

/**
 * A BRDF in two parts, for a surface point with many lights: what depends on the view, the frame and the
 * parameters alone is computed once, what depends on the light once per light.
 */
export interface SplitFunction {
  /** As the BRDF, without L; computes the shared variables. Its value (1) says nothing. */
  readonly perView: FunctionIR;
  /**
   * As the BRDF; reads what perView left in the shared variables. Where an early return of the BRDF gives 0, this gives
   * 0 or something that is not finite: see nonNegative().
   */
  readonly perLight: FunctionIR;
  /** What both take as further arguments, after the parameters: computed once per material. */
  readonly derived: readonly Derived[];
}

const splits = new WeakMap<FunctionIR, Map<boolean, SplitFunction>>();

/**
 * Splits BRDF() or a term. Its first argument is L.
 *
 * @param even whether the parameters are the same all over the surface: what depends on them alone is then
 *   derived once per material; else it is computed once per view
 */
export function splitByLight(f: FunctionIR, program: Program, even: boolean): SplitFunction {
  const known = splits.get(f) ?? new Map<boolean, SplitFunction>();
  splits.set(f, known);
  const split = known.get(even) ?? new Splitter(inlineCalls(f, program.parameters), program, even).split();
  known.set(even, split);
  return split;
}

/** Where hoisted statements go: the tests that they stand under. */
type Guards = readonly Expr[];

class Splitter {
  private readonly hoisted: Stmt[] = [];
  private readonly derived: Derived[] = [];
  private readonly varying = new Set<Variable>();
  private readonly shared = new Map<Variable, Variable>();
  /** What stands for local variables that are constant, or cheap to compute from a parameter. */
  private readonly replaced = new Map<Variable, Expr>();
  /** Shared variables by the text of their expression, so that each is computed once. */
  private readonly known = new Map<string, Variable>();
  private nextId = 2_000_000;
  private readonly f: FunctionIR;
  private readonly program: Program;
  private readonly even: boolean;

  constructor(f: FunctionIR, program: Program, even: boolean) {
    this.f = f;
    this.program = program;
    this.even = even;
  }

  split(): SplitFunction {
    const [light, ...rest] = this.f.arguments;
    if (light) this.varying.add(light.variable);
    const body = this.statements(this.withoutEarlyReturns(this.f.body), []);
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
    const perLight = functionOf(this.f, { name: `${this.f.name}Light`, body }, this.program.parameters);
    return { perView, perLight, derived: this.derived };
  }

  /**
   * `if (test) return c; ... return x;` as `... return test ? c : x;`: a return in the middle costs more on a
   * GPU (compilers make a loop of it) than the few lanes that would have left early save. Where c is 0 and this is a
   * BRDF, as x times 0 or 1, which is cheaper still.
   */
  private withoutEarlyReturns(body: readonly Stmt[]): readonly Stmt[] {
    const last = body.at(-1);
    if (last?.kind !== 'return' || !last.value) return body;
    const early: { test: Expr; value: Expr }[] = [];
    let kept: Expr | null = null;
    const rest = body.slice(0, -1).flatMap((s): Stmt[] => {
      const value = s.kind === 'if' && !s.no ? returnedConstant(s.yes) : null;
      if (s.kind !== 'if' || !value) return [s];
      if (this.isBrdf && isZero(value) && !hasEffects(s.test)) {
        const variable = this.local('kept', FLOAT);
        const keeps: Expr = { kind: 'variable', place: s.place, type: FLOAT, constant: false, variable };
        kept = kept ? { ...keeps, kind: 'binary', operator: '*', left: kept, right: keeps } : keeps;
        return [{ kind: 'declare', place: s.place, variable, init: unless(s.test) }];
      }
      const variable = this.local('early', s.test.type);
      early.push({
        test: { kind: 'variable', place: s.place, type: variable.type, constant: false, variable },
        value,
      });
      return [{ kind: 'declare', place: s.place, variable, init: s.test }];
    });
    if (early.length === 0 && !kept) return body;
    const { place } = last;
    const result = this.local('result', last.value.type);
    const whole: Expr = { kind: 'variable', place, type: result.type, constant: false, variable: result };
    const read: Expr = kept ? { ...whole, kind: 'binary', operator: '*', left: whole, right: kept } : whole;
    const value = early.reduceRight<Expr>(
      (no, { test, value: yes }) => ({
        kind: 'ternary',
        place,
        type: result.type,
        constant: false,
        test,
        yes,
        no,
      }),
      read,
    );
    return [
      ...rest,
      { kind: 'declare', place, variable: result, init: last.value },
      { kind: 'return', place, value },
    ];
  }

  /** Whether this has the signature of BRDF(); a sampler's functions have another. */
  private get isBrdf(): boolean {
    const [first] = this.f.arguments;
    return (
      componentCount(this.f.result) === 3 && first !== undefined && componentCount(first.variable.type) === 3
    );
  }

  private local(name: string, type: Expr['type']): Variable {
    return { id: this.nextId++, name, type, role: 'local', constant: null, assigned: false };
  }

  private statements(body: readonly Stmt[], guards: Guards): Stmt[] {
    return body.flatMap((s): Stmt[] => {
      switch (s.kind) {
        case 'declare': {
          const init = s.init && this.rename(s.init);
          if (
            init &&
            !s.variable.assigned &&
            (isArithmetic(init) || (this.isDerivable(init) && isCheap(init)))
          ) {
            this.replaced.set(s.variable, init);
            return [];
          }
          if (init && !s.variable.assigned && this.isInvariant(init)) {
            this.shared.set(s.variable, this.settle(init, guards, s.variable));
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
    const replaced = this.replaced.get(e.variable);
    if (replaced) return replaced;
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
    if (isUniform(init)) return this.keep(init, guards, like);
    if (this.isDerivable(init) && !isCheap(init))
      return this.keep(this.read(this.derive(init, like), init), guards, like);
    return this.keep(this.deriveWithin(init), guards, like);
  }

  /** Puts a value into a shared variable, once. */
  private keep(inner: Expr, guards: Guards, like?: Variable): Variable {
    const key = `${guards.map(textOf).join('&')}|${textOf(inner)}`;
    const found = this.known.get(key);
    if (found) return found;
    const variable = this.variable(inner, 'shared', like);
    this.known.set(key, variable);
    const { place, type } = inner;
    const target: Expr = { kind: 'variable', place, type, constant: false, variable };
    const assign: Expr = {
      kind: 'assign',
      place,
      type,
      constant: false,
      operator: null,
      target,
      value: inner,
    };
    const under = (body: Stmt, test: Expr): Stmt => ({
      kind: 'if',
      place: test.place,
      test,
      yes: { kind: 'block', place: test.place, body: [body] },
      no: null,
    });
    this.hoisted.push(guards.reduceRight<Stmt>(under, { kind: 'expression', place, expression: assign }));
    return variable;
  }

  /** The variable that a hoisted declaration becomes. */
  private settle(init: Expr, guards: Guards, like: Variable): Variable {
    if (isUniform(init) && init.kind === 'variable') return init.variable;
    return this.isDerivable(init) ? this.derive(init, like) : this.share(init, guards, like);
  }

  private variable(init: Expr, role: 'shared' | 'derived', like?: Variable): Variable {
    const name = `${this.f.name}${this.f.id}${like?.name ?? ''}`;
    return { id: this.nextId++, name, type: init.type, role, constant: null, assigned: role === 'shared' };
  }

  private derive(init: Expr, like?: Variable): Variable {
    const key = `derived|${textOf(init)}`;
    const found = this.known.get(key);
    if (found) return found;
    const variable = this.variable(init, 'derived', like);
    this.known.set(key, variable);
    this.derived.push({ variable, init });
    return variable;
  }

  /** Replaces the largest parts that depend on parameters alone. */
  private deriveWithin(e: Expr): Expr {
    if (isUniform(e)) return e;
    if (!isWorthwhile(e) || !this.isDerivable(e) || isCheap(e))
      return mapChildren(e, (child) => this.deriveWithin(child));
    return this.read(this.derive(e), e);
  }

  private read(variable: Variable, like: Expr): Expr {
    return { kind: 'variable', place: like.place, type: like.type, constant: false, variable };
  }

  /** Whether a uniform can hold it and the parameters determine it. */
  private isDerivable(e: Expr): boolean {
    const determined = (node: Expr) =>
      node.kind !== 'variable' ||
      node.variable.role === 'derived' ||
      node.variable.role === 'constant' ||
      (node.variable.role === 'parameter' && node.variable.type !== TABLE);
    return (
      this.even &&
      scalarOf(e.type) === 'float' &&
      componentCount(e.type) > 0 &&
      !someNode(e, (node) => !determined(node))
    );
  }
}

/** The constant that a statement returns, if that is all it does. */
function returnedConstant(s: Stmt): Expr | null {
  if (s.kind === 'block') return s.body.length === 1 ? returnedConstant(s.body[0] as Stmt) : null;
  return s.kind === 'return' && s.value?.constant ? s.value : null;
}

function isZero(e: Expr): boolean {
  return [evaluateExpression(e)].flat().every((component) => component === 0);
}

/** 0 where the test holds, else 1: by step() where it can be, which costs less than a selection. */
function unless(test: Expr): Expr {
  const { place } = test;
  const number = (value: number): Expr => ({ kind: 'literal', place, type: FLOAT, constant: true, value });
  if (test.kind === 'binary') {
    const { operator, left, right } = test;
    const both = (a: Expr, b: Expr): Expr => {
      const [x, y] = [unless(a), unless(b)];
      return {
        kind: 'binary',
        place,
        type: FLOAT,
        constant: x.constant && y.constant,
        operator: '*',
        left: x,
        right: y,
      };
    };
    if (operator === '||') return both(left, right);
    // min(a, b) < c is a < c || b < c, of which one often does not depend on the light.
    if (operator === '<' && left.kind === 'builtin' && left.name === 'min' && left.type === FLOAT) {
      const [a, b] = left.args as [Expr, Expr];
      return both({ ...test, left: a }, { ...test, left: b });
    }
    if ((operator === '<' || operator === '>') && left.type === FLOAT) {
      const args = operator === '<' ? [right, left] : [left, right];
      return { kind: 'builtin', place, type: FLOAT, constant: test.constant, name: 'step', args };
    }
  }
  return {
    kind: 'ternary',
    place,
    type: FLOAT,
    constant: test.constant,
    test,
    yes: number(0),
    no: number(1),
  };
}

function isUniform(e: Expr): boolean {
  return e.kind === 'variable' && (e.variable.role === 'parameter' || e.variable.role === 'derived');
}

/** Whether an operation on numbers that are at hand costs less than another uniform: those are checked when they are read. */
function isCheap(e: Expr): boolean {
  const atHand = (child: Expr): boolean =>
    isUniform(child) || isArithmetic(child) || (child.kind === 'swizzle' && isUniform(child.object));
  if (e.kind === 'binary') return e.operator !== '/' && atHand(e.left) && atHand(e.right);
  if (e.kind === 'unary') return atHand(e.operand);
  return e.kind === 'swizzle' && atHand(e);
}

/** Whether this is literals and operators on them, which a compiler of shaders folds. */
function isArithmetic(e: Expr): boolean {
  if (e.kind === 'literal') return true;
  return (
    (e.kind === 'binary' && isArithmetic(e.left) && isArithmetic(e.right)) ||
    (e.kind === 'unary' && isArithmetic(e.operand))
  );
}

/** Whether computing this costs more than reading a variable. */
function isWorthwhile(e: Expr): boolean {
  if (
    e.constant ||
    isArithmetic(e) ||
    e.type.kind === 'void' ||
    e.type.kind === 'struct' ||
    e.type.kind === 'array'
  )
    return false;
  // A parameter is a uniform: reading one anew for each light costs a bounds check each time.
  if (e.kind === 'variable') return isUniform(e) && e.type !== TABLE;
  // The whole vector is at hand where one of its components is.
  if (e.kind === 'swizzle' && isUniform(e.object)) return false;
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
