import { evaluateExpression } from './float64.ts';
import type { Expr, FunctionIR, Stmt, Value, Variable } from './ir.ts';
import { children } from './order.ts';
import { componentCount, type StructType, scalarOf, type Type } from './types.ts';

/** Text in a shading language, with what must stand before it. */
export interface EmittedFunction {
  readonly name: string;
  readonly code: string;
  /** Small functions of our own that it calls, and structs that it uses: name to code. */
  readonly needs: ReadonlyMap<string, string>;
}

/**
 * Writes one function of the program as text of a shading language: the walk that both languages share.
 * The model parameters that it reads follow its own arguments, in the order of `uses`.
 */
export abstract class FunctionEmitter {
  protected readonly needs = new Map<string, string>();
  /** The statements of the innermost block that is being written. */
  protected lines: string[] = [];
  /** Constants that are not plain numbers or vectors, declared at the function's start. */
  private readonly constants = new Map<Variable, string>();
  private temporaries = 0;
  protected readonly prefix: string;
  protected readonly f: FunctionIR;

  /** @param prefix starts every global name, so that several models can share a shader */
  constructor(f: FunctionIR, prefix: string) {
    this.f = f;
    this.prefix = prefix;
  }

  emit(): EmittedFunction {
    const body = this.block(() => {
      for (const statement of this.f.body) this.statement(statement);
      if (this.f.result.kind !== 'void' && !alwaysReturns(this.f.body))
        this.lines.push(`return ${this.zero(this.f.result)};`);
    });
    const entry = this.block(() => this.enter());
    const constants = [...this.constants].map(([variable, name]) =>
      this.declaration(name, variable.type, this.constant(variable.constant as Value, variable.type)),
    );
    const lines = [...constants, ...entry, ...body].map((line) => `  ${line}`);
    return {
      name: this.functionName(this.f),
      code: `${this.signature()} {\n${lines.join('\n')}\n}\n`,
      needs: this.needs,
    };
  }

  functionName(f: FunctionIR): string {
    return `${this.prefix}_${clean(f.name)}_${f.id}`;
  }

  protected variableName(variable: Variable): string {
    return `${clean(variable.name)}_${variable.id}`;
  }

  protected structName(type: StructType): string {
    return `${this.prefix}_${clean(type.name)}`;
  }

  protected fieldName(name: string): string {
    return `${clean(name)}_`;
  }

  protected abstract signature(): string;
  /** Statements at the function's start that make its arguments usable. */
  protected abstract enter(): void;
  protected abstract typeName(type: Type): string;
  protected abstract structCode(type: StructType): string;
  /** A variable of the whole shader invocation. */
  protected abstract sharedDeclaration(name: string, type: Type): string;
  protected abstract declaration(name: string, type: Type, init: string): string;
  protected abstract builtin(e: Extract<Expr, { kind: 'builtin' }>, args: readonly string[]): string;
  protected abstract construct(type: Type, args: readonly string[], types: readonly Type[]): string;
  protected abstract operation(
    operator: string,
    left: string,
    right: string,
    leftType: Type,
    rightType: Type,
  ): string;
  protected abstract nonFinite(value: number): string;
  protected abstract call(e: Extract<Expr, { kind: 'call' }>): string;
  protected abstract ternary(e: Extract<Expr, { kind: 'ternary' }>): string;
  protected abstract logical(e: Extract<Expr, { kind: 'binary' }>): string;
  protected abstract assign(e: Extract<Expr, { kind: 'assign' }>): string;
  protected abstract step(e: Extract<Expr, { kind: 'step' }>): string;
  protected abstract sequence(e: Extract<Expr, { kind: 'sequence' }>): string;
  protected abstract readVariable(variable: Variable): string;
  /** Whether text of `e` may run later than the lines that follow it without a difference. */
  protected abstract hoists(e: Expr): boolean;

  /** Registers a struct and gives its name. */
  protected useStruct(type: StructType): string {
    const name = this.structName(type);
    if (!this.needs.has(name)) {
      for (const field of type.fields) if (field.type.kind === 'struct') this.useStruct(field.type);
      this.needs.set(name, this.structCode(type));
    }
    return name;
  }

  protected block(write: () => void): string[] {
    const outer = this.lines;
    this.lines = [];
    write();
    const inner = this.lines;
    this.lines = outer;
    return inner;
  }

  protected temporary(type: Type, init: string): string {
    const name = `t_${this.temporaries++}`;
    this.lines.push(this.declaration(name, type, init));
    return name;
  }

