import { expect, test } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { Float64Program } from '../../../src/glsl/float64.ts';
import type { Value } from '../../../src/glsl/ir.ts';
import { compileKernel, kernelSource } from '../../../src/glsl/kernel.ts';
import { instantiate } from './calls.ts';

/**
 * Random programs as WebAssembly = in float64. Floats are small multiples of 1/8 and are kept so, such that
 * float32 is exact; whole numbers wrap alike.
 */

const random = createRandom(77);
const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)] as T;
const whole = (n: number) => Math.floor(random() * n);

type Base = 'float' | 'int' | 'uint' | 'bool';
const PREFIX = { float: 'vec', int: 'ivec', uint: 'uvec', bool: 'bvec' };
const BASES: readonly Base[] = ['float', 'int', 'uint', 'bool'];
const typeName = (base: Base, size: number) => (size === 1 ? base : `${PREFIX[base]}${size}`);
const variables = BASES.flatMap((base) =>
  [1, 2, 3, 4].map((size) => ({ base, size, name: `${base[0]}${size}` })),
);

function literal(base: Base): string {
  if (base === 'float') return `${((whole(65) - 32) / 8).toFixed(3)}`.replace(/^(-.*)$/, '($1)');
  if (base === 'bool') return pick(['true', 'false']);
  const value = pick([0, 1, 2, 3, 7, 31, 255, 0x7fffffff]);
  return base === 'uint' ? `${value}u` : random() < 0.3 ? `(-${value})` : `${value}`;
}

const swizzle = (from: number, to: number) => Array.from({ length: to }, () => 'xyzw'[whole(from)]).join('');

/** An expression of this type; floats are brought back to -4..4, in eighths. */
function expression(base: Base, size: number, depth: number): string {
  const again = (b = base, s = size) => expression(b, s, depth - 1);
  const type = typeName(base, size);
  if (depth <= 0)
    return random() < 0.75 ? `${base[0]}${size}` : size === 1 ? literal(base) : `${type}(${literal(base)})`;
  const choices: (() => string)[] = [
    () => `(${again('bool', 1)} ? ${again()} : ${again()})`,
    () => (size === 1 ? again() : `${type}(${again(base, size - 1)}, ${again(base, 1)})`),
    () => (size === 4 ? `${type}(${again(base, 2)}, ${again(base, 2)})` : again()),
    () => {
      const from = 2 + whole(3);
      return `${again(base, from)}.${swizzle(from, size)}`;
    },
    () => {
      const from = 2 + whole(3);
      return size === 1 ? `${base[0]}${from}[i1 ^ ${again('int', 1)}]` : again();
    },
  ];
  if (base === 'bool') {
    const [b, s] = [pick(['float', 'int', 'uint'] as const), size];
    const relation = pick([
      'lessThan',
      'lessThanEqual',
      'greaterThan',
      'greaterThanEqual',
      'equal',
      'notEqual',
    ]);
    choices.push(
      size === 1
        ? () => `(${again(b, 1)} ${pick(['<', '<=', '>', '>=', '==', '!='])} ${again(b, 1)})`
        : () => `${relation}(${again(b, s)}, ${again(b, s)})`,
      size === 1 ? () => `(${again()} ${pick(['&&', '||', '^^'])} ${again()})` : () => `not(${again()})`,
      () => (size === 1 ? `${pick(['any', 'all'])}(${again('bool', 2 + whole(3))})` : again()),
      () => (size === 1 ? `(${again(b, 3)} == ${again(b, 3)})` : `equal(${again()}, ${again()})`),
    );
    return pick(choices)();
  }
  choices.push(
    () => `${pick(['min', 'max'])}(${again()}, ${again()})`,
    () => `clamp(${again()}, ${type}(${literal(base)}), ${type}(${literal(base)}))`,
    () => `mix(${again()}, ${again()}, ${again('bool', size)})`,
    () => (base === 'float' ? `${pick(['abs', 'sign', '-'])}(${again()})` : again()),
  );
  if (base === 'float') {
    choices.push(
      () => `clamp(${again()} ${pick(['+', '-'])} ${again()}, -4., 4.)`,
      () => `clamp(floor(${again()} * ${again()}) * .125, -4., 4.)`,
      () => `${pick(['floor', 'ceil', 'trunc', 'fract'])}(${again()})`,
      () => `${type}(${again('bool', size)})`,
      () => `clamp(${type}(${again('int', size)} & 15) * .25, -4., 4.)`,
    );
  } else {
    choices.push(
      () => `(${again()} ${pick(['+', '-', '*', '/', '%', '&', '|', '^'])} ${again()})`,
      () => `(${again()} ${pick(['<<', '>>'])} (${again()} & ${base === 'uint' ? '7u' : '7'}))`,
      () => `(${again()} ${pick(['+', '*', '%'])} ${again(base, 1)})`,
      () => (base === 'int' ? `${pick(['sign', '~'])}(${again()})` : again()),
      () => `${type}(${again(base === 'int' ? 'uint' : 'int', size)})`,
      () => `${type}(${again('bool', size)})`,
      () => (base === 'int' ? `${type}(${again('float', size)})` : again()),
    );
  }
  return pick(choices)();
}

