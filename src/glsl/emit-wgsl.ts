import { DATA_WIDTH, FunctionEmitter, hasEffects, powerProduct, swizzle, wholeExponent } from './emit.ts';
import type { Expr, Variable } from './ir.ts';
import { children } from './order.ts';
import { componentCount, type StructType, scalarOf, type Type } from './types.ts';

const SCALARS = { float: 'f32', int: 'i32', uint: 'u32', bool: 'bool' } as const;
const RENAMED: Record<string, string> = {
  inversesqrt: 'inverseSqrt',
  faceforward: 'faceForward',
  roundEven: 'round',
  bitfieldReverse: 'reverseBits',
};
const RELATIONAL: Record<string, string> = {
  lessThan: '<',
  lessThanEqual: '<=',
  greaterThan: '>',
  greaterThanEqual: '>=',
  equal: '==',
  notEqual: '!=',
};

/**
 * Writes functions in WGSL, which lacks the ternary, assignments inside expressions, assignable swizzles
 * and out parameters: such expressions become statements before the one that holds them.
 */
export class WgslEmitter extends FunctionEmitter {
  protected typeName(type: Type): string {
    switch (type.kind) {
      case 'void':
        return '';
      case 'table':
        return 'texture_2d<f32>';
      case 'scalar':
        return SCALARS[type.scalar];
      case 'vector':
        return `vec${type.size}<${SCALARS[type.scalar]}>`;
      case 'matrix':
        return `mat${type.columns}x${type.rows}<f32>`;
      case 'array':
        return `array<${this.typeName(type.element)}, ${type.length}>`;
      case 'struct':
        return this.useStruct(type);
    }
  }

  protected structCode(type: StructType): string {
    const fields = type.fields.map(
      (field) => `  ${this.fieldName(field.name)}: ${this.typeName(field.type)},\n`,
    );
    return `struct ${this.structName(type)} {\n${fields.join('')}}\n`;
  }

  protected sharedDeclaration(name: string, type: Type): string {
    return `var<private> ${name}: ${this.typeName(type)};\n`;
  }

  protected declaration(name: string, type: Type, init: string): string {
    return `var ${name}: ${this.typeName(type)} = ${init};`;
  }

  protected signature(): string {
    const own = this.f.arguments.map(({ variable, qualifier }) => {
      const type = this.typeName(variable.type);
      const name = this.variableName(variable);
      return qualifier === 'in'
        ? `${this.isCopied(variable) ? `${name}_in` : name}: ${type}`
        : `${name}: ptr<function, ${type}>`;
    });
    const uses = this.f.uses.map(
      (variable) => `${this.variableName(variable)}: ${this.typeName(variable.type)}`,
    );
    const result = this.f.result.kind === 'void' ? '' : ` -> ${this.typeName(this.f.result)}`;
    return `fn ${this.functionName(this.f)}(${[...own, ...uses].join(', ')})${result}`;
  }

  protected enter(): void {
    for (const { variable, qualifier } of this.f.arguments) {
      const name = this.variableName(variable);
      if (qualifier === 'out')
        this.lines.push(`${this.readVariable(variable)} = ${this.zero(variable.type)};`);
      // Arguments are constants in WGSL.
      if (qualifier === 'in' && this.isCopied(variable))
        this.lines.push(this.declaration(name, variable.type, `${name}_in`));
    }
  }

  private isCopied(variable: Variable): boolean {
    // A dynamic index needs a place in memory, too.
    return variable.assigned || variable.type.kind === 'array' || variable.type.kind === 'matrix';
  }

  protected readVariable(variable: Variable): string {
    const pointer = this.f.arguments.some((arg) => arg.variable === variable && arg.qualifier !== 'in');
    return pointer ? `(*${this.variableName(variable)})` : this.variableName(variable);
  }

  protected hoists(e: Expr): boolean {
    return hasEffects(e);
  }

  protected effect(e: Expr): void {
    switch (e.kind) {
      case 'assign':
        this.writeAssign(e);
        return;
      case 'step':
        this.writeStep(e);
        return;
      case 'sequence':
        for (const item of e.items) this.effect(item);
        return;
      case 'call': {
        const text = this.callText(e, (lines) => this.lines.push(...lines));
        if (text !== '') this.lines.push(e.type.kind === 'void' ? `${text};` : `_ = ${text};`);
        return;
      }
      default: {
        const text = this.expression(e);
        if (e.type.kind === 'void') this.lines.push(`${text};`);
        else if (!e.constant) this.lines.push(`_ = ${text};`);
      }
    }
  }

