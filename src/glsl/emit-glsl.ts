import { DATA_WIDTH, FunctionEmitter, powerProduct, swizzle, wholeExponent } from './emit.ts';
import type { Expr, Variable } from './ir.ts';
import type { StructType, Type } from './types.ts';

/** Writes functions in GLSL ES 3.00 (WebGL 2): the language of the source, with conversions explicit. */
export class GlslEmitter extends FunctionEmitter {
  protected typeName(type: Type): string {
    if (type.kind === 'struct') return this.useStruct(type);
    if (type.kind === 'table') return 'highp sampler2D';
    if (type.kind === 'array') return `${this.typeName(type.element)}[${type.length}]`;
    return type.name;
  }

  protected structCode(type: StructType): string {
    const fields = type.fields.map(
      (field) => `  ${this.typeName(field.type)} ${this.fieldName(field.name)};\n`,
    );
    return `struct ${this.structName(type)} {\n${fields.join('')}};\n`;
  }

  protected sharedDeclaration(name: string, type: Type): string {
    return `${this.typeName(type)} ${name};\n`;
  }

  protected declaration(name: string, type: Type, init: string): string {
    return `${this.typeName(type)} ${name} = ${init};`;
  }

  protected signature(): string {
    const own = this.f.arguments.map(
      ({ variable, qualifier }) =>
        `${qualifier === 'in' ? '' : `${qualifier} `}${this.typeName(variable.type)} ${this.variableName(variable)}`,
    );
    const uses = this.f.uses.map(
      (variable) => `${this.typeName(variable.type)} ${this.variableName(variable)}`,
    );
    return `${this.typeName(this.f.result)} ${this.functionName(this.f)}(${[...own, ...uses].join(', ')})`;
  }

  protected enter(): void {
    for (const { variable, qualifier } of this.f.arguments) {
      if (qualifier === 'out')
        this.lines.push(`${this.variableName(variable)} = ${this.zero(variable.type)};`);
    }
  }

  protected readVariable(variable: Variable): string {
    return this.variableName(variable);
  }

  protected hoists(): boolean {
    return false;
  }

  protected effect(e: Expr): void {
    this.lines.push(`${this.expression(e)};`);
  }

  protected call(e: Extract<Expr, { kind: 'call' }>): string {
    return `${this.functionName(e.callee)}(${[...this.expressions(e.args), ...this.parametersFor(e.callee)].join(', ')})`;
  }

  protected ternary(e: Extract<Expr, { kind: 'ternary' }>): string {
    return `(${this.expression(e.test)} ? ${this.expression(e.yes)} : ${this.expression(e.no)})`;
  }

  protected logical(e: Extract<Expr, { kind: 'binary' }>): string {
    return `(${this.expression(e.left)} ${e.operator} ${this.expression(e.right)})`;
  }

  protected assign(e: Extract<Expr, { kind: 'assign' }>): string {
    return `(${this.expression(e.target)} ${e.operator ?? ''}= ${this.expression(e.value)})`;
  }

  protected step(e: Extract<Expr, { kind: 'step' }>): string {
    const target = this.expression(e.target);
    return e.prefix ? `(${e.operator}${target})` : `(${target}${e.operator})`;
  }

  protected sequence(e: Extract<Expr, { kind: 'sequence' }>): string {
    return `(${e.items.map((item) => this.expression(item)).join(', ')})`;
  }

  protected operation(operator: string, left: string, right: string): string {
    return `(${left} ${operator} ${right})`;
  }

  protected construct(type: Type, args: readonly string[], types: readonly Type[]): string {
    const [first] = types as [Type, ...Type[]];
    // vec2(vec3) is legal; a swizzle says the same and is cheaper to compile.
    if (
      args.length === 1 &&
      type.kind === 'vector' &&
      first.kind === 'vector' &&
      first.scalar === type.scalar
    ) {
      return `${args[0]}.${swizzle(Array.from({ length: type.size }, (_, i) => i))}`;
    }
    return `${this.typeName(type)}(${args.join(', ')})`;
  }

  protected nonFinite(value: number): string {
    return `uintBitsToFloat(${Number.isNaN(value) ? '0x7fc00000u' : value > 0 ? '0x7f800000u' : '0xff800000u'})`;
  }

  protected builtin(e: Extract<Expr, { kind: 'builtin' }>, args: readonly string[]): string {
    const exponent = wholeExponent(e);
    if (exponent !== null) {
      const type = this.typeName(e.type);
      const name = `irradia_pow${exponent}_${type}`;
      this.needs.set(
        name,
        `${type} ${name}(${type} x) {\n  ${type} s = x * x;\n  return ${powerProduct(exponent)};\n}\n`,
      );
      return `${name}(${args[0]})`;
    }
    if (e.name === 'fetchData') {
      const code = `vec3 irradia_fetch(highp sampler2D data, int i) {
  ivec2 size = textureSize(data, 0);
  int k = clamp(i, 0, size.x * size.y - 1);
  return texelFetch(data, ivec2(k % ${DATA_WIDTH}, k / ${DATA_WIDTH}), 0).rgb;
}
`;
      this.needs.set('irradia_fetch', code);
      return `irradia_fetch(${args.join(', ')})`;
    }
    if (e.name === 'fma') return `(${args[0]} * ${args[1]} + ${args[2]})`;
    return `${e.name}(${args.join(', ')})`;
  }
}
