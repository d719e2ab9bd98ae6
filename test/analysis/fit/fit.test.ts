import { describe, expect, test } from 'vitest';
import { loadModel, shippedModels } from '../../../models/index.ts';
import { type Fit, fitModel } from '../../../src/analysis/fit/fit.ts';
import { createQuickEvaluator } from '../../../src/analysis/quick-evaluator.ts';
import type { ParameterValue, ParameterValues } from '../../../src/brdf/model.ts';
import type { Model } from '../../../src/glsl/model.ts';
import { loadMeasured } from '../../../src/scene/measured.ts';
import { writeMerl } from '../../io/merl-writer.ts';

const shipped = (name: string) => shippedModels.get(name) as Model;
const cookTorrance = shipped('cook-torrance');

const numbers = (value: ParameterValue): readonly number[] =>
  typeof value === 'object' ? value : [Number(value)];

function expectNear(found: ParameterValues, truth: ParameterValues, share: number): void {
  for (const [name, value] of Object.entries(truth)) {
    numbers(value).forEach((x, i) => {
      const off = Math.abs((numbers(found[name] as ParameterValue)[i] as number) - x);
      expect(off, `${name} ${found[name]}`).toBeLessThanOrEqual(share * x);
    });
  }
}

describe('known parameters', () => {
  // All of them are determined where the base is coloured and both base and gloss can be seen.
  const truths: ParameterValues[] = [
    { albedo: [0.7, 0.3, 0.1], kd: 0.6, metallic: 0.3, roughness: 0.25, ior: 1.8 },
    { albedo: [0.1, 0.2, 0.6], kd: 0.3, metallic: 0.5, roughness: 0.6, ior: 1.4 },
    { albedo: [0.5, 0.6, 0.3], kd: 0.8, metallic: 0.1, roughness: 0.05, ior: 2.4 },
    { albedo: [0.8, 0.2, 0.5], kd: 0.5, metallic: 0.7, roughness: 0.12, ior: 1.5 },
  ];
  test.each(truths)('of cook-torrance come back within 1 %%: %j', async (parameters) => {
    const fit = await fitModel({ model: cookTorrance, parameters }, cookTorrance);
    expectNear(fit.parameters, parameters, 0.01);
    expect(fit.loose).toEqual([]);
    expect(fit.errors.cubeRoot).toBeLessThan(1e-6);
  });

  test('of principled: an error 99 % below that of its defaults', async () => {
    const parameters = {
      baseColor: [0.2, 0.5, 0.7],
      subsurface: 0.3,
      specularTint: 0.3,
      roughness: 0.35,
      anisotropic: 0.5,
      sheen: 0.4,
      clearcoat: 0.5,
      clearcoatGloss: 0.7,
    };
    const principled = shipped('principled');
    const {
      errors,
      defaults,
      parameters: found,
    } = await fitModel({ model: principled, parameters }, principled);
    expect(errors.cubeRoot).toBeLessThan(0.01 * defaults.cubeRoot);
    expect(errors.look).toBeLessThan(0.01 * defaults.look);
    expectNear(found, { roughness: 0.35, anisotropic: 0.5, clearcoatGloss: 0.7 }, 0.01);
  });

  test('that others make up for are named as such', async () => {
    const metal = { albedo: [0.9, 0.6, 0.3], metallic: 1, roughness: 0.3 };
    const fit = await fitModel({ model: cookTorrance, parameters: metal }, cookTorrance, {
      fixed: { metallic: 1 },
    });
    // A metal has no base, so its share of the light is nobody's guess; it stays as it was.
    expect(fit.loose).toEqual([['kd']]);
    expect(fit.parameters).toMatchObject({ kd: 0.5 });
    expect(fit.numbers.find(({ name }) => name === 'kd')?.play).toBe(1);
    expectNear(fit.parameters, { roughness: 0.3, ior: 1.5, albedo: [0.9, 0.6, 0.3] }, 0.01);
  });
});

