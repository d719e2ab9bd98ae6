import { builtinFloat64 } from './float64-builtins.ts';
import { arithmetic, constructFloat64, zeroOf } from './float64-values.ts';
import type { Expr, FunctionIR, Program, Stmt, Value, Variable } from './ir.ts';
import { componentCount, scalarOf, type Type } from './types.ts';

/**
 * The typed program as float64 functions: a closure per node, no eval. It is the oracle that every GPU
 * path is tested against, and evaluates where there is no GPU.
 *
 * GLSL forbids recursion, so each variable has one cell for good and a call needs no frame.
 */

type Run = () => Value;
/** What a statement did: went on, or asked its surroundings to break, continue or return. */
type Act = () => 0 | 1 | 2 | 3;
const [NEXT, BREAK, CONTINUE, RETURN] = [0, 1, 2, 3] as const;

interface Cell {
  value: Value;
}

/** A program ready to be called. Not reentrant (its variables' cells are its own). */
export class Float64Program {
  private readonly cells = new Map<Variable, Cell>();
  private readonly functions = new Map<FunctionIR, { run: Run; args: readonly Cell[] }>();

  constructor(program?: Program) {
    for (const f of program?.functions ?? []) this.functions.set(f, this.compileFunction(f));
  }

  /** The cell of a variable; parameters are set through theirs. */
  cell(variable: Variable): Cell {
    let cell = this.cells.get(variable);
    if (!cell) {
      cell = { value: variable.constant ?? zeroOf(variable.type) };
      this.cells.set(variable, cell);
    }
    return cell;
  }

  /** A function to call with values in the order of its arguments. */
  callable(f: FunctionIR): (...args: Value[]) => Value {
    const compiled = this.functions.get(f) as { run: Run; args: readonly Cell[] };
    return (...values) => {
      for (let i = 0; i < values.length; i++) (compiled.args[i] as Cell).value = values[i] as Value;
      return compiled.run();
    };
  }

  private compileFunction(f: FunctionIR): { run: Run; args: readonly Cell[] } {
    const args = f.arguments.map(({ variable }) => this.cell(variable));
    const result: Cell = { value: zeroOf(f.result) };
    const body = this.sequence(f.body.map((statement) => this.statement(statement, result)));
    const nothing = zeroOf(f.result);
    const run: Run = () => {
      result.value = nothing;
      body();
      return result.value;
    };
    return { run, args };
  }

  private sequence(acts: readonly Act[]): Act {
    const count = acts.length;
    if (count === 1) return acts[0] as Act;
    return () => {
      for (let i = 0; i < count; i++) {
        const signal = (acts[i] as Act)();
        if (signal !== NEXT) return signal;
      }
      return NEXT;
    };
  }

  private statement(s: Stmt, result: Cell): Act {
    switch (s.kind) {
      case 'declare': {
        const cell = this.cell(s.variable);
        const init = s.init ? this.expression(s.init) : () => zeroOf(s.variable.type);
        return () => {
          cell.value = init();
          return NEXT;
        };
      }
      case 'expression': {
        const run = this.expression(s.expression);
        return () => {
          run();
          return NEXT;
        };
      }
      case 'block':
        return this.sequence(s.body.map((inner) => this.statement(inner, result)));
      case 'if': {
        const test = this.expression(s.test);
        const yes = this.statement(s.yes, result);
        const no: Act = s.no ? this.statement(s.no, result) : () => NEXT;
        return () => (test() ? yes() : no());
      }
      case 'loop': {
        const test = this.expression(s.test);
        const body = this.statement(s.body, result);
        return () => {
          while (test()) {
            const signal = body();
            if (signal === BREAK) break;
            if (signal === RETURN) return RETURN;
          }
          return NEXT;
        };
      }
      case 'for': {
        const cell = this.cell(s.variable);
        const [first, test, step] = [
          this.expression(s.first),
          this.expression(s.test),
          this.expression(s.step),
        ];
        const body = this.statement(s.body, result);
        return () => {
          for (cell.value = first(); test(); step()) {
            const signal = body();
            if (signal === BREAK) break;
            if (signal === RETURN) return RETURN;
          }
          return NEXT;
        };
      }
      case 'return': {
        if (!s.value) return () => RETURN;
        const value = this.expression(s.value);
        return () => {
          result.value = value();
          return RETURN;
        };
      }
      case 'break':
        return () => BREAK;
      case 'continue':
        return () => CONTINUE;
    }
  }

