import { expect, test } from 'vitest';
import { loadModel, shippedModels } from '../../models/index.ts';
import type { Rgb } from '../../src/brdf/model.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { Float64Program } from '../../src/glsl/float64.ts';
import { compileKernel, kernelSource } from '../../src/glsl/kernel.ts';
import type { Model } from '../../src/glsl/model.ts';

/** Kernels are models' GLSL and more: `while`, variables of the invocation, bits, and models as functions. */

function run(text: string, entry: string, args: number[] = [], models: readonly Model[] = []) {
  const kernel = compileKernel(kernelSource('test', text), models);
  return new Float64Program(kernel.program).callable(kernel.entry(entry))(...args);
}

test('while runs until its test fails, with break and continue', () => {
  const text = `
    int collatz(int n) {
      int steps = 0;
      while (n != 1) {
        steps++;
        if (steps > 1000) break;
        if (n % 2 == 0) { n = n / 2; continue; }
        n = 3 * n + 1;
      }
      return steps;
    }`;
  expect(run(text, 'collatz', [27])).toBe(111);
});

test('a variable at file level belongs to the invocation and starts at 0', () => {
  const text = `
    int calls;
    vec3 sum;
    void add(float x) { calls++; sum += vec3(x); }
    float total() { add(1.0); add(2.5); return sum.y * float(calls); }`;
  expect(run(text, 'total')).toBe(7);
});

test('bits of numbers', () => {
  expect(run('uint f(float x) { return floatBitsToUint(x); }', 'f', [1])).toBe(0x3f800000);
  expect(run('float f(uint x) { return uintBitsToFloat(x); }', 'f', [0x40490fdb])).toBeCloseTo(Math.PI, 6);
  expect(run('uint f(uint x) { return bitfieldReverse(x); }', 'f', [1])).toBe(0x80000000);
});

test('models are functions, their parameters variables', () => {
  const models = ['cook-torrance', 'principled'].map((name) => shippedModels.get(name) as Model);
  const text = `
    vec3 both(float roughness) {
      model0_roughness = roughness; model0_albedo = vec3(.5); model0_kd = .4; model0_ior = 1.5; model0_metallic = 0.0;
      model1_roughness = roughness; model1_baseColor = vec3(.2, .4, .6); model1_specular = .5;
      vec3 N = vec3(0, 0, 1), X = vec3(1, 0, 0), Y = vec3(0, 1, 0), L = vec3(.6, 0, .8), V = vec3(0, .6, .8);
      return model0_BRDF(L, V, N, X, Y) + model1_BRDF(L, V, N, X, Y) * model1_pdf(L, V, N, X, Y);
    }`;
  const [L, V] = [[0.6, 0, 0.8] as const, [0, 0.6, 0.8] as const];
  const cookTorrance = createEvaluator(models[0] as Model, {
    roughness: 0.3,
    albedo: [0.5, 0.5, 0.5],
    kd: 0.4,
    ior: 1.5,
    metallic: 0,
  });
  // What the kernel does not set is 0.
  const zero = Object.fromEntries((models[1] as Model).parameters.map(({ name }) => [name, 0]));
  const principled = createEvaluator(models[1] as Model, {
    ...zero,
    roughness: 0.3,
    baseColor: [0.2, 0.4, 0.6],
    specular: 0.5,
  });
  const pdf = principled.pdf(L, V);
  const expected = cookTorrance.f(L, V).map((x, i) => x + (principled.f(L, V)[i] as number) * pdf);
  const got = run(text, 'both', [0.3], models) as unknown as Rgb;
  for (const [i, x] of expected.entries()) expect(got[i]).toBeCloseTo(x, 12);
});

test('what a kernel lacks is an error with a place', () => {
  expect(() => compileKernel(kernelSource('kernel', 'float f() { return missing(); }'), [])).toThrow(
    'kernel:1',
  );
});

test('models have none of it', () => {
  const model = (body: string) => () =>
    loadModel(
      `analytic
::begin parameters
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { ${body} }
::end shader`,
      'model.brdf',
    );
  expect(model('while (true) {} return L;')).toThrow('a loop without constant bounds');
  expect(model('return vec3(loadFloat(0));')).toThrow('there is no function loadFloat');
  expect(model('return vec3(floatBitsToUint(L.x));')).toThrow('there is no function floatBitsToUint');
});

test('whole numbers of 32 bits go round', () => {
  expect(run('uint f(uint x) { return ~x; }', 'f', [0])).toBe(0xffffffff);
  expect(run('uint f(uint x) { return -x; }', 'f', [1])).toBe(0xffffffff);
  expect(run('uint f(uint x) { return x--; }', 'f', [0])).toBe(0);
  expect(run('uint f(uint x) { return --x; }', 'f', [0])).toBe(0xffffffff);
  expect(run('int f(int x) { return ++x; }', 'f', [0x7fffffff])).toBe(-0x80000000);
  expect(run('uint f() { return ~0u; }', 'f')).toBe(0xffffffff);
});
