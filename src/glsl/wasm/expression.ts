import { wholeExponent } from '../emit.ts';
import { evaluateExpression } from '../float64.ts';
import type { Expr, FunctionIR, Variable } from '../ir.ts';
import { componentCount, type ScalarName, scalarOf, type Type } from '../types.ts';
import type { Body } from './body.ts';
import { builtin } from './builtins.ts';
import { type Code, i32, localGet, op, select } from './code.ts';
import { construct } from './construct.ts';
import { hasEffects, isVariablePart } from './effects.ts';
import { cellsOf, constantCells, fieldStart } from './layout.ts';
import { mathFunction } from './math.ts';
import { isLoad, loadAt, splitIndex } from './memory.ts';
import { ELSE, END, IF, TYPE_CODES } from './opcodes.ts';
import { arithmetic, compareCells, complement, equal, negate } from './operators.ts';
import { type Place, readPlace, readTarget, type Target } from './places.ts';
import type { Unit } from './unit.ts';
import { components, compose } from './vectors.ts';

/** More instructions than this are worth a branch around them. */
const MAX_SPECULATED = 12;

/**
 * Writes expressions. Each gives the code of its cells, which is written where it is used; what an expression
 * changes is written at once. So where a later expression changes something, what earlier ones read is
 * computed before.
 */
export abstract class ExpressionWriter {
  protected readonly places = new Map<Variable, Place>();
  protected readonly body: Body;
  protected readonly unit: Unit;

  constructor(unit: Unit, body: Body) {
    this.unit = unit;
    this.body = body;
  }

  protected abstract call(e: Extract<Expr, { kind: 'call' }>): readonly Code[];
  /** The value of a function and its outputs. */
  protected abstract callFunction(
    callee: FunctionIR,
    values: readonly (readonly Code[])[],
  ): [readonly Code[], (readonly Code[])[]];
  protected abstract placeOf(variable: Variable): Place;
  protected abstract target(e: Expr): Target;
  /** An element of what is no part of a variable. */
  protected abstract element(e: Extract<Expr, { kind: 'index' }>): readonly Code[];
  /** Without `wanted` the value is not made. */
  protected abstract assign(e: Extract<Expr, { kind: 'assign' }>, wanted: boolean): readonly Code[];
  protected abstract step(e: Extract<Expr, { kind: 'step' }>, wanted: boolean): readonly Code[];

  /** Several expressions in order. */
  protected expressions(list: readonly Expr[]): (readonly Code[])[] {
    return list.map((e, i) => {
      const codes = this.expression(e);
      return list.slice(i + 1).some(hasEffects) ? this.body.pinAll(codes) : codes;
    });
  }

  protected scalar(e: Expr): Code {
    return this.expression(e)[0] as Code;
  }

  protected expression(e: Expr): readonly Code[] {
    if (e.constant) return constantCells(evaluateExpression(e), e.type);
    switch (e.kind) {
      case 'literal':
        return constantCells(e.value, e.type);
      case 'variable':
        return readPlace(this.body, this.placeOf(e.variable), e.type);
      case 'unary': {
        const cells = this.expression(e.operand);
        if (e.operator === '!') return [op('i32.eqz', cells[0] as Code)];
        return e.operator === '~' ? complement(cells) : negate(cells, scalarOf(e.type) as ScalarName);
      }
      case 'binary':
        return this.binary(e);
      case 'ternary':
        return this.ternary(e);
      case 'call':
        return this.call(e);
      case 'builtin':
        if (isLoad(e.name)) {
          const { varying, constant } = splitIndex(e.args[0] as Expr);
          return [loadAt(this.unit, e.name, varying && this.scalar(varying), constant)];
        }
        return this.mathematics(e) ?? builtin(this.unit, this.body, e, this.expressions(e.args));
      case 'construct': {
        const types = e.args.map((arg) => arg.type);
        return construct(this.body, e.type, this.expressions(e.args), types);
      }
      case 'swizzle': {
        if (isVariablePart(e)) return readTarget(this.body, this.target(e));
        const parts = components(this.body, this.expression(e.object), e.object.type);
        const chosen = e.components.map((k) => parts[k] as Code);
        // A component that stands twice is computed once.
        const repeated = new Set(e.components).size < e.components.length;
        const codes = repeated ? this.pinnedTogether(chosen) : chosen;
        return compose(this.body, codes, scalarOf(e.type) as ScalarName);
      }
      case 'index':
        return isVariablePart(e) ? readTarget(this.body, this.target(e)) : this.element(e);
      case 'field': {
        if (isVariablePart(e)) return readTarget(this.body, this.target(e));
        const type = e.object.type as Extract<Type, { kind: 'struct' }>;
        const start = fieldStart(type, e.field);
        return this.expression(e.object).slice(start, start + cellsOf(e.type).length);
      }
      case 'assign':
        return this.assign(e, true);
      case 'step':
        return this.step(e, true);
      case 'sequence':
        for (const item of e.items.slice(0, -1)) this.effect(item);
        return this.expression(e.items.at(-1) as Expr);
    }
  }