  protected call(e: Extract<Expr, { kind: 'call' }>): string {
    return this.callText(e, null);
  }

  /**
   * A call; where it has out arguments, it runs in a statement of its own and its value in a temporary
   * (or, if only its effect is wanted, `write` takes the statements and the text is empty).
   */
  private callText(e: Extract<Expr, { kind: 'call' }>, write: ((lines: string[]) => void) | null): string {
    const out = e.callee.arguments.map(({ qualifier }) => qualifier !== 'in');
    const after: string[] = [];
    const inputs = this.expressions(e.args.filter((_, i) => !out[i]));
    const args = e.args.map((arg, i) => {
      if (!out[i]) return inputs.shift() as string;
      const copy = this.temporary(arg.type, this.expression(arg));
      after.push(...this.block(() => this.store(arg, copy)));
      return `&${copy}`;
    });
    const text = `${this.functionName(e.callee)}(${[...args, ...this.parametersFor(e.callee)].join(', ')})`;
    if (after.length === 0) return text;
    if (write && e.type.kind === 'void') {
      write([`${text};`, ...after]);
      return '';
    }
    const value = this.temporary(e.type, text);
    this.lines.push(...after);
    return value;
  }

  protected ternary(e: Extract<Expr, { kind: 'ternary' }>): string {
    const test = this.expression(e.test);
    let yes = '';
    let no = '';
    const yesLines = this.block(() => (yes = this.expression(e.yes)));
    const noLines = this.block(() => (no = this.expression(e.no)));
    // select() evaluates both sides: right for arithmetic, wasteful for calls.
    const simple =
      yesLines.length + noLines.length === 0 &&
      componentCount(e.type) > 0 &&
      !callsFunctions(e.yes) &&
      !callsFunctions(e.no);
    if (simple) return `select(${no}, ${yes}, ${test})`;
    const result = this.temporary(e.type, this.zero(e.type));
    const branch = (lines: string[], value: string) =>
      [...lines, `${result} = ${value};`].map((line) => `  ${line}`);
    this.lines.push(`if (${test}) {`, ...branch(yesLines, yes), '} else {', ...branch(noLines, no), '}');
    return result;
  }

  protected logical(e: Extract<Expr, { kind: 'binary' }>): string {
    const left = this.expression(e.left);
    let right = '';
    const lines = this.block(() => (right = this.expression(e.right)));
    if (lines.length === 0) return `(${left} ${e.operator} ${right})`;
    const result = this.temporary(e.type, left);
    this.lines.push(
      `if (${e.operator === '&&' ? result : `!${result}`}) {`,
      ...lines.map((line) => `  ${line}`),
      `  ${result} = ${right};`,
      '}',
    );
    return result;
  }

  protected assign(e: Extract<Expr, { kind: 'assign' }>): string {
    this.writeAssign(e);
    return this.temporary(e.type, this.expression(e.target));
  }

  private writeAssign(e: Extract<Expr, { kind: 'assign' }>): void {
    const value = this.expression(e.value);
    this.store(
      e.target,
      e.operator === null
        ? value
        : this.operation(e.operator, this.expression(e.target), value, e.target.type, e.value.type),
    );
  }

  protected step(e: Extract<Expr, { kind: 'step' }>): string {
    if (e.prefix) {
      this.writeStep(e);
      return this.temporary(e.type, this.expression(e.target));
    }
    const before = this.temporary(e.type, this.expression(e.target));
    this.writeStep(e);
    return before;
  }

  private writeStep(e: Extract<Expr, { kind: 'step' }>): void {
    const target = this.expression(e.target);
    const one = e.type.kind === 'scalar' || e.type.kind === 'vector' ? this.literal(1, e.type) : '1.0';
    this.store(e.target, `(${target} ${e.operator === '++' ? '+' : '-'} ${one})`);
  }

