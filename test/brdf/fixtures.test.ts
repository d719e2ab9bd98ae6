import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { parseBrdf } from '../../src/brdf/parse.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { compileModel } from '../../src/glsl/model.ts';

/**
 * Files in the style of Disney's BRDF Explorer, each full of one kind of oddity of desktop GLSL, against
 * what the language says they mean, worked out by hand in TypeScript.
 */

function load(name: string) {
  const url = new URL(`./fixtures/${name}.brdf`, import.meta.url);
  return compileModel(parseBrdf(readFileSync(url, 'utf8'), `${name}.brdf`));
}

const L: Vec3 = [0.36, 0.48, 0.8];
const V: Vec3 = [-0.48, 0.64, 0.6];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function evaluate(name: string, values: ParameterValues = {}, l: Vec3 = L, v: Vec3 = V) {
  return createEvaluator(load(name), values).f(l, v);
}

function expectVector(actual: readonly number[], expected: readonly number[]) {
  for (const [i, value] of expected.entries()) expect(actual[i]).toBeCloseTo(value, 12);
}

describe('files in the style of BRDF Explorer', () => {
  it('convert ints to floats, but divide ints as ints', () => {
    const m = 0.2;
    const gain = 3 / Math.PI;
    expectVector(evaluate('implicit-int'), [gain * m ** 2 + 3, gain * 4 + 0.5, gain * 0.8]);
  });

  it('choose by nested conditional operators and bool parameters', () => {
    const [a, b] = [1 / 0.8, 1 / 0.4];
    expectVector(evaluate('nested-ternary'), [a * a, b, a * a]);
    expectVector(evaluate('nested-ternary', { squared: false }), [a, b, a]);
    expectVector(evaluate('nested-ternary', { inverted: true }), [b, b, b]);
    expectVector(evaluate('nested-ternary', { squared: false, inverted: true }), [1 / a, b, b]);
    expectVector(evaluate('nested-ternary', { useLowest: true }), [a * a, a * a, a * a]);
    const grazing = evaluate('nested-ternary', { squared: false }, [Math.sqrt(1 - 0.1 ** 2), 0, 0.1]);
    expectVector(grazing, [0.25, b, 0.25]);
  });

  it('hide builtins by functions of their own', () => {
    const r: Vec3 = [2 * 0.8 * 0 - L[0], -L[1], 2 * 0.8 - L[2]];
    const x = dot(r, V) * 0.5 + 0.5;
    const up = (x - 0.3) / 0.7;
    expectVector(evaluate('own-builtins'), [up, 1 - up, 1]);
  });

  it('hide parameters and functions by arguments and locals', () => {
    const fresnel = (f0: number, u: number) => f0 + (1 - f0) * (1 - u) ** 5;
    const factor = fresnel(0.2, 0.8) + fresnel(0.8, 0.6);
    const rest = 11 + (3 + 100 + 1.5) + 10;
    expectVector(evaluate('shadowing'), [1.8 * factor + rest, 1 * factor + rest, 0.2 * factor + rest]);
  });

  it('read and write components in every way', () => {
    const v = [(L[0] - V[0]) / 2 + 0.5, (L[1] - V[1]) / 2 + 0.5, (L[2] - V[2]) / 2 + 0.5] as const;
    const w = [v[1], v[0], v[0] * 2 + 1] as const;
    const q = [2, w[2], 1, w[0]] as const;
    const p = [q[0] * 2 - 1, q[1] * 3 - 1] as const;
    expectVector(evaluate('swizzles'), [w[2] + 2, w[1] * p[1] + 1, w[0] * p[0]]);
    expectVector(evaluate('swizzles', { rgb: false }), [q[3], p[0], p[1]]);
  });

  it('declare in every way', () => {
    const g = (c: number, a: number) => 1 / (c + Math.sqrt(a + c * c - a * c * c));
    const sum = (0.1 + 0.2 + 0.4) * 0.8;
    expectVector(evaluate('declarations'), [
      (g(0.8, 0.16) * g(0.6, 0.16)) / (2 * Math.PI),
      sum + 0.4 * 0.8,
      0.3 * 0.8 + 0.6 * 0.6 + 0.1 * 2,
    ]);
  });

  it('offer every function with the arguments of BRDF() as a term', () => {
    const model = load('terms');
    expect(model.file.title).toBe('A model with terms of its own');
    expect(model.parameters.map(({ name, description }) => [name, description])).toEqual([
      ['diffuse', 'the base'],
      ['exponent', 'of the lobe # with a second hash'],
    ]);
    expect([...model.terms].sort()).toEqual(['BRDF', 'base', 'lobe', 'tangents']);
    expect(model.terms[0]).toBe('BRDF');
    const evaluator = createEvaluator(model);
    expectVector(evaluator.f(L, V, undefined, 'base'), [0.2 / Math.PI, 0.3 / Math.PI, 0.4 / Math.PI]);
    expectVector(evaluator.f(L, V, undefined, 'tangents'), [0.36, 0.48, 0.64]);
    const frame = { N: [0, 1, 0], X: [0, 0, 1], Y: [1, 0, 0] } as const;
    expectVector(evaluator.f(L, V, frame, 'tangents'), [0.8, 0.36, 0.48 ** 2]);
  });
});