  /** sin() and its like by functions of our own: vectors four at once. */
  private mathematics(e: Extract<Expr, { kind: 'builtin' }>): readonly Code[] | null {
    const size = componentCount(e.type);
    const f = mathFunction(e.name, e.args.length, size === 1 ? 'scalar' : 'vector');
    if (!f || wholeExponent(e) !== null) return null;
    const args = this.expressions(e.args);
    if (size === 1 || size === 4) return this.callFunction(f, args)[0];
    const padded = args.map((cells): readonly Code[] => {
      const first = this.body.pin(cells[0] as Code);
      return compose(this.body, [first, cells[1] as Code, cells[2] ?? first, first], 'float');
    });
    const [result] = this.callFunction(f, padded);
    return components(this.body, result, f.result).slice(0, size);
  }

  private pinnedTogether(codes: readonly Code[]): readonly Code[] {
    const pinned = new Map(codes.map((code) => [code, code] as const));
    for (const code of pinned.keys()) pinned.set(code, this.body.pin(code));
    return codes.map((code) => pinned.get(code) as Code);
  }

  /** An expression for what it does, not for its value. */
  protected effect(e: Expr): void {
    if (e.kind === 'assign') this.assign(e, false);
    else if (e.kind === 'step') this.step(e, false);
    else if (e.kind === 'sequence') for (const item of e.items) this.effect(item);
    else this.expression(e);
  }

  private binary(e: Extract<Expr, { kind: 'binary' }>): readonly Code[] {
    if (e.operator === '&&' || e.operator === '||') return this.logical(e);
    const [left, right] = this.expressions([e.left, e.right]) as [readonly Code[], readonly Code[]];
    const name = scalarOf(e.left.type) as ScalarName;
    switch (e.operator) {
      case '^^':
        return [op('i32.ne', left[0] as Code, right[0] as Code)];
      case '==':
        return [equal(left, right, name)];
      case '!=':
        return [op('i32.eqz', equal(left, right, name))];
      case '<':
      case '>':
      case '<=':
      case '>=':
        return compareCells(e.operator, left, right, name);
      default:
        return arithmetic(this.body, e.operator, left, right, e.left.type, e.right.type);
    }
  }

  private logical(e: Extract<Expr, { kind: 'binary' }>): readonly Code[] {
    const left = this.scalar(e.left);
    let right = i32(0);
    const lines = this.body.apart(() => {
      right = this.scalar(e.right);
    });
    const isAnd = e.operator === '&&';
    if (left.constant !== null && lines.length === 0) return [(left.constant !== 0) === isAnd ? right : left];
    if (lines.length === 0 && right.cost <= MAX_SPECULATED)
      return [op(isAnd ? 'i32.and' : 'i32.or', left, right)];
    return isAnd
      ? this.branch(left, [lines, [right]], [[], [i32(0)]])
      : this.branch(left, [[], [i32(1)]], [lines, [right]]);
  }

  private ternary(e: Extract<Expr, { kind: 'ternary' }>): readonly Code[] {
    const test = this.scalar(e.test);
    if (test.constant !== null) return this.expression(test.constant !== 0 ? e.yes : e.no);
    let yes: readonly Code[] = [];
    let no: readonly Code[] = [];
    const yesLines = this.body.apart(() => {
      yes = this.expression(e.yes);
    });
    const noLines = this.body.apart(() => {
      no = this.expression(e.no);
    });
    const cost = [...yes, ...no].reduce((sum, code) => sum + code.cost, 0);
    if (yesLines.length + noLines.length > 0 || cost > MAX_SPECULATED)
      return this.branch(test, [yesLines, yes], [noLines, no]);
    const shared = yes.length > 1 ? this.body.pin(test) : test;
    return yes.map((code, i) => select(shared, code, no[i] as Code));
  }

  /** One of two values, each given by its instructions and what they leave, by a branch. */
  private branch(test: Code, yes: Side, no: Side): readonly Code[] {
    const [first] = yes[1];
    if (yes[1].length === 1 && first && yes[0].length + no[0].length === 0) {
      const [other] = no[1] as readonly [Code];
      const bytes = [test.bytes, IF, TYPE_CODES[first.type], first.bytes, ELSE, other.bytes, END];
      return [{ type: first.type, bytes, cost: Number.POSITIVE_INFINITY, stable: false, constant: null }];
    }
    const results = yes[1].map(({ type }) => ({ index: this.body.local(type), type }));
    const side = ([lines, codes]: Side) =>
      this.body.apart(() => {
        this.body.push(lines);
        for (const code of codes) this.body.push(code.bytes);
        for (const { index } of results.toReversed()) this.body.set(index);
      });
    this.body.if(test, side(yes), side(no));
    return results.map(({ index, type }) => localGet(index, type, true));
  }
}

/** Instructions, and code of the cells that may follow them. */
type Side = readonly [lines: readonly number[], codes: readonly Code[]];
