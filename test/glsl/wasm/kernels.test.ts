import { describe, expect, test } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { Float64Program } from '../../../src/glsl/float64.ts';
import type { Value } from '../../../src/glsl/ir.ts';
import { compileKernel, kernelSource } from '../../../src/glsl/kernel.ts';
import { emitWasm } from '../../../src/glsl/wasm/emit.ts';
import { instantiate } from './calls.ts';

/** A kernel `f` as WebAssembly = as float64, for random arguments: all that a BRDF's three numbers do not show. */

const random = createRandom(11);

function both(text: string) {
  const kernel = compileKernel(kernelSource('test', text), []);
  const f = kernel.entry('f');
  const { exports } = instantiate([f]);
  return {
    types: f.arguments.map(({ variable }) => variable.type.name),
    wasm: (args: readonly number[]) => [exports.f!(...args)].flat().map(Number),
    float64: (args: readonly number[]) =>
      [new Float64Program(kernel.program).callable(f)(...(args as readonly Value[] as Value[]))]
        .flat()
        .map(Number),
    isUnsigned: f.result.name.startsWith('u'),
  };
}

const CASES: readonly (readonly [string, string])[] = [
  [
    'vectors of four: arithmetic, swizzles and components',
    'vec3 f(float a, float b) { vec4 v = vec4(a, b, a - b, 2.); v = v * 2. + vec4(1, 2, 3, 4) / v.wzyx; v.yz = v.xw; v.w *= 3.; v.zwxy += v; v[1]++; return v.xyz + v.w; }',
  ],
  [
    'vectors of four: made of parts',
    'vec3 f(float a, float b) { vec2 p = vec2(a, b); vec3 q = p.xyx; vec4 v = vec4(q, a), w = vec4(p, v.zw), x = vec4(v.x, w.yz, b), y = vec4(a), z = vec4(v.xyz, b); mat2 m = mat2(v); return vec3(dot(v, w), dot(x, y), dot(z, v)) + m[1].x + vec3(v) - w.yzw; }',
  ],
  [
    'four comparisons at once',
    'vec3 f(float a, float b) { vec4 v = vec4(a, b, -a, .5), w = v.yxwz; bvec4 less = lessThanEqual(v, w), more = greaterThan(v, vec4(0)); vec4 m = mix(v, w, less); float s = any(less) ? 1. : 0.; if (all(more)) s += 2.; bvec4 n = not(less); if (n.z) s += 4.; if (bvec2(more.yw) == bvec2(true)) s += 8.; n.x = more.y; n = equal(n, more); return m.xyz + m.w + s + vec3(vec4(n)) + float(n.w) + vec3(uvec4(less).xyz); }',
  ],
  [
    'four at once: functions',
    'vec3 f(float a, float b) { vec4 v = vec4(a, b, a * b, 3.); v = sqrt(abs(v)) + floor(v) - fract(v) + min(v, v.wzyx) * max(v, 1.) + clamp(v, -1., 1.) + mix(v, v.yxwz, .25) + step(v, vec4(.5)) + smoothstep(vec4(-1), vec4(2), v) + sign(v) + mod(v, 2.) + sin(v) + exp2(v) + inversesqrt(abs(v) + 1.) + radians(v); return v.xyz / v.w + length(v) + normalize(v).xyz + reflect(v, normalize(v.wxyz)).xyz + distance(v, v.yyxx) + pow(v, vec4(3)).x; }',
  ],
  [
    'integers, alone and four at once',
    'uvec3 f(int a, int b) { ivec4 v = ivec4(a, b, a - b, 7); uvec4 u = uvec4(v) * 747796405u + 2891336453u; u ^= u >> 16u; u = (u << uvec4(1, 2, 3, 4)) | (u & 0xffu); v = v / (v.yxwz) + v % ivec4(3, -5, 0, b) - abs(v) * sign(v) + min(v, 3) + max(v, v.w) + clamp(v, -2, 2) + ~v + (v >> 1); u += u / uvec4(a, 3, 0, 5) + u % uvec4(7, 0, b, 9); return u.xyz ^ uvec3(v.xyz) + uvec3(u.w) * uvec3(v.w); }',
  ],
  [
    'whole numbers that overflow, and division by 0 and -1',
    'ivec3 f(int a, int b) { int least = -2147483647 - 1; int z = a - a; return ivec3(least / (z - 1) + a / z, a % z + least % (z - 1), (a * 65539) * (b * 65537)) + ivec3(a / -1, a / 7, b % -3); }',
  ],
  [
    'conversions',
    'vec3 f(int a, float b) { uint u = uint(a) + 1u; bool t = bool(a), s = bool(b); ivec4 i = ivec4(vec4(b, b * 2., -b, 100.5)); vec4 v = vec4(i) + vec4(uvec4(abs(i))) + vec4(bvec4(i)) + vec4(bvec4(vec4(b))); return vec3(float(t) + float(s), int(b) + int(t), u) + v.xyz + v.w; }',
  ],
  [
    'arrays: whole, by number and by choice',
    'vec3 f(int a, float b) { float w[8]; for (int i = 0; i < 8; i++) w[i] = float(i * i) + b; vec4 q[3]; q[a & 1] = vec4(b); q[2].zx = vec2(1, 2); q[a & 1].y += 5.; float c[8] = w; c[a & 7] -= 100.; w[a] += 3.; return vec3(w[a & 7], c[(a >> 1) & 7], w[6]) + q[a & 1].xyz + q[2].xyz + q[1].w + vec2[6](vec2(b), vec2(1), vec2(2), vec2(3), vec2(4), vec2(5))[a & 3].x + float[2](b, 7.)[a & 1]; }',
  ],
  [
    'constant arrays by choice',
    'const vec4 table[5] = vec4[5](vec4(1), vec4(2, 3, 4, 5), vec4(3), vec4(4), vec4(5)); const int numbers[3] = int[3](-7, 8, 9); vec3 f(int a) { return table[a].xyz * float(numbers[a]) + table[1].yzw; }',
  ],
  [
    'structs and matrices',
    'struct Inner { vec4 v; float w[3]; mat3 m; }; struct S { bool on; Inner inner; ivec4 i; }; S make(float a) { S s; s.on = a > 0.; s.inner.v = vec4(a, 1, 2, 3); s.inner.w[1] = a; s.inner.m = mat3(a); s.inner.m[1] += vec3(1, 2, 3); s.i.zw = ivec2(4, 5); return s; } vec3 f(float a, float b, int k) { S s = make(a), t = make(b); t.inner.v.xw *= 2.; s.inner.m = s.inner.m * t.inner.m; mat4 m = mat4(2); m[2] = t.inner.v; m[k & 3].y += 1.; mat4x3 n = mat4x3(m); mat3x4 o = transpose(n); return s.inner.m * vec3(a, b, 1) + n * s.inner.v + (s.inner.v * m).xyz + (o * vec3(a)).wzy + determinant(m) + determinant(s.inner.m) + float(t.on) + s.inner.w[1] + t.inner.w[k & 1] + float(s.i.w) + (m / 2. - m * .25)[3].w + make(b).inner.v.y; }',
  ],
  [
    'out and inout arguments, early returns in branches and loops',
    'float g(inout vec4 v, out float o[2], float x) { o[0] = 0.; o[1] = 0.; if (x > 0.) { o[1] = x; return v.x; } v.y = x; for (int i = 0; i < 5; i++) { if (float(i) > -x) { v.z = float(i); return 2.; } o[0] += 1.; } } vec3 f(float a, float b) { vec4 v = vec4(a, b, 0, 0); float o[2]; float p[2] = float[2](9., 9.); float r = g(v, o, a) + g(v, p, b); g(v, o, -1.); return v.xyz + r + vec3(o[0], o[1], p[0]) * 7.; }',
  ],
  [
    'what is lazy runs only where it should',
    'int count; bool touch(bool x) { count++; return x; } vec3 f(float a, float b) { count = 0; bool p = a > 0. && touch(b > 0.), q = a > 0. || touch(b > 0.); float x = p ? (count++, a) : b; vec4 v = q ? vec4(a) : vec4(count++); int i = 1; int j = i++ * 10 + i * 100 + ++i; return vec3(count, x + v.w, float(j)) + float(p ^^ q); }',
  ],
  [
    'order: what an earlier operand reads stays what it was',
    'float g; float set(float x) { g = x; return x; } vec3 f(float a, float b) { g = 1.; float x = g + set(a) + g; vec3 v = vec3(g, set(b), g); float c = a; float y = c + (c = b) * c; v.xy = v.yx; return v + vec3(x, y, c); }',
  ],
  [
    'while, with break, continue and return',
    'int g(int n) { int steps = 0; while (true) { if (n <= 1) return steps; if (steps > 200) break; steps++; if ((n & 1) == 0) { n /= 2; continue; } n = 3 * n + 1; } return -1; } int f(int a) { int s = 0; int k = 0; while (k < 10 && s < 500) { s += g(abs(a) + k); k++; } return s; }',
  ],
  [
    'variables of the invocation: scalars, vectors, structs and arrays',
    'struct S { vec4 v; uint u; }; S s; vec3 p; mat2 m; int stack[16]; int top; void push(int x) { stack[top++] = x; } int pop() { return stack[--top]; } vec3 f(float a, int b) { top = 0; s.v = vec4(a); s.v.y += 1.; s.u = uint(b); p.zx = s.v.xy; m = mat2(a); m[1] = p.xz; push(b); push(b * 2); push(3); return p * m[1].y + float(pop() * pop() - pop()) + s.v.xyz + float(s.u >> 3) - p.y; }',
  ],
  [
    'bits',
    'uvec3 f(float a, int b) { uvec4 u = floatBitsToUint(vec4(a, -a, 1, 0)); vec4 v = uintBitsToFloat(u ^ 0x80000000u); uint r = bitfieldReverse(uint(b)); uvec4 q = bitfieldReverse(u); return uvec3(u.x, r, floatBitsToInt(v.y)) ^ q.xyz ^ floatBitsToUint(intBitsToFloat(b & 0x3fffffff)); }',
  ],
  [
    'functions of one number',
    'vec3 f(float a, float b) { float x = sin(a) + cos(a) + tan(a * .3) + asin(b * .2) + acos(b * .2) + atan(a) + atan(a, b) + sinh(b) + cosh(b) + tanh(a) + asinh(a) + acosh(abs(a) + 1.) + atanh(b * .2); float y = exp(b) + log(abs(a) + .1) + exp2(b) + log2(abs(b) + .1) + pow(abs(a), b) + pow(a, 5.) + degrees(a) + trunc(a) + ceil(b) + round(a) + abs(b) + sign(b); vec3 v = vec3(a, b, 1); return vec3(x, y, fma(a, b, a)) + cross(v, v.zxy) + refract(normalize(v), vec3(0, 0, 1), .7) + faceforward(v, v.yxz, v.zzx) + float(isnan(a / (b - b) - a / (b - b))) + float(isinf(1. / (b - b))); }',
  ],
];

