import type { Expr, FunctionIR, Stmt, Variable } from '../ir.ts';
import { returns } from '../rewrite.ts';
import { Body, type Label } from './body.ts';
import { type Code, localGet, op } from './code.ts';
import { addressedVariables, hasEffects, isLarge } from './effects.ts';
import { cellsOf, sizeOf, zeroCells } from './layout.ts';
import { CALL, type WasmType } from './opcodes.ts';
import {
  localPlace,
  localRef,
  type Place,
  readPlace,
  type Target,
  valuePlace,
  writePlace,
  writeTarget,
} from './places.ts';
import { TargetWriter } from './targets.ts';
import type { Unit } from './unit.ts';

/** Where `return` leads: out of the function whose body is being written. */
interface Exit {
  readonly end: Label;
  readonly result: Place;
}
/** Where `break` and `continue` lead. */
interface Turn {
  readonly end: Label;
  readonly next: Label;
}

/** The cells of a function's arguments: its own but for `out`, then the parameters that it reads. */
export function argumentCells(f: FunctionIR): readonly WasmType[] {
  const own = f.arguments.filter(({ qualifier }) => qualifier !== 'out').map(({ variable }) => variable);
  return [...own, ...f.uses].flatMap(({ type }) => cellsOf(type));
}

/** The cells that a function gives back: its value, then its out and inout arguments. */
export function resultCells(f: FunctionIR): readonly WasmType[] {
  return [...cellsOf(f.result), ...outputsOf(f).flatMap(({ type }) => cellsOf(type))];
}

function outputsOf(f: FunctionIR): readonly Variable[] {
  return f.arguments.filter(({ qualifier }) => qualifier !== 'in').map(({ variable }) => variable);
}

/** Writes one function, with the bodies of others in the place of their calls where the unit wants that. */
export class FunctionWriter extends TargetWriter {
  private addressed: ReadonlySet<Variable> = new Set();
  private exit: Exit | null = null;
  private turn: Turn | null = null;

  constructor(unit: Unit, f: FunctionIR) {
    super(unit, new Body(argumentCells(f)));
  }

  write(f: FunctionIR): { locals: readonly WasmType[]; bytes: number[] } {
    let next = 0;
    const parameter = (variable: Variable): Place => {
      const refs = cellsOf(variable.type).map((cell) => {
        const index = next++;
        return localRef(index, localGet(index, cell, !variable.assigned));
      });
      return { kind: 'cells', refs };
    };
    const own = f.arguments.map(({ variable, qualifier }) =>
      qualifier === 'out' ? null : parameter(variable),
    );
    for (const variable of f.uses) this.places.set(variable, parameter(variable));
    this.addressed = addressedVariables(f);
    for (const [i, { variable }] of f.arguments.entries()) {
      const place = own[i];
      if (place && !this.liesInMemory(variable)) this.places.set(variable, place);
      else
        this.declare(variable, () =>
          place ? readPlace(this.body, place, variable.type) : zeroCells(variable.type),
        );
    }
    const value = this.run(f);
    const outputs = outputsOf(f).flatMap((variable) => [...this.read(variable)]);
    return this.body.finish([...value, ...outputs], this.unit.stack);
  }

  private read(variable: Variable): readonly Code[] {
    return readPlace(this.body, this.placeOf(variable), variable.type);
  }

  private liesInMemory(variable: Variable): boolean {
    return this.addressed.has(variable) || isLarge(variable);
  }

  /** Room for a variable until the present scope ends, with a value; what computing it takes is free at once. */
  private declare(variable: Variable, value: () => readonly Code[]): void {
    const { type } = variable;
    const place: Place = this.liesInMemory(variable)
      ? { kind: 'memory', ...this.body.reserve(sizeOf(cellsOf(type))) }
      : localPlace(this.body, type, !variable.assigned);
    this.body.scoped(() => writePlace(this.body, place, type, value()));
    this.places.set(variable, place);
  }

  /** The body of a function whose arguments have their places; its value. */
  private run(f: FunctionIR): readonly Code[] {
    const outer = { addressed: this.addressed, exit: this.exit, turn: this.turn };
    this.addressed = addressedVariables(f);
    this.turn = null;
    const value = this.runBody(f);
    Object.assign(this, outer);
    return value;
  }

  private runBody(f: FunctionIR): readonly Code[] {
    const last = f.body.at(-1);
    const plain = last?.kind === 'return' ? f.body.slice(0, -1) : f.body;
    if (!plain.some(returns)) {
      this.statements(plain);
      return last?.kind === 'return' && last.value ? this.expression(last.value) : zeroCells(f.result);
    }
    const result = localPlace(this.body, f.result, true);
    writePlace(this.body, result, f.result, zeroCells(f.result));
    this.body.block((end) => {
      this.exit = { end, result };
      this.statements(f.body);
    });
    return readPlace(this.body, result, f.result);
  }

  private statements(body: readonly Stmt[]): void {
    for (const statement of body) this.statement(statement);
  }

