import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { cornerParameters, randomDirection, randomParameters } from './hostile.ts';
import {
  type CookTorranceParameters,
  cookTorrance,
  cookTorranceFactors,
  lambert,
  type PrincipledParameters,
  principled,
  principledFactors,
  principledThesis,
} from './reference.ts';

/**
 * The model files against the thesis's formulas, written a second time in reference.ts. The last column is
 * what the reference itself loses: cos^2 - 1 in an exponent over r^2, or 1 + (a^2 - 1) cos^2 with a = .001.
 */

const POINTS = 4000;

const models = {
  lambert: (_l: Vec3, _v: Vec3, p: { albedo: Vec3 }) => lambert(p.albedo),
  'cook-torrance': cookTorrance,
  principled,
  'principled-thesis': principledThesis,
} as const;

function modelNamed(name: string): Model {
  const model = shippedModels.get(name);
  if (!model) throw new Error(`no model ${name}`);
  return model;
}

function expectAgreement(actual: readonly number[], expected: readonly number[], context: unknown) {
  for (const [i, value] of expected.entries()) {
    const error = Math.abs(actual[i]! - value);
    if (!(error <= 1e-9 * Math.abs(value) + 1e-300)) {
      expect.fail(`${actual} is not ${expected} at ${JSON.stringify(context)}`);
    }
  }
}

describe.each(Object.entries(models))('%s', (name, formula) => {
  const model = modelNamed(name);
  const reference = formula as unknown as (l: Vec3, v: Vec3, p: ParameterValues) => readonly number[];
  const evaluator = createEvaluator(model);

  it('is the formula of the thesis at random directions and parameters', () => {
    const random = createRandom(17);
    for (let i = 0; i < POINTS; i++) {
      // Below .01 the reference's own rounding, divided by r^2, shows: 2e-16/1e-6 is 2e-10.
      const p = { ...randomParameters(random, model.parameters) };
      if (name === 'cook-torrance') p.roughness = 0.01 + 0.99 * random();
      const [l, v] = [randomDirection(random, 1e-4), randomDirection(random, 1e-4)];
      evaluator.set(p);
      expectAgreement(evaluator.f(l, v), reference(l, v, p), { l, v, p });
    }
  });

  it("is the formula at the corners of the parameters' ranges", () => {
    const random = createRandom(18);
    for (const corner of cornerParameters(model.parameters)) {
      const p = { ...defaults(model), ...corner };
      if (name === 'cook-torrance') p.roughness = Math.max(0.01, p.roughness as number);
      evaluator.set(p);
      for (let i = 0; i < 20; i++) {
        const [l, v] = [randomDirection(random, 1e-4), randomDirection(random, 1e-4)];
        expectAgreement(evaluator.f(l, v), reference(l, v, p), { l, v, p });
      }
    }
  });

  it('is the sum of its lobes', () => {
    const { lobes } = model.file.declarations;
    if (name !== 'lambert') expect(lobes.length).toBeGreaterThan(1);
    const random = createRandom(19);
    for (let i = 0; lobes.length > 0 && i < 500; i++) {
      const p = randomParameters(random, model.parameters);
      const [l, v] = [randomDirection(random), randomDirection(random)];
      evaluator.set(p);
      const parts = lobes.map((lobe) => evaluator.f(l, v, undefined, lobe));
      const sum = [0, 1, 2].map((c) => parts.reduce((total, part) => total + part[c]!, 0));
      expectAgreement(evaluator.f(l, v), sum, { l, v, p });
    }
  });
});

function defaults(model: Model): ParameterValues {
  return Object.fromEntries(model.parameters.map((parameter) => [parameter.name, parameter.default]));
}

describe('terms that are factors', () => {
  const point = (random: () => number, model: Model) => ({
    l: randomDirection(random, 1e-4),
    v: randomDirection(random, 1e-4),
    p: randomParameters(random, model.parameters),
  });

  it("are cook-torrance's D, F and G", () => {
    const model = modelNamed('cook-torrance');
    const evaluator = createEvaluator(model);
    const random = createRandom(20);
    for (let i = 0; i < 1000; i++) {
      const { l, v, p } = point(random, model);
      const values = { ...p, roughness: 0.01 + 0.99 * (p.roughness as number) };
      evaluator.set(values);
      const factors = cookTorranceFactors(l, v, values as unknown as CookTorranceParameters);
      for (const term of ['distribution', 'fresnel', 'masking'] as const) {
        expectAgreement(evaluator.f(l, v, undefined, term), new Array<number>(3).fill(factors[term]), {
          term,
          l,
          v,
          p,
        });
      }
    }
  });

  it.each(['principled', 'principled-thesis'])("are %s's D and G", (name) => {
    const model = modelNamed(name);
    const evaluator = createEvaluator(model);
    const random = createRandom(21);
    for (let i = 0; i < 1000; i++) {
      const { l, v, p } = point(random, model);
      evaluator.set(p);
      const factors = principledFactors(l, v, p as unknown as PrincipledParameters);
      const expected = {
        distribution: factors.gtr2,
        masking: 4 * l[2] * v[2] * factors.g,
        clearcoatDistribution: factors.gtr1,
      };
      for (const [term, value] of Object.entries(expected)) {
        expectAgreement(evaluator.f(l, v, undefined, term), [value, value, value], { term, l, v, p });
      }
    }
  });
});