  protected zero(type: Type): string {
    switch (type.kind) {
      case 'void':
      case 'table':
        return '';
      case 'scalar':
        return this.literal(type.scalar === 'bool' ? false : 0, type);
      case 'vector':
        return this.construct(
          type,
          [
            this.literal(type.scalar === 'bool' ? false : 0, {
              kind: 'scalar',
              name: type.scalar,
              scalar: type.scalar,
            }),
          ],
          [{ kind: 'scalar', name: type.scalar, scalar: type.scalar }],
        );
      case 'matrix':
        return this.constant(new Array<Value>(type.columns * type.rows).fill(0), type);
      case 'array':
        return `${this.typeName(type)}(${Array.from({ length: type.length }, () => this.zero(type.element)).join(', ')})`;
      case 'struct':
        return `${this.useStruct(type)}(${type.fields.map((field) => this.zero(field.type)).join(', ')})`;
    }
  }

  /** A constant of any type, written out. */
  protected constant(value: Value, type: Type): string {
    switch (type.kind) {
      case 'void':
      case 'table':
      case 'scalar':
        return this.literal(value as number | boolean, type);
      case 'vector':
      case 'matrix': {
        const base = scalarOf(type) as 'float';
        return `${this.typeName(type)}(${(value as readonly number[]).map((x) => this.literal(x, { kind: 'scalar', name: base, scalar: base })).join(', ')})`;
      }
      case 'array':
        return `${this.typeName(type)}(${(value as readonly Value[]).map((x) => this.constant(x, type.element)).join(', ')})`;
      case 'struct':
        return `${this.useStruct(type)}(${(value as readonly Value[]).map((x, i) => this.constant(x, (type.fields[i] as { type: Type }).type)).join(', ')})`;
    }
  }

  protected literal(value: number | boolean, type: Type): string {
    if (typeof value === 'boolean') return String(value);
    const base = scalarOf(type);
    if (base === 'uint') return `${value}u`;
    if (base === 'int') return value < 0 ? `(${value})` : String(value);
    // Beyond float32 a literal is an error in WGSL; infinity is what the conversion would give.
    if (!Number.isFinite(Math.fround(value))) return this.nonFinite(value);
    const text = /[.e]/.test(String(value)) ? String(value) : `${value}.0`;
    return value < 0 || Object.is(value, -0) ? `(${Object.is(value, -0) ? '-0.0' : text})` : text;
  }

  /** Several expressions in order: what an earlier one reads must not be changed by a later one. */
  protected expressions(list: readonly Expr[]): string[] {
    return list.map((e, i) => {
      const text = this.expression(e);
      const atom = e.kind === 'literal' || e.constant;
      return !atom && list.slice(i + 1).some((later) => this.hoists(later))
        ? this.temporary(e.type, text)
        : text;
    });
  }

  protected expression(e: Expr): string {
    // Computed here: WGSL refuses constant expressions that are not finite, such as vec2(1) / 0.
    if (e.constant && componentCount(e.type) > 0) return this.constant(evaluateExpression(e), e.type);
    switch (e.kind) {
      case 'literal':
        return this.literal(e.value, e.type);
      case 'variable':
        return this.variable(e.variable);
      case 'unary': {
        const operand = this.expression(e.operand);
        if (e.operator === '-' && e.type.kind === 'matrix')
          return this.operation(
            '*',
            '(-1.0)',
            operand,
            { kind: 'scalar', name: 'float', scalar: 'float' },
            e.type,
          );
        return e.operator === '!' || e.operator === '~' || e.operator === '-'
          ? `(${e.operator}${operand})`
          : operand;
      }
      case 'binary': {
        if (e.operator === '&&' || e.operator === '||') return this.logical(e);
        const [left, right] = this.expressions([e.left, e.right]) as [string, string];
        return this.operation(e.operator, left, right, e.left.type, e.right.type);
      }
      case 'ternary':
        return this.ternary(e);
      case 'call':
        return this.call(e);
      case 'builtin':
        return this.builtin(e, this.expressions(e.args));
      case 'construct':
        return this.construct(
          e.type,
          this.expressions(e.args),
          e.args.map((arg) => arg.type),
        );
      case 'swizzle':
        return `${this.expression(e.object)}.${swizzle(e.components)}`;
      case 'index': {
        const [object, index] = this.expressions([e.object, e.index]);
        return `${object}[${index}]`;
      }
      case 'field': {
        const { type } = e.object;
        return `${this.expression(e.object)}.${this.fieldName(type.kind === 'struct' ? (type.fields[e.field]?.name ?? '') : '')}`;
      }
      case 'assign':
        return this.assign(e);
      case 'step':
        return this.step(e);
      case 'sequence':
        return this.sequence(e);
    }
  }