function statement(): string {
  const { base, size, name } = pick(variables);
  switch (whole(5)) {
    case 0:
      return `if (${expression('bool', 1, 2)}) { ${name} = ${expression(base, size, 2)}; }`;
    case 1: {
      if (size === 1) return `${name} = ${expression(base, size, 3)};`;
      return `${name}.${pick('xyzw'.slice(0, size).split(''))} = ${expression(base, 1, 2)};`;
    }
    case 2: {
      if (size < 2) return `for (int k = 0; k < 3; k++) { ${name} = ${expression(base, size, 2)}; }`;
      const lanes = 'xyzw'
        .slice(0, size)
        .split('')
        .sort(() => random() - 0.5)
        .slice(0, 2)
        .join('');
      return `${name}.${lanes} = ${expression(base, 2, 2)};`;
    }
    case 3:
      return size === 1
        ? `${name} = g(${name}, ${expression(base, 1, 2)});`
        : `${name}[i1 ^ ${expression('int', 1, 1)}] = ${expression(base, 1, 2)};`;
    default:
      return `${name} = ${expression(base, size, 3)};`;
  }
}

function programText(): string {
  const helpers = BASES.map(
    (base) =>
      `${base} g(${base} ${base[0]}1, ${base} other) { if (${base[0]}1 == other) return ${literal(base)}; return other; }`,
  );
  const declared = variables
    .filter(({ size }) => size > 1)
    .map(({ base, size, name }) => {
      const from =
        base === 'bool'
          ? `${base[0]}1`
          : `${base[0]}1 * ${base === 'uint' ? '3u' : base === 'int' ? '-5' : '.5'}`;
      return `${typeName(base, size)} ${name} = ${typeName(base, size)}(${from}${`, ${literal(base)}`.repeat(size - 1)});`;
    });
  const body = Array.from({ length: 6 }, statement);
  return `${helpers.join('\n')}
ivec3 f(float f1, int i1, uint u1) {
  bool b1 = f1 > 0.;
  ${[...declared, ...body].join('\n  ')}
  ivec4 sum = i4 + ivec4(u4) + ivec4(floor(f4 * 8.)) + ivec4(b4);
  sum.xyz += i3 * 3 + ivec3(u3) * 5 + ivec3(floor(f3 * 8.)) * 7 + ivec3(b3) * 11;
  sum.xy ^= i2 + ivec2(u2) + ivec2(floor(f2 * 8.)) + ivec2(b2);
  return sum.xyz + sum.w + i1 + int(u1) + int(floor(f1 * 8.)) + int(b1);
}`;
}

test('random programs', () => {
  for (let i = 0; i < 250; i++) {
    const text = programText();
    const kernel = compileKernel(kernelSource('random', text), []);
    const f = kernel.entry('f');
    const { exports } = instantiate([f]);
    const float64 = new Float64Program(kernel.program).callable(f);
    for (let k = 0; k < 8; k++) {
      const args = [(whole(65) - 32) / 8, whole(1000) - 500, whole(2 ** 32)];
      expect(exports.f!(...args), `${args}\n${text}`).toEqual(float64(...(args as Value[])));
    }
  }
});