  private statement(s: Stmt): void {
    const { body } = this;
    switch (s.kind) {
      case 'declare': {
        const { init, variable } = s;
        this.declare(variable, () => (init ? this.expression(init) : zeroCells(variable.type)));
        return;
      }
      case 'expression':
        body.scoped(() => this.effect(s.expression));
        return;
      case 'block':
        body.scoped(() => this.statements(s.body));
        return;
      case 'if':
        body.scoped(() => this.ifStatement(s));
        return;
      case 'for':
        body.scoped(() => {
          this.declare(s.variable, () => this.expression(s.first));
          this.loop(s.test, s.body, () => this.effect(s.step));
        });
        return;
      case 'loop':
        this.loop(s.test, s.body, () => {});
        return;
      case 'return': {
        const { end, result } = this.exit as Exit;
        const { value } = s;
        if (value) body.scoped(() => writePlace(body, result, value.type, this.expression(value)));
        body.branch(end);
        return;
      }
      case 'break':
        body.branch((this.turn as Turn).end);
        return;
      case 'continue':
        body.branch((this.turn as Turn).next);
    }
  }

  private ifStatement(s: Extract<Stmt, { kind: 'if' }>): void {
    const test = this.scalar(s.test);
    if (test.constant !== null) {
      const taken = test.constant !== 0 ? s.yes : s.no;
      if (taken) this.statement(taken);
      return;
    }
    const side = (inner: Stmt | null) =>
      this.body.apart(() => {
        if (inner) this.body.scoped(() => this.statement(inner));
      });
    this.body.if(test, side(s.yes), side(s.no));
  }

  private loop(test: Expr, inner: Stmt, step: () => void): void {
    const { body, turn } = this;
    body.block((end) => {
      body.loop((start) => {
        body.scoped(() => {
          const code = this.scalar(test);
          if (code.constant === null) body.branchIf(op('i32.eqz', code), end);
          else if (code.constant === 0) body.branch(end);
        });
        body.block((next) => {
          this.turn = { end, next };
          body.scoped(() => this.statement(inner));
        });
        body.scoped(step);
        body.branch(start);
      });
    });
    this.turn = turn;
  }

  protected call(e: Extract<Expr, { kind: 'call' }>): readonly Code[] {
    const { callee } = e;
    const targets: (Target | null)[] = [];
    const values = callee.arguments.map(({ variable, qualifier }, i): readonly Code[] => {
      const arg = e.args[i] as Expr;
      targets.push(qualifier === 'in' ? null : this.target(arg));
      const codes = qualifier === 'out' ? zeroCells(variable.type) : this.expression(arg);
      return e.args.slice(i + 1).some(hasEffects) ? this.body.pinAll(codes) : codes;
    });
    const [result, outputs] = this.callFunction(callee, values);
    for (const target of targets)
      if (target) writeTarget(this.body, target, outputs.shift() as readonly Code[]);
    return result;
  }

  protected callFunction(
    callee: FunctionIR,
    values: readonly (readonly Code[])[],
  ): [readonly Code[], (readonly Code[])[]] {
    return this.unit.inlines(callee) ? this.inlineCall(callee, values) : this.plainCall(callee, values);
  }

  private inlineCall(
    callee: FunctionIR,
    values: readonly (readonly Code[])[],
  ): [readonly Code[], (readonly Code[])[]] {
    const { addressed } = this;
    this.addressed = addressedVariables(callee);
    for (const [i, { variable, qualifier }] of callee.arguments.entries()) {
      const codes = values[i] as readonly Code[];
      const fixed = qualifier === 'in' && !variable.assigned && codes.every(({ stable }) => stable);
      if (fixed && !this.liesInMemory(variable)) this.places.set(variable, valuePlace(codes));
      else this.declare(variable, () => codes);
    }
    this.addressed = addressed;
    const value = this.run(callee);
    const outputs = outputsOf(callee);
    // Storing the outputs may change what the value's code reads.
    const result = outputs.length > 0 ? this.body.pinAll(value) : value;
    return [result, outputs.map((variable) => this.read(variable))];
  }

  private plainCall(
    callee: FunctionIR,
    values: readonly (readonly Code[])[],
  ): [readonly Code[], (readonly Code[])[]] {
    for (const [i, codes] of values.entries())
      if (callee.arguments[i]?.qualifier !== 'out') for (const code of codes) this.body.push(code.bytes);
    for (const variable of callee.uses) for (const code of this.read(variable)) this.body.push(code.bytes);
    this.body.push([CALL, -1 - this.unit.symbol(callee)]);
    const results = resultCells(callee).map((type) => ({ type, index: this.body.local(type) }));
    for (const { index } of results.toReversed()) this.body.set(index);
    const codes = results.map(({ type, index }) => localGet(index, type, true));
    const take = (type: Parameters<typeof cellsOf>[0]) => codes.splice(0, cellsOf(type).length);
    return [take(callee.result), outputsOf(callee).map(({ type }) => take(type))];
  }
}