  expression(e: Expr): Run {
    switch (e.kind) {
      case 'literal': {
        const { value } = e;
        return () => value;
      }
      case 'variable': {
        const cell = this.cell(e.variable);
        return () => cell.value;
      }
      case 'unary': {
        const operand = this.expression(e.operand);
        if (e.operator === '!') return () => !operand();
        if (e.operator === '~') return this.wrapped(e.type, () => map(operand(), (x) => ~x));
        return this.wrapped(
          e.type,
          e.type.kind === 'scalar' ? () => -(operand() as number) : () => map(operand(), (x) => -x),
        );
      }
      case 'binary':
        return this.binary(e);
      case 'ternary': {
        const [test, yes, no] = [this.expression(e.test), this.expression(e.yes), this.expression(e.no)];
        return () => (test() ? yes() : no());
      }
      case 'call':
        return this.call(e);
      case 'builtin': {
        const args = e.args.map((arg) => this.expression(arg));
        const f = builtinFloat64(
          e.name,
          e.args.map((arg) => arg.type),
        );
        const [a, b, c] = args as [Run, Run, Run];
        if (args.length === 1) return () => f(a());
        if (args.length === 2) return () => f(a(), b());
        return () => f(a(), b(), c());
      }
      case 'construct': {
        const args = e.args.map((arg) => this.expression(arg));
        const build = constructFloat64(
          e.type,
          e.args.map((arg) => arg.type),
        );
        if (args.length === 1) {
          const [only] = args as [Run];
          return () => build([only()]);
        }
        if (args.length === 3) {
          const [a, b, c] = args as [Run, Run, Run];
          return () => build([a(), b(), c()]);
        }
        return () => build(args.map((arg) => arg()));
      }
      case 'swizzle': {
        const object = this.expression(e.object);
        const { components } = e;
        const [first = 0, second = 0, third = 0] = components;
        if (components.length === 1) return () => (object() as readonly number[])[first] as number;
        if (components.length === 2) {
          return () => {
            const value = object() as readonly number[];
            return [value[first] as number, value[second] as number];
          };
        }
        if (components.length === 3) {
          return () => {
            const value = object() as readonly number[];
            return [value[first] as number, value[second] as number, value[third] as number];
          };
        }
        return () => {
          const value = object() as readonly number[];
          return components.map((c) => value[c] as number);
        };
      }
      case 'index': {
        const [object, index] = [this.expression(e.object), this.expression(e.index)];
        const rows = e.object.type.kind === 'matrix' ? e.object.type.rows : 0;
        return () => {
          const list = object() as readonly Value[];
          // Out of range is undefined in GLSL; WGSL clamps, and so do we.
          const i = Math.max(0, Math.min(index() as number, (rows ? list.length / rows : list.length) - 1));
          return rows ? list.slice(i * rows, (i + 1) * rows) : (list[i] as Value);
        };
      }
      case 'field': {
        const object = this.expression(e.object);
        return () => (object() as readonly Value[])[e.field] as Value;
      }
      case 'assign': {
        const store = this.store(e.target);
        const value = this.expression(e.value);
        if (e.operator === null) return () => store(value());
        const read = this.expression(e.target);
        const f = arithmetic(e.operator, e.target.type, e.value.type);
        return () => store(f(read(), value()));
      }
      case 'step': {
        const [read, store] = [this.expression(e.target), this.store(e.target)];
        const change = e.operator === '++' ? 1 : -1;
        let before: Value = 0;
        const next = this.wrapped(e.type, () => map(before, (x) => x + change));
        return () => {
          before = read();
          const old = before;
          const after = store(next());
          return e.prefix ? after : old;
        };
      }
      case 'sequence': {
        const items = e.items.map((item) => this.expression(item));
        return () => items.reduce<Value>((_, item) => item(), 0);
      }
    }
  }

  /** Whole numbers of 32 bits go round. */
  private wrapped(type: Type, run: Run): Run {
    const base = scalarOf(type);
    if (base === 'uint') return () => map(run(), (x) => x >>> 0);
    if (base === 'int') return () => map(run(), (x) => x | 0);
    return run;
  }