  private variable(variable: Variable): string {
    if (variable.role === 'shared') {
      const name = `${this.prefix}_${this.variableName(variable)}`;
      this.needs.set(name, this.sharedDeclaration(name, variable.type));
      return name;
    }
    if (variable.role !== 'constant') return this.readVariable(variable);
    if (componentCount(variable.type) > 0) return this.constant(variable.constant as Value, variable.type);
    const name = this.variableName(variable);
    this.constants.set(variable, name);
    return name;
  }

  protected statement(s: Stmt): void {
    switch (s.kind) {
      case 'declare':
        this.lines.push(
          this.declaration(
            this.variableName(s.variable),
            s.variable.type,
            s.init ? this.expression(s.init) : this.zero(s.variable.type),
          ),
        );
        return;
      case 'expression':
        this.effect(s.expression);
        return;
      case 'block':
        this.lines.push('{', ...this.indented(() => this.statementList(s.body)), '}');
        return;
      case 'if':
        this.lines.push(`if (${this.expression(s.test)}) {`, ...this.indented(() => this.branch(s.yes)));
        if (s.no) this.lines.push('} else {', ...this.indented(() => this.branch(s.no as Stmt)));
        this.lines.push('}');
        return;
      case 'for': {
        const first = this.declaration(
          this.variableName(s.variable),
          s.variable.type,
          this.expression(s.first),
        );
        const test = this.expression(s.test);
        const step = this.block(() => this.effect(s.step))
          .join(' ')
          .replace(/;$/, '');
        this.lines.push(
          `for (${first} ${test}; ${step}) {`,
          ...this.indented(() => this.statement(s.body)),
          '}',
        );
        return;
      }
      case 'loop': {
        const body = this.indented(() => {
          // What the test needs before it runs at every turn, so it stands inside.
          const test = this.expression(s.test);
          this.lines.push(`if (!(${test})) {`, '  break;', '}');
          this.branch(s.body);
        });
        this.lines.push('while (true) {', ...body, '}');
        return;
      }
      case 'return':
        this.lines.push(s.value ? `return ${this.expression(s.value)};` : 'return;');
        return;
      default:
        this.lines.push(`${s.kind};`);
    }
  }

  /** The body of an if or for: their braces serve a block, too. */
  private branch(s: Stmt): void {
    if (s.kind === 'block') this.statementList(s.body);
    else this.statement(s);
  }

  private statementList(body: readonly Stmt[]): void {
    for (const statement of body) this.statement(statement);
  }

  /** An expression for what it does, not for its value. */
  protected abstract effect(e: Expr): void;

  protected indented(write: () => void): string[] {
    return this.block(write).map((line) => `  ${line}`);
  }

  /** The arguments of a call: its own, then the model parameters that the callee reads. */
  protected parametersFor(callee: FunctionIR): string[] {
    return callee.uses.map((variable) => this.variableName(variable));
  }
}

export function swizzle(components: readonly number[]): string {
  return components.map((c) => 'xyzw'[c]).join('');
}

/** Whether evaluating this changes a variable. */
export function hasEffects(e: Expr): boolean {
  if (e.kind === 'assign' || e.kind === 'step') return true;
  if (e.kind === 'call' && e.callee.arguments.some(({ qualifier }) => qualifier !== 'in')) return true;
  return children(e).some(hasEffects);
}

/** Names of either language: no double or leading underscore, no keyword (an id follows every name). */
function clean(name: string): string {
  const plain = name.replace(/_+/g, '_').replace(/^_|_$/g, '');
  return /^[A-Za-z]/.test(plain) ? plain : `a${plain}`;
}

function alwaysReturns(body: readonly Stmt[]): boolean {
  const last = body.at(-1);
  if (!last) return false;
  if (last.kind === 'return') return true;
  if (last.kind === 'block') return alwaysReturns(last.body);
  return last.kind === 'if' && last.no !== null && alwaysReturns([last.yes]) && alwaysReturns([last.no]);
}

/** Texels per row of the texture that holds a model's measured data. */
export const DATA_WIDTH = 2048;

/** The exponent of pow(x, n) for whole n from 2 to 8, which products serve better: also where x < 0. */
export function wholeExponent(e: Extract<Expr, { kind: 'builtin' }>): number | null {
  if (e.name !== 'pow') return null;
  let exponent = e.args[1] as Expr;
  while (exponent.kind === 'construct' && exponent.args.length === 1) exponent = exponent.args[0] as Expr;
  if (exponent.kind !== 'literal') return null;
  const n = exponent.value as number;
  return Number.isInteger(n) && n >= 2 && n <= 8 ? n : null;
}

/** x^n by squaring, as an expression in x and its square `s`. */
export function powerProduct(n: number): string {
  const factors: string[] = [];
  for (let i = 0; i < Math.floor(n / 2); i++) factors.push('s');
  if (n % 2 === 1) factors.push('x');
  return factors.join(' * ');
}