  protected sequence(e: Extract<Expr, { kind: 'sequence' }>): string {
    for (const item of e.items.slice(0, -1)) this.effect(item);
    return this.expression(e.items.at(-1) as Expr);
  }

  /** target = value, for a swizzle component by component. */
  private store(target: Expr, value: string): void {
    if (target.kind !== 'swizzle' || target.components.length === 1) {
      this.lines.push(`${this.expression(target)} = ${value};`);
      return;
    }
    const copy = this.temporary(target.type, value);
    const object = this.expression(target.object);
    for (const [i, c] of target.components.entries())
      this.lines.push(`${object}.${swizzle([c])} = ${copy}.${swizzle([i])};`);
  }

  protected operation(
    operator: string,
    left: string,
    right: string,
    leftType: Type,
    rightType: Type,
  ): string {
    if (operator === '^^') return `(${left} != ${right})`;
    if (operator === '<<' || operator === '>>') {
      const shift = rightType.kind === 'vector' ? `vec${rightType.size}<u32>` : 'u32';
      return `(${left} ${operator} ${shift}(${right}))`;
    }
    if (operator === '/' && leftType.kind === 'matrix') return `(${left} * (1.0 / ${right}))`;
    if (leftType.kind === 'vector' && (operator === '==' || operator === '!=')) {
      return `${operator === '==' ? 'all' : 'any'}(${left} ${operator} ${right})`;
    }
    return `(${left} ${operator} ${right})`;
  }

  protected construct(type: Type, args: readonly string[], types: readonly Type[]): string {
    const [first] = types as [Type, ...Type[]];
    const name = this.typeName(type);
    if (type.kind === 'vector') {
      if (args.length === 1) {
        const size = componentCount(first);
        const text =
          size > type.size
            ? `${args[0]}.${swizzle(Array.from({ length: type.size }, (_, i) => i))}`
            : args[0];
        return `${name}(${text})`;
      }
      // GLSL may cut the last argument short.
      const counts = types.map(componentCount);
      const extra = counts.reduce((sum, count) => sum + count, 0) - type.size;
      const last = (counts.at(-1) as number) - extra;
      return `${name}(${args.map((arg, i) => (extra > 0 && i === args.length - 1 ? `${arg}.${swizzle(Array.from({ length: last }, (_, c) => c))}` : arg)).join(', ')})`;
    }
    if (type.kind !== 'matrix')
      return `${name}(${type.kind === 'scalar' && first.kind === 'vector' ? `${args[0]}.x` : args.join(', ')})`;
    return `${name}(${this.matrixComponents(type, args, types).join(', ')})`;
  }

  private matrixComponents(
    type: Extract<Type, { kind: 'matrix' }>,
    args: readonly string[],
    types: readonly Type[],
  ): string[] {
    const [first] = types as [Type, ...Type[]];
    const needed = type.columns * type.rows;
    if (args.length === 1 && (first.kind === 'scalar' || first.kind === 'matrix')) {
      const source = this.temporary(first, args[0] as string);
      return Array.from({ length: needed }, (_, i) => {
        const [c, r] = [Math.floor(i / type.rows), i % type.rows];
        if (first.kind === 'scalar') return c === r ? source : '0.0';
        return c < first.columns && r < first.rows ? `${source}[${c}][${r}]` : c === r ? '1.0' : '0.0';
      });
    }
    return args
      .flatMap((arg, i) => {
        const count = componentCount(types[i] as Type);
        if (count === 1) return [arg];
        const source = this.temporary(types[i] as Type, arg);
        return Array.from({ length: count }, (_, c) => `${source}.${swizzle([c])}`);
      })
      .slice(0, needed);
  }

  protected nonFinite(value: number): string {
    // Through a variable: a constant expression that is not finite is an error in WGSL.
    this.needs.set(
      'irradia_bits',
      'fn irradia_bits(bits: u32) -> f32 {\n  var b = bits;\n  return bitcast<f32>(b);\n}\n',
    );
    return `irradia_bits(${Number.isNaN(value) ? '0x7fc00000u' : value > 0 ? '0x7f800000u' : '0xff800000u'})`;
  }

