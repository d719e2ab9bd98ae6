import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import type { Rgb } from '../../src/analysis/plots/curve.ts';
import { imageSliceAt } from '../../src/analysis/plots/image-slice.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { direction } from '../../src/analysis/vector.ts';
import { randomPoint } from '../../src/analysis/verdict/space.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { writeMerl } from '../io/merl-writer.ts';

const apart = (quick: Rgb, exact: Rgb): number =>
  Math.max(...quick.map((x, c) => Math.abs(x - (exact[c] as number)))) /
  Math.max(1e-3, ...exact.map(Math.abs));

describe.each([...shippedModels])('%s in float32', (_name, model) => {
  it('is what float64 is, for the model and its terms', () => {
    const random = createRandom(4);
    const [quick, exact] = [createQuickEvaluator(model), createEvaluator(model)];
    const worst: Record<string, number> = {};
    const errors: number[] = [];
    for (let i = 0; i < 300; i++) {
      const { parameters, l, v } = randomPoint(random, model.parameters);
      quick.set(parameters);
      exact.set(parameters);
      for (const term of model.terms) {
        const error = apart(quick.term(term)(l, v), exact.f(l, v, undefined, term));
        errors.push(error);
        worst[term] = Math.max(worst[term] ?? 0, error);
      }
    }
    errors.sort((a, b) => a - b);
    // Rounding, but in the narrowest lobes, which multiply that of the directions by their steepness.
    expect(errors[Math.floor(0.9 * errors.length)]).toBeLessThan(2e-5);
    expect(Math.max(...Object.values(worst)), JSON.stringify(worst)).toBeLessThan(0.03);
  });

  it('has the density of its sampler', () => {
    if (!model.hasSampling) return;
    const random = createRandom(6);
    const [quick, exact] = [createQuickEvaluator(model), createEvaluator(model)];
    const errors: number[] = [];
    for (let i = 0; i < 300; i++) {
      const { parameters, l, v } = randomPoint(random, model.parameters);
      quick.set(parameters);
      exact.set(parameters);
      const [density, truth] = [quick.pdf()(l, v), exact.pdf(l, v)];
      errors.push(apart([density, density, density], [truth, truth, truth]));
    }
    errors.sort((a, b) => a - b);
    expect(errors[Math.floor(0.9 * errors.length)]).toBeLessThan(2e-5);
    expect(errors.at(-1)).toBeLessThan(0.03);
  });

  it('integrates to the same albedo', () => {
    const v = direction(0.6, 0.4);
    const options = { tolerance: 1e-4, maxEvaluations: 12_000 };
    const exact = createEvaluator(model);
    const { value } = directionalAlbedo((l, w) => exact.f(l, w), v, options);
    const quick = directionalAlbedo(createQuickEvaluator(model).term('BRDF'), v, options);
    expect(apart(quick.value as unknown as Rgb, value as unknown as Rgb)).toBeLessThan(1e-5);
  });
});

it('where the lobe is a mirror, the picture is still within a percent', () => {
  const model = shippedModels.get('principled') as Model;
  const parameters = { metallic: 1, roughness: 0.05 };
  const [quick, exact] = [
    createQuickEvaluator(model, parameters).term('BRDF'),
    createEvaluator(model, parameters),
  ];
  const options = { phiD: 90, cosine: false, squareRoot: true };
  for (let i = 0; i < 40; i++) {
    const [x, y] = [0.005 * i, 0.3];
    const truth = imageSliceAt((l, v) => exact.f(l, v), x, y, options);
    expect(apart(imageSliceAt(quick, x, y, options), truth), `${x}`).toBeLessThan(0.01);
  }
});

it('two evaluators of one model keep their own parameters', () => {
  const model = shippedModels.get('lambert') as Model;
  const [a, b] = [{ albedo: [1, 1, 1] }, { albedo: [0.5, 0.5, 0.5] }].map((set) =>
    createQuickEvaluator(model, set),
  );
  const up = direction(0.8, 0);
  const at = (one: typeof a) => one?.term('BRDF')(up, up)[0];
  expect(at(a)).toBeCloseTo(1 / Math.PI, 6);
  expect(at(b)).toBeCloseTo(0.5 / Math.PI, 6);
  a?.set({ albedo: [0.25, 0.25, 0.25] });
  expect(at(a)).toBeCloseTo(0.25 / Math.PI, 6);
  expect(at(b)).toBeCloseTo(0.5 / Math.PI, 6);
});

it('measurements', () => {
  const bytes = writeMerl((l, v) => [0.3 + l[2] * v[2], 0.2, 0.1 + l[0] * v[0] + l[1] * v[1] + 1]);
  const model = loadMeasured(bytes, 'm.binary');
  const [quick, exact] = [createQuickEvaluator(model).term('BRDF'), createEvaluator(model)];
  const random = createRandom(5);
  for (let i = 0; i < 50; i++) {
    const { l, v } = randomPoint(random, []);
    if (Math.min(l[2], v[2]) > 0.1) expect(apart(quick(l, v), exact.f(l, v))).toBeLessThan(1e-4);
  }
});

it('a term that the model does not have is an error', () => {
  const model = shippedModels.get('lambert') as Model;
  expect(() => createQuickEvaluator(model).term('gloss')).toThrow(/no term gloss; its terms are BRDF/);
  expect(() => createQuickEvaluator(model, { albedo: 'red' })).toThrow(/albedo/);
});