  private binary(e: Extract<Expr, { kind: 'binary' }>): Run {
    const [left, right] = [this.expression(e.left), this.expression(e.right)];
    switch (e.operator) {
      case '&&':
        return () => left() === true && right() === true;
      case '||':
        return () => left() === true || right() === true;
      case '^^':
        return () => left() !== right();
      case '<':
        return () => (left() as number) < (right() as number);
      case '>':
        return () => (left() as number) > (right() as number);
      case '<=':
        return () => (left() as number) <= (right() as number);
      case '>=':
        return () => (left() as number) >= (right() as number);
      case '==':
        return () => same(left(), right());
      case '!=':
        return () => !same(left(), right());
      default: {
        const floats = isFloat(e.left.type) && isFloat(e.right.type);
        const run = floats ? ofFloats(e.operator, left as () => number, right as () => number) : null;
        if (run) return run;
        const f = arithmetic(e.operator, e.left.type, e.right.type);
        return () => f(left(), right());
      }
    }
  }

  private call(e: Extract<Expr, { kind: 'call' }>): Run {
    const { run, args: cells } = this.functions.get(e.callee) as { run: Run; args: readonly Cell[] };
    const read = e.args.map((arg) => this.expression(arg));
    const outputs = e.callee.arguments.flatMap(({ qualifier }, i) =>
      qualifier === 'in' ? [] : [{ cell: cells[i] as Cell, store: this.store(e.args[i] as Expr) }],
    );
    const count = read.length;
    if (count === 1 && outputs.length === 0) {
      const [only, cell] = [read[0] as Run, cells[0] as Cell];
      return () => {
        cell.value = only();
        return run();
      };
    }
    if (count === 2 && outputs.length === 0) {
      const [[first, second], [a, b]] = [read as [Run, Run], cells as [Cell, Cell]];
      return () => {
        const value = first();
        b.value = second();
        a.value = value;
        return run();
      };
    }
    return () => {
      // All arguments first: one may call this very function.
      const values = new Array<Value>(count);
      for (let i = 0; i < count; i++) values[i] = (read[i] as Run)();
      for (let i = 0; i < count; i++) (cells[i] as Cell).value = values[i] as Value;
      const result = run();
      for (const { cell, store } of outputs) store(cell.value);
      return result;
    };
  }

  /** Assigns to a variable or a part of one; values are never changed in place. */
  private store(target: Expr): (value: Value) => Value {
    if (target.kind === 'variable') {
      const cell = this.cell(target.variable);
      return (value) => (cell.value = value);
    }
    if (target.kind !== 'swizzle' && target.kind !== 'index' && target.kind !== 'field')
      throw new Error('unreachable: the checker refuses this target');
    const read = this.expression(target.object);
    const store = this.store(target.object);
    if (target.kind === 'swizzle') {
      const { components } = target;
      return (value) => {
        const next = [...(read() as readonly Value[])];
        if (components.length === 1) next[components[0] as number] = value;
        else for (const [i, c] of components.entries()) next[c] = (value as readonly Value[])[i] as Value;
        store(next);
        return value;
      };
    }
    const index: Run = target.kind === 'field' ? () => target.field : this.expression(target.index);
    const rows =
      target.kind === 'index' && target.object.type.kind === 'matrix' ? componentCount(target.type) : 0;
    return (value) => {
      const next = [...(read() as readonly Value[])];
      const i = Math.max(0, Math.min(index() as number, (rows ? next.length / rows : next.length) - 1));
      if (rows) next.splice(i * rows, rows, ...(value as readonly Value[]));
      else next[i] = value;
      store(next);
      return value;
    };
  }
}

const isFloat = (type: Type): boolean => type.kind === 'scalar' && type.scalar === 'float';

/** Most of what a BRDF computes; each has a closure of its own, which engines make one piece of. */
function ofFloats(operator: string, left: () => number, right: () => number): Run | null {
  switch (operator) {
    case '+':
      return () => left() + right();
    case '-':
      return () => left() - right();
    case '*':
      return () => left() * right();
    case '/':
      return () => left() / right();
    default:
      return null;
  }
}

/** The value of an expression that reads constants and at most one variable, which is given. */
export function evaluateExpression(e: Expr, variable?: Variable, value: Value = 0): Value {
  const program = new Float64Program();
  if (variable) program.cell(variable).value = value;
  return program.expression(e)();
}

function map(value: Value, f: (x: number) => number): Value {
  return Array.isArray(value) ? (value as readonly number[]).map(f) : f(value as number);
}

function same(a: Value, b: Value): boolean {
  if (Array.isArray(a) && Array.isArray(b)) return a.every((x, i) => x === b[i]);
  return a === b;
}
