import { expect, test } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { compileKernel, kernelSource } from '../../../src/glsl/kernel.ts';
import { instantiate } from './calls.ts';

/** Functions of our own in float32 = JavaScript's Math, alone and four at once, and at the ends of their ranges. */

const EPSILON = 2 ** -23;
const random = createRandom(3);
const between = (low: number, high: number) => () => low + (high - low) * random();
/** Numbers of every order of magnitude. */
const positive = () => 2 ** between(-120, 120)();

type Case = readonly [
  name: string,
  f: (...args: number[]) => number,
  args: readonly (() => number)[],
  /** In units of 2^-23, of the value or of 1, whichever the function is known to. */
  bound: number,
  of: 'value' | 'one',
];
const CASES: readonly Case[] = [
  ['sin', Math.sin, [between(-100, 100)], 1, 'one'],
  ['cos', Math.cos, [between(-100, 100)], 1, 'one'],
  ['sin', Math.sin, [between(-1, 1)], 1.5, 'value'],
  ['tan', Math.tan, [between(-1.5, 1.5)], 3, 'value'],
  ['exp', Math.exp, [between(-85, 88)], 2, 'value'],
  ['exp2', (x) => 2 ** x, [between(-125, 127)], 2, 'value'],
  ['log', Math.log, [positive], 2, 'value'],
  ['log', Math.log, [between(0.9, 1.1)], 3, 'value'],
  ['log2', Math.log2, [positive], 2, 'value'],
  ['pow', Math.pow, [between(0, 4), between(-8, 8)], 20, 'value'],
  ['atan', Math.atan, [between(-8, 8)], 3, 'value'],
  ['atan', Math.atan2, [between(-2, 2), between(-2, 2)], 3, 'value'],
  ['asin', Math.asin, [between(-1, 1)], 3, 'value'],
  ['acos', Math.acos, [between(-1, 1)], 3, 'one'],
];

test.each(CASES)('%s', (name, f, sources, bound, of) => {
  const list = sources.map((_, i) => `x${i}`);
  const declared = list.map((x) => `float ${x}`).join(', ');
  const call = (wrap: (x: string) => string) => `${name}(${list.map(wrap).join(', ')})`;
  const text = `
    float one(${declared}) { return ${call((x) => x)}; }
    vec3 three(${declared}) { return ${call((x) => `vec3(.5, ${x}, ${x})`)}; }
    float four(${declared}) { vec4 y = ${call((x) => `vec4(.25, .5, .75, ${x})`)}; return y.w; }`;
  const kernel = compileKernel(kernelSource('test', text), []);
  const { exports } = instantiate(['one', 'three', 'four'].map((entry) => kernel.entry(entry)));
  let worst = 0;
  for (let i = 0; i < 20_000; i++) {
    const args = sources.map((source) => Math.fround(source()));
    const expected = f(...args);
    const got = exports.one!(...args) as number;
    worst = Math.max(worst, Math.abs(got - expected) / (of === 'one' ? 1 : Math.abs(expected)) / EPSILON);
    if (i > 1000) continue;
    expect(exports.four!(...args)).toBe(got);
    expect((exports.three!(...args) as readonly number[]).slice(1)).toEqual([got, got]);
  }
  expect(worst).toBeLessThan(bound);
});

test.each<readonly [string, readonly number[], number]>([
  ['exp', [1000], Number.POSITIVE_INFINITY],
  ['exp', [-1000], 0],
  ['exp2', [128], Number.POSITIVE_INFINITY],
  ['exp2', [-200], 0],
  ['exp2', [10], 1024],
  ['log', [0], Number.NEGATIVE_INFINITY],
  ['log', [-1], Number.NaN],
  ['log', [1], 0],
  ['log2', [Number.POSITIVE_INFINITY], Number.POSITIVE_INFINITY],
  ['log2', [2 ** 60], 60],
  ['pow', [0, 3.5], 0],
  ['pow', [0, 0], 1],
  ['pow', [2, 0.5], Math.fround(Math.SQRT2)],
  ['atan', [0, 0], 0],
  ['atan', [0, -1], Math.fround(Math.PI)],
  ['atan', [-1, 0], -Math.fround(Math.PI / 2)],
  ['atan', [Number.POSITIVE_INFINITY], Math.fround(Math.PI / 2)],
  ['asin', [1], Math.fround(Math.PI / 2)],
  ['acos', [1], 0],
  ['acos', [-1], Math.fround(Math.PI)],
  ['acos', [1.5], Number.NaN],
  ['sin', [Number.NaN], Number.NaN],
  ['exp', [Number.NaN], Number.NaN],
  ['log', [Number.NaN], Number.NaN],
])('%s(%j) is %d', (name, args, expected) => {
  const list = args.map((_, i) => `x${i}`);
  const text = `float f(${list.map((x) => `float ${x}`).join(', ')}) { return ${name}(${list.join(', ')}); }`;
  const kernel = compileKernel(kernelSource('test', text), []);
  const { exports } = instantiate([kernel.entry('f')]);
  expect((exports.f!(...args) as number) + 0).toBe(expected);
});