  protected builtin(e: Extract<Expr, { kind: 'builtin' }>, args: readonly string[]): string {
    const [a = '', b = '', c = ''] = args;
    const argType = (e.args[0] as Expr).type;
    const type = this.typeName(argType);
    const size = componentCount(argType);
    const exponent = wholeExponent(e);
    if (exponent !== null)
      return `${this.helper(`pow${exponent}`, type, 'x', `let s = x * x;\n  return ${powerProduct(exponent)};`)}(${a})`;
    const relation = RELATIONAL[e.name];
    if (relation) return `(${a} ${relation} ${b})`;
    switch (e.name) {
      case 'fetchData': {
        const code = `fn irradia_fetch(data: texture_2d<f32>, i: i32) -> vec3<f32> {
  let size = textureDimensions(data);
  let k = min(u32(max(i, 0)), size.x * size.y - 1u);
  return textureLoad(data, vec2<u32>(k % ${DATA_WIDTH}u, k / ${DATA_WIDTH}u), 0).xyz;
}
`;
        this.needs.set('irradia_fetch', code);
        return `irradia_fetch(${args.join(', ')})`;
      }
      // A kernel's shader declares `scene`, array<vec4<u32>>, and `film`, array<vec4<f32>>.
      case 'loadUint4':
        return `scene[${a}]`;
      case 'loadFloat4':
        return `bitcast<vec4<f32>>(scene[${a}])`;
      case 'loadUint':
        return `scene[${a} >> 2u][${a} & 3]`;
      case 'loadFloat':
        return `bitcast<f32>(scene[${a} >> 2u][${a} & 3])`;
      case 'filmLoad':
        return `film[${a}]`;
      case 'filmStore':
        return `film[${a}] = ${b}`;
      case 'floatBitsToUint':
      case 'floatBitsToInt':
      case 'uintBitsToFloat':
      case 'intBitsToFloat':
        return `bitcast<${this.typeName(e.type)}>(${a})`;
      // A comparison instead of WGSL's own, which says what becomes of NaN: on a software GPU that takes three times as long.
      case 'max':
      case 'min':
        if (scalarOf(argType) !== 'float') break;
        return this.extreme(e.name, type, a, b);
      case 'clamp':
        if (scalarOf(argType) !== 'float') break;
        return this.extreme('min', type, this.extreme('max', type, a, b), c);
      case 'not':
        return `(!${a})`;
      case 'mod':
        return `${this.helper('mod', type, 'x, y', 'return x - y * floor(x / y);')}(${a}, ${b})`;
      case 'atan':
        return args.length === 2 ? `atan2(${a}, ${b})` : `atan(${a})`;
      case 'mix':
        return (e.args[2] as Expr).type.name.startsWith('b')
          ? `select(${a}, ${b}, ${c})`
          : `mix(${a}, ${b}, ${c})`;
      case 'isnan':
      case 'isinf': {
        const bits = size === 1 ? 'u32' : `vec${size}<u32>`;
        const compare = e.name === 'isnan' ? '>' : '==';
        return `((bitcast<${bits}>(${a}) & ${bits}(0x7fffffffu)) ${compare} ${bits}(0x7f800000u))`;
      }
      case 'dot':
        return size === 1 ? `(${a} * ${b})` : `dot(${a}, ${b})`;
      case 'normalize':
        return size === 1 ? `sign(${a})` : `normalize(${a})`;
    }
    return `${RENAMED[e.name] ?? e.name}(${args.join(', ')})`;
  }

  /** The larger or the smaller; y where x is not a number. */
  private extreme(which: 'max' | 'min', type: string, x: string, y: string): string {
    const body = `return select(y, x, x ${which === 'max' ? '>' : '<'} y);`;
    return `${this.helper(which, type, 'x, y', body)}(${x}, ${y})`;
  }

  /** A function of ours for one type; its arguments all have that type, and so has its result. */
  private helper(name: string, type: string, parameters: string, body: string): string {
    const full = `irradia_${name}_${type.replace(/\W/g, '')}`;
    const list = parameters.split(', ').map((parameter) => `${parameter}: ${type}`);
    this.needs.set(full, `fn ${full}(${list.join(', ')}) -> ${type} {\n  ${body}\n}\n`);
    return full;
  }
}

function callsFunctions(e: Expr): boolean {
  return e.kind === 'call' || children(e).some(callsFunctions);
}
