import { describe, expect, test } from 'vitest';
import { loadModel, shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { derivedQuantities } from '../../src/glsl/derived.ts';
import { createEvaluator, LOCAL_FRAME, type Vector3 } from '../../src/glsl/evaluator.ts';
import { Float64Program } from '../../src/glsl/float64.ts';
import { splitByLight } from '../../src/glsl/hoist.ts';
import type { Value } from '../../src/glsl/ir.ts';
import { findFunction, type Model } from '../../src/glsl/model.ts';

/** What hoisting must not get wrong: guards, early returns, shadowed names, calls in branches, loops. */
const tricky = loadModel(
  `analytic
::begin parameters
float a 0 1 .5
float b 0 1 .5
color c .2 .4 .6
bool on 1
::end parameters
::begin shader
float twice(float x) { x *= 2.; return x; }
float branchy(float x) { if (x > .5) return x; return -x; }
float loop(float x) { float s = 0.; for (int i = 0; i < 3; i++) { if (i == 1) continue; s += x * float(i + 1); } return s; }
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  if (dot(N, L) < .1) return vec3(0.);
  float a = a * 2.;
  float v = twice(dot(N, V)) + loop(b);
  vec3 sum = c * (1. - a * .25);
  if (on) { float w = sqrt(b) + v; sum += w * dot(L, V); }
  if (b > .5) sum *= branchy(b) + branchy(dot(L, X));
  sum.x += b > .3 ? twice(b) : loop(dot(N, L));
  v += dot(L, Y);
  return sum * v + loop(dot(L, V));
}
::end shader`,
  'tricky.brdf',
);

const random = createRandom(5);

function direction(): Vector3 {
  const [z, phi] = [random(), 2 * Math.PI * random()];
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}

function randomValues(model: Model): Record<string, number | boolean | number[]> {
  return Object.fromEntries(
    model.parameters.map((p) => {
      if (p.type === 'float') return [p.name, p.min + (p.max - p.min) * random()];
      return [p.name, p.type === 'bool' ? random() < 0.5 : [random(), random(), random()]];
    }),
  );
}

describe.each([...shippedModels.values(), tricky])('$name', (model) => {
  test.each([true, false])('split by light is what it was whole, parameters even: %s', (even) => {
    const { N, X, Y } = LOCAL_FRAME;
    for (const term of model.terms) {
      const f = findFunction(model, term) as NonNullable<ReturnType<typeof findFunction>>;
      const { perView, perLight, derived } = splitByLight(f, model.program, even);
      if (!even) expect(derived).toHaveLength(0);
      const { program } = model;
      const split = new Float64Program({ ...program, functions: [...program.functions, perView, perLight] });
      const [view, light] = [split.callable(perView), split.callable(perLight)];
      const whole = createEvaluator(model);
      for (let i = 0; i < 40; i++) {
        const values = randomValues(model);
        whole.set(values);
        for (const variable of program.parameters)
          split.cell(variable).value = values[variable.name] as Value;
        const quantities = even ? derivedQuantities(model, term).compute(values as never) : [];
        for (const [k, { variable }] of derived.entries())
          split.cell(variable).value = quantities[k] as Value;
        const V = direction();
        view(V, N, X, Y);
        for (let lights = 0; lights < 3; lights++) {
          const L = direction();
          const got = light(L, V, N, X, Y) as readonly number[];
          for (const [c, expected] of whole.f(L, V, undefined, term).entries()) {
            expect(Math.abs((got[c] as number) - expected)).toBeLessThanOrEqual(
              1e-12 * Math.max(1, Math.abs(expected)),
            );
          }
        }
      }
    }
  });
});

test('principled leaves to each light only what depends on it', () => {
  const model = shippedModels.get('principled') as Model;
  const f = findFunction(model, 'BRDF') as NonNullable<ReturnType<typeof findFunction>>;
  const { perLight, derived } = splitByLight(f, model.program, true);
  expect(perLight.uses).toEqual([]);
  expect(derived.length).toBeGreaterThan(5);
});