describe('a kernel as WebAssembly gives what it gives in float64', () => {
  test.each(CASES)('%s', (_, text) => {
    const { types, wasm, float64, isUnsigned } = both(text);
    for (let i = 0; i < 60; i++) {
      const args = types.map((type) =>
        type === 'int' ? Math.floor(random() * 40) - 20 : Math.fround(random() * 8 - 4),
      );
      const got = wasm(args).map((x) => (isUnsigned ? x >>> 0 : x));
      for (const [c, expected] of float64(args).entries())
        expect(Math.abs(got[c]! - expected), `${args} gives ${got}`).toBeLessThanOrEqual(
          2e-5 * Math.max(1, Math.abs(expected)),
        );
    }
  });
});

describe('memory', () => {
  test('of the scene, in slots and words, and the film', () => {
    const text = `
      void f(int slot) {
        uvec4 u = loadUint4(slot);
        vec4 v = loadFloat4(slot + 1);
        vec4 film = filmLoad(slot);
        filmStore(slot, film + vec4(u) * v + vec4(loadUint(4 * slot + 2), loadFloat(4 * slot + 7), 0, 1));
      }`;
    const kernel = compileKernel(kernelSource('test', text), []);
    const words = new Uint32Array(12);
    words.set([1, 2, 3, 4], 4);
    new Float32Array(words.buffer).set([0.5, 1.5, 2.5, 3.5], 8);
    const { exports, film } = instantiate([kernel.entry('f')], words);
    exports.f!(1);
    exports.f!(1);
    expect([...film.subarray(0, 8)]).toEqual([0, 0, 0, 0, 7, 13, 15, 30]);
  });

  test('is shared where workers share it', () => {
    const kernel = compileKernel(kernelSource('test', 'float f(float x) { return x; }'), []);
    const bytes = emitWasm([kernel.entry('f')]);
    const memory = new WebAssembly.Memory({ initial: 1, maximum: 65536, shared: true });
    const env = { memory, scene: 0, film: 0, stack: 1024 };
    const { exports } = new WebAssembly.Instance(new WebAssembly.Module(bytes), { env });
    expect((exports.f as (x: number) => number)(2.5)).toBe(2.5);
  });
});

test('two entries of one name are refused', () => {
  const kernel = compileKernel(kernelSource('test', 'float f(float x) { return x; }'), []);
  expect(() => emitWasm([kernel.entry('f'), kernel.entry('f')])).toThrow(RangeError);
});
