/** BRDF() with this body, and what stands before it; line 5 of the file is the first of `before`. */
export function model(body: string, before = '', parameters = ''): string {
  return `analytic\n::begin parameters\n${parameters}\n::end parameters\n::begin shader\n${before}\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n${body}\n}\n::end shader\n`;
}

/** What it tests, the body of BRDF(), what stands before it, and the value for L = (.6, 0, .8), V = N = z. */
export type FeatureCase = [string, string, string, readonly [number, number, number]];

/** GLSL's features, one by one, with what GLSL defines: for every back end. */
export const FEATURES: readonly FeatureCase[] = [
  ['integers divide as integers', 'return vec3(7 / 2, -7 / 2, 7 % 4);', '', [3, -3, 3]],
  [
    'integers become floats where one is needed',
    'return vec3(1 / 4.0, pow(3, 2), clamp(5, 0, 1));',
    '',
    [0.25, 9, 1],
  ],
  ['octal and hexadecimal', 'return vec3(017, 0x1F, 3u);', '', [15, 31, 3]],
  ['swizzles, read and written', 'vec3 v = vec3(1, 2, 3); v.zx = v.xy * 2.; return v.bgr;', '', [2, 2, 4]],
  ['subscripts', 'vec3 v = vec3(1, 2, 3); int i = 2; v[i] = v[0] + v[1]; return v;', '', [1, 2, 3]],
  [
    'subscripts out of range stay inside',
    'vec3 v = vec3(1, 2, 3); int i = 7; return vec3(v[i]);',
    '',
    [3, 3, 3],
  ],
  [
    'assignment has a value',
    'float a, b; a = b = 2.; a += (b *= 3.); return vec3(a, b, a++);',
    '',
    [8, 6, 8],
  ],
  ['prefix and postfix', 'int i = 1; int a = i++ + ++i; return vec3(a, i, i--);', '', [4, 3, 3]],
  ['ternaries, lazily', 'float x = true ? 1. : 1. / 0.; return vec3(x, L.x > .5 ? 2 : 3, 0);', '', [1, 2, 0]],
  ['the comma', 'float x = (1., 2.); return vec3(x);', '', [2, 2, 2]],
  [
    'loops with break and continue',
    'float s = 0.; for (int i = 0; i < 10; i++) { if (i == 2) continue; if (i > 4) break; s += i; } return vec3(s);',
    '',
    [8, 8, 8],
  ],
  [
    'loops that count down, by floats',
    'float s = 0.; for (float x = 1.; x > 0.; x -= .25) s += x; return vec3(s);',
    '',
    [2.5, 2.5, 2.5],
  ],
  [
    'out and inout arguments',
    'float a = 3., b; twice(a, b); return vec3(a, b, 0);',
    'void twice(inout float x, out float y) { y = x; x *= 2.; }',
    [6, 3, 0],
  ],
  [
    'out arguments that are parts',
    'vec3 v = vec3(1, 2, 3); twice(v.y); return v;',
    'void twice(inout float x) { x *= 2.; }',
    [1, 4, 3],
  ],
  [
    'overloads',
    'return vec3(f(1), f(1.), f(vec2(1)));',
    'float f(int x) { return 10.; } float f(float x) { return 20.; } float f(vec2 x) { return 30.; }',
    [10, 20, 30],
  ],
  [
    'functions that hide built-in ones',
    'return reflect(L, N);',
    'vec3 reflect(vec3 I, vec3 N) { return 2*dot(I,N)*N - I; }',
    [-0.6, 0, 0.8],
  ],
  [
    'locals that hide arguments and globals',
    'float x = x + 1.; { float x = 5.; } return vec3(x);',
    'const float x = 1.;',
    [2, 2, 2],
  ],
  [
    'structs',
    'S s = S(1., vec2(2, 3)); s.b.y = 7.; S t = s; t.a = 9.; return vec3(s.a, s.b.y, t.a);',
    'struct S { float a; vec2 b; };',
    [1, 7, 9],
  ],
  [
    'const arrays',
    'int i = 1; return vec3(w[0], w[2], w[i]);',
    'const float w[3] = float[3](1., 2., 3.);',
    [1, 3, 2],
  ],
  [
    'macros',
    'return vec3(SQ(3.), TWO_PI / PI, A);',
    '#define PI 3.14159265\n#define TWO_PI (2.0 * PI)\n#define SQ(x) ((x) * (x))\n#ifdef PI\n#define A 1\n#else\n#define A 2\n#endif',
    [9, 2, 1],
  ],
  [
    'matrices',
    'mat2 m = mat2(1, 2, 3, 4); vec2 v = m * vec2(1, 1); return vec3(v, determinant(m));',
    '',
    [4, 6, -2],
  ],
  [
    'row vectors and transposes',
    'mat2 m = mat2(1, 2, 3, 4); return vec3(vec2(1, 1) * m, (transpose(m) * vec2(1, 0)).y);',
    '',
    [3, 7, 3],
  ],
  ['diagonals', 'mat3 m = mat3(2); m[1] = vec3(1, 2, 3); return m * vec3(1, 1, 1);', '', [3, 2, 5]],
  [
    'comparisons of vectors',
    'return vec3(L == vec3(.6, 0, .8), all(lessThan(L, vec3(1))), any(equal(L, vec3(0))));',
    '',
    [1, 1, 1],
  ],
  [
    'mod, step and smoothstep',
    'return vec3(mod(-1., 3.), step(.5, .5), smoothstep(0., 2., 1.));',
    '',
    [2, 1, 0.5],
  ],
  [
    'atan of two arguments, mix by bool',
    'return vec3(atan(1., -1.) * 4. / 3.14159265358979, mix(vec2(1), vec2(2), bvec2(true, false)));',
    '',
    [3, 2, 1],
  ],
  ['globals computed from others', 'return vec3(b);', 'const float a = 2.; float b = a * 3.;', [6, 6, 6]],
  ['uninitialised variables are zero', 'vec3 v; v.x += 1.; return v;', '', [1, 0, 0]],
  [
    'a function that ends without return',
    'return vec3(f(1.), f(-1.), 0);',
    'float f(float x) { if (x > 0.) return 5.; }',
    [5, 0, 0],
  ],
];
