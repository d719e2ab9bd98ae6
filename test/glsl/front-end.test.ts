import { describe, expect, test } from 'vitest';
import { loadModel } from '../../models/index.ts';
import { BrdfError } from '../../src/brdf/error.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { FEATURES, type FeatureCase, model } from './features.ts';

const L = [0.6, 0, 0.8] as const;
const V = [0, 0, 1] as const;
const run = (body: string, before = '') =>
  createEvaluator(loadModel(model(body, before), 'test.brdf')).f(L, V);

describe('GLSL in float64 gives what GLSL defines', () => {
  test.each<FeatureCase>(FEATURES)('%s', (_, body, before, expected) => {
    const got = run(body, before);
    for (let c = 0; c < 3; c++) expect(got[c]).toBeCloseTo(expected[c] as number, 7);
  });
});

describe('what is wrong is named with its place', () => {
  test.each<[string, string, RegExp]>([
    ['vec3 v = L +;\nreturn v;', '', /^test\.brdf:8:13: unexpected ';'; expected an expression/],
    ['return vec3(lumen);', '', /^test\.brdf:8:13: 'lumen' is not declared/],
    ['return 1.0;', '', /^test\.brdf:8:8: a float here; expected a vec3/],
    ['return L + vec2(1);', '', /^test\.brdf:8:10: vec3 \+ vec2; expected operands of one size/],
    ['if (1) return L; return V;', '', /^test\.brdf:8:5: a int as a condition; expected a bool/],
    [
      'L = V; N = X; PI = 3.; return L;',
      'const float PI = 3.14;',
      /^test\.brdf:8:15: a constant cannot be assigned; expected a local variable/,
    ],
    ['return L.xyw;', '', /^test\.brdf:8:9: a vec3 has no '\.xyw'; expected components of xyz/],
    ['return vec3(L[3]);', '', /^test\.brdf:8:15: index 3 of a vec3; expected 0 to 2/],
    [
      'while (true) {} return L;',
      '',
      /^test\.brdf:8:1: a loop without constant bounds is not supported; expected for/,
    ],
    ['for (int i = 0; i < 5; ) {} return L;', '', /a loop without constant bounds; expected for/],
    ['for (int i = 0; i < 5; i++) i = 0; return L;', '', /the loop assigns its own variable 'i'/],
    ['for (int i = 0; i >= 0; i++) {} return L;', '', /at most 4096 turns/],
    [
      'return f(L);',
      'vec3 f(vec3 v) { return f(v); }',
      /^test\.brdf:6:1: f calls itself; expected no recursion/,
    ],
    ['return f(L);', 'vec3 f(vec3 v);', /f is declared but has no body/],
    [
      'return f(L);',
      'vec3 f(vec2 v) { return v.xyx; }',
      /there is no function f\(vec3\); expected f\(vec2\)/,
    ],
    ['return texture(s, L.xy);', '', /there is no function texture|'s' is not declared/],
    ['return L;', '#if X > 1\n#endif', /^test\.brdf:6: '#if' is not supported; expected #define/],
    ['return L; /* open', '', /a comment that does not end/],
    ['return L', '', /^test\.brdf:9:1: unexpected '}'; expected ';'/],
    ['return vec3(1, 2);', '', /vec3\(int, int\); expected 3 components/],
    ['vec3 v; vec3 v; return v;', '', /a second 'v' in one block/],
    ['return L §;', '', /'§' has no meaning in GLSL/],
  ])('%s %s', (body, before, message) => {
    expect(() => loadModel(model(body, before), 'test.brdf')).toThrow(message);
  });

  test.each<[string, RegExp]>([
    ['', /^x\.brdf:1: not a BRDF file; expected 'analytic'/],
    ['measured\n', /'measured' is no kind of BRDF file/],
    ['analytic\n', /the file has no shader/],
    ['analytic\n::begin shader\n', /section 'shader' of line 2 does not end; expected '::end shader'/],
    [
      'analytic\n::begin lights\n',
      /^x\.brdf:2: no section is named 'lights'; expected parameters, shader, sampling/,
    ],
    ['analytic\n::begin shader\n::end shader', /there is no function BRDF\(\); expected vec3 BRDF\(vec3 L/],
    [
      'analytic\n::begin shader\nfloat BRDF() { return 1.; }\n::end shader',
      /^x\.brdf:3:1: BRDF\(\) has another signature/,
    ],
    [
      'analytic\n::begin shader\n::include lib/none.glsl\n::end shader',
      /^x\.brdf:3: there is no file 'lib\/none\.glsl'/,
    ],
    [
      'analytic\n::begin parameters\nfloat r 0 1\n::end parameters\n',
      /^x\.brdf:3: parameter r has 2 numbers; expected float r MIN MAX DEFAULT/,
    ],
    ['analytic\n::begin parameters\nfloat r 1 0 0\n::end parameters\n', /its range 1 to 0 is empty/],
    ['analytic\n::begin parameters\nfloat r 0 1 2\n::end parameters\n', /its default 2 is outside its range/],
    ['analytic\n::begin parameters\nfloat r 0 1 x\n::end parameters\n', /'x' is no number/],
    [
      'analytic\n::begin parameters\nvec3 r 0 1 0\n::end parameters\n',
      /'vec3' is no type of parameter; expected float, color or bool/,
    ],
    [
      'analytic\n::begin parameters\nfloat float 0 1 0\n::end parameters\n',
      /'float' cannot name a parameter/,
    ],
    ['analytic\n::begin parameters\nbool b 2\n::end parameters\n', /its default is 2; expected 0 or 1/],
    [
      'analytic\n::begin parameters\nbool b 1\nbool b 0\n::end parameters\n',
      /^x\.brdf:4: a second parameter 'b'/,
    ],
  ])('%j', (text, message) => {
    expect(() => loadModel(text, 'x.brdf')).toThrow(message);
  });
});

describe('hostile files', () => {
  const hostile: Record<string, string> = {
    'deep parentheses': model(`return L * ${'('.repeat(1e5)}1.${')'.repeat(1e5)};`),
    'a long sum': model(`return vec3(${'1.+'.repeat(1e5)}1.);`),
    'deep blocks': model(`${'{'.repeat(1e5)}${'}'.repeat(1e5)} return L;`),
    'a billion turns': model(
      'float s; for (int a=0;a<4000;a++) for (int b=0;b<4000;b++) for (int c=0;c<4000;c++) s += 1.; return vec3(s);',
    ),
    'calls that double': model(
      'return vec3(f30(1.));',
      `float f0(float x) { return x; }\n${Array.from({ length: 30 }, (_, i) => `float f${i + 1}(float x) { return f${i}(x) + f${i}(x); }`).join('\n')}`,
    ),
    'macros that double': model(
      'return vec3(A30);',
      `#define A0 1.\n${Array.from({ length: 30 }, (_, i) => `#define A${i + 1} A${i} + A${i}`).join('\n')}`,
    ),
    'an include of itself': 'analytic\n::begin shader\n::include lib/\n::end shader\n',
    'a huge array': model('float a[1000000000]; return L;'),
    'two megabytes': `analytic\n${'#'.repeat(2 << 20)}`,
    'many unary signs': model(`return L * ${'-'.repeat(1)}${' -'.repeat(1e5)}1.;`),
    'a chain of ternaries': model(`return vec3(${'true ? 1. : '.repeat(1e5)}0.);`),
    'a chain of else': model(`${'if (L.x > 1.) {} else '.repeat(1e5)}{} return L;`),
    'names of Object': model(
      'return vec3(constructor + __proto__);',
      '',
      'float constructor 0 1 0\nfloat __proto__ 0 1 0',
    ),
  };
  test.each(Object.keys(hostile))('%s is refused with a place', (name) => {
    let model: unknown;
    try {
      model = loadModel(hostile[name] as string, 'hostile.brdf');
    } catch (error) {
      expect(error).toBeInstanceOf(BrdfError);
      expect((error as BrdfError).message).toMatch(/^[\w./-]+:\d+/);
      expect((error as BrdfError).message.length).toBeLessThan(300);
    }
    expect(model).toBeUndefined();
  });

  test('parameters may bear the names of what every object has', () => {
    const text = model(
      'return vec3(constructor, toString, valueOf);',
      '',
      'float constructor 0 1 .5\nfloat toString 0 1 .25\nfloat valueOf 0 1 0',
    );
    const evaluator = createEvaluator(loadModel(text, 'names.brdf'), { valueOf: 1 });
    expect(evaluator.f(L, V)).toEqual([0.5, 0.25, 1]);
  });

  test('truncated and mutated files give a place or a model, and nothing else', () => {
    let seed = 7;
    const random = (n: number) => {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return Math.floor((seed / 2 ** 32) * n);
    };
    const text = model(
      'vec3 H = normalize(L + V); float d = pow(max(dot(N, H), 0.), n); return s(d) * tint;',
      '// shared\nfloat s(float x) { return x > .5 ? x*x : x; }\nstruct P { vec2 a; float b[2]; };',
      'float n 1 100 10 # exponent\ncolor tint .5 .5 .5\nbool b 1',
    );
    const pieces = [
      '(',
      ')',
      '{',
      '}',
      ';',
      '::end shader',
      '/*',
      '#define n n',
      '1e99',
      '0x',
      'vec3',
      'for(',
      '[',
      '?',
      '\u0000',
      'P',
      '.',
      '-',
      'inout ',
    ];
    for (let i = 0; i < 3000; i++) {
      let mutant = random(4) === 0 ? text.slice(0, random(text.length)) : text;
      for (let k = random(4); k >= 0; k--) {
        const at = random(mutant.length);
        mutant = mutant.slice(0, at) + pieces[random(pieces.length)] + mutant.slice(at + random(6));
      }
      try {
        createEvaluator(loadModel(mutant, 'mutant.brdf')).f(L, V);
      } catch (error) {
        expect(error, mutant).toBeInstanceOf(BrdfError);
      }
    }
  });
});