test('measurements in the format of the MERL database', async () => {
  const truth = { albedo: [0.7, 0.3, 0.1], kd: 0.6, metallic: 0.2, roughness: 0.2, ior: 1.8 } as const;
  const original = createQuickEvaluator(cookTorrance, truth).term('BRDF');
  const model = loadMeasured(writeMerl(original), 'red gloss.binary');
  const fit = await fitModel({ model }, cookTorrance);
  // Linear interpolation between the database's bins is what is left.
  expectNear(fit.parameters, truth, 0.03);
  expect(fit.errors.cubeRoot).toBeLessThan(0.01 * fit.size);
  expect(fit.errors.look).toBeLessThan(0.3);
});

const switched = loadModel(
  `analytic
# A switch, and a number with a range of its own.
::begin parameters
bool rough 0
bool unused 1
float gain -2 6 1
color tint 1 1 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    return max(gain, 0.0) * tint * (rough ? 0.1 + 0.1 * L.z * V.z : 0.2 * pow(max(L.z, 0.0), 4.0));
}
::end shader
`,
  'switched.brdf',
);

describe('a fit', () => {
  const target = {
    model: switched,
    parameters: { rough: true, unused: false, gain: 3, tint: [0.5, 0.25, 1] },
  };

  test('tries switches', async () => {
    const { parameters, errors } = await fitModel(target, switched);
    expect(parameters.rough).toBe(true);
    expect(errors.cubeRoot).toBeLessThan(1e-9);
  });

  test('keeps to the ranges and to what is fixed', async () => {
    const bright = { ...target, parameters: { ...target.parameters, gain: 60 } };
    const fit = await fitModel(bright, switched, { fixed: { rough: true, tint: [1, 0.5, 2] } });
    expect(fit.parameters).toEqual({ rough: true, unused: false, gain: 6, tint: [1, 0.5, 2] });
    expect(fit.numbers).toMatchObject([{ name: 'gain', value: 6, bound: 'max' }]);
    for (const { parameters } of fit.candidates) expect(parameters.gain).toBeLessThanOrEqual(6);
  });

  test('is chosen by its look, among those of several metrics', async () => {
    const plain = shipped('lambert');
    const { candidates, errors, metric, defaults } = await fitModel({ model: shipped('principled') }, plain);
    expect(candidates.map((candidate) => candidate.metric)).toEqual([
      'cube root',
      'logarithm',
      'cosine',
      'look',
    ]);
    expect(errors.look).toBe(Math.min(...candidates.map(({ look }) => look)));
    expect(errors).toEqual({
      look: errors.look,
      cubeRoot: candidates.find((candidate) => candidate.metric === metric)?.cubeRoot,
    });
    expect(errors.look).toBeLessThan(defaults.look);
    expect(Math.min(...candidates.map(({ cubeRoot }) => cubeRoot))).toBe(candidates[0]?.cubeRoot);
  });

  test('is the same for the same seed', async () => {
    const fits: Fit[] = [];
    for (const seed of [5, 5, 6]) fits.push(await fitModel({ model: cookTorrance }, switched, { seed }));
    expect(fits[1]).toEqual(fits[0]);
    expect(fits[2]?.parameters).not.toEqual(fits[0]?.parameters);
  });

  test('of a model without parameters only compares', async () => {
    const text = `analytic\n::begin parameters\n::end parameters\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(0.1); }\n::end shader\n`;
    const fit = await fitModel({ model: shipped('lambert') }, loadModel(text, 'grey.brdf'));
    expect(fit.parameters).toEqual({});
    expect(fit.errors).toEqual(fit.defaults);
    expect(fit.errors.look).toBeGreaterThan(1);
  });

  test('reports its progress and can be stopped', async () => {
    const abort = new AbortController();
    const seen: number[] = [];
    const onProgress = (done: number) => {
      seen.push(done);
      if (done > 0.2) abort.abort(new Error('enough'));
    };
    const fit = fitModel({ model: shipped('principled') }, shipped('principled-thesis'), {
      signal: abort.signal,
      onProgress,
    });
    await expect(fit).rejects.toThrow('enough');
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    expect(seen.at(-1)).toBeLessThan(0.5);
    const all: number[] = [];
    await fitModel(target, switched, { onProgress: (done) => all.push(done) });
    expect(all.at(-1)).toBe(1);
    expect(all).toEqual([...all].sort((a, b) => a - b));
  });

  test('says which parameter is wrong', async () => {
    await expect(fitModel(target, switched, { fixed: { gian: 1 } })).rejects.toThrow(
      /switched: parameter gian: there is none/,
    );
  });
});
