import { describe, expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { testSampler } from '../../src/analysis/sampler-test.ts';
import { direction } from '../../src/analysis/vector.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { type RglOptions, writeRgl } from '../io/rgl-writer.ts';

/** Known models, written on the adaptive grid of the RGL database and read back. */
const gloss = createQuickEvaluator(shippedModels.get('cook-torrance') as Model, {
  roughness: 0.5,
  kd: 0.5,
  ior: 1.8,
}).term('BRDF');
const brushed = createQuickEvaluator(shippedModels.get('principled') as Model, {
  roughness: 0.85,
  metallic: 0.6,
  anisotropic: 0.5,
}).term('BRDF');
const cases: Record<string, { original: typeof gloss; options: RglOptions; mean: number }> = {
  isotropic: { original: gloss, options: { alpha: [0.6, 0.6], resolution: 64, thetas: 16 }, mean: 0.005 },
  'anisotropic, all azimuths,': {
    original: brushed,
    options: { alpha: [0.9, 0.6], phis: 13, thetas: 6, resolution: 40 },
    mean: 0.03,
  },
  'anisotropic, half of them,': {
    original: brushed,
    options: { alpha: [0.9, 0.6], phis: 7, symmetry: 2, thetas: 6, resolution: 40 },
    mean: 0.03,
  },
  'anisotropic, a quarter of them,': {
    original: brushed,
    options: { alpha: [0.9, 0.6], phis: 5, symmetry: 4, thetas: 8, resolution: 40 },
    mean: 0.03,
  },
};

/** The i-th direction, evenly spread over cosines from `least` to 1. */
function spread(i: number, least: number): Vector3 {
  const z = least + (1 - least) * ((i * 0.754877666) % 1);
  return direction(z, 2 * Math.PI * ((i * 0.569840291) % 1)) as Vector3;
}

describe.each(Object.entries(cases))('an RGL file, %s', (_, { original, options, mean }) => {
  const measured = createEvaluator(loadMeasured(writeRgl(original, options), 'somewhere/red gloss.bsdf'));
  const difference = (L: Vector3, V: Vector3) => {
    const read = measured.f(L, V);
    return Math.max(...original(L, V).map((x, c) => Math.abs((read[c] as number) / x - 1)));
  };

  test('is the model that was measured within 2 % where it was measured', () => {
    const { thetas = 16, phis = 1, symmetry = 1 } = options;
    const errors: number[] = [];
    for (let i = 1; i < 1000; i++) {
      const theta = ((i % Math.ceil(thetas * 0.6)) * Math.PI) / 2 / (thetas - 1);
      const phi = phis === 1 ? i : -Math.PI + (2 * Math.PI * (i % phis)) / symmetry / (phis - 1);
      const V = direction(Math.cos(theta), phi) as Vector3;
      errors.push(difference(spread(7 * i, 0.4), V));
    }
    errors.sort((a, b) => a - b);
    // The grid is coarse far from the highlight: a fiftieth may be more, but not much.
    expect(errors[Math.floor(0.98 * errors.length)]).toBeLessThan(0.02);
    expect(errors.at(-1)).toBeLessThan(0.04);
  });

  test('and close to it between', () => {
    let sum = 0;
    for (let i = 1; i <= 1000; i++) sum += difference(spread(i, 0.3), spread(7 * i + 3, 0.3));
    expect(sum / 1000).toBeLessThan(mean);
  });

  test('is finite and not negative everywhere', () => {
    for (let i = 1; i < 800; i++) {
      const [L, V] = [spread(i, 0), spread(11 * i + 5, i % 3 === 0 ? 0 : 0.5)];
      expect(measured.f(L, V).every((x) => Number.isFinite(x) && x >= 0)).toBe(true);
      expect(measured.pdf(L, V)).toBeGreaterThanOrEqual(0);
    }
    const edge: Vector3[] = [
      [0, 0, 1],
      [1, 0, 1e-6],
      [-1, 0, 1e-6],
      [0, 1, 1e-6],
      [0, -1, 1e-6],
      [-0.6, 0, 0.8],
    ];
    for (const L of edge) {
      for (const V of edge) {
        expect([...measured.f(L, V), measured.pdf(L, V)].every(Number.isFinite), `${L} ${V}`).toBe(true);
      }
    }
    expect(measured.f([0.6, 0, -0.8], [0, 0, 1])).toEqual([0, 0, 0]);
  });

  test.each([
    [0.7, 0.5],
    [0.5, 4],
  ])('samples as its density says, seen from a cosine of %d at %d', (cosine, azimuth) => {
    const V = direction(cosine, azimuth) as Vector3;
    const { pValue, mass } = testSampler(
      { sample: (u) => measured.sampleL(u, V), pdf: (l) => measured.pdf(l as Vector3, V) },
      {
        samples: 4000,
        random: createRandom(5),
        cells: [6, 12],
        focus: [[-V[0], -V[1], V[2]]],
        maxEvaluations: 600,
      },
    );
    expect(pValue).toBeGreaterThan(1e-4);
    expect(mass).toBeGreaterThan(0.8);
    expect(mass).toBeLessThan(1.01);
  });

  test('gives most samples about the same weight', () => {
    const V = direction(0.8, 1) as Vector3;
    const random = createRandom(3);
    let [sum, squares, count] = [0, 0, 0];
    for (let i = 0; i < 1000; i++) {
      const l = measured.sampleL([random(), random()], V);
      if (!l) continue;
      const weight = (measured.f(l, V)[1] * l[2]) / measured.pdf(l, V);
      sum += weight;
      squares += weight * weight;
      count++;
    }
    const average = sum / count;
    expect(Math.sqrt(squares / count - average * average) / average).toBeLessThan(0.35);
  });
});

test('a file without the factor D/(4 sigma) is read without', () => {
  const options: RglOptions = { alpha: [0.6, 0.6], resolution: 48, thetas: 6, jacobian: false };
  const bytes = writeRgl(gloss, options);
  const measured = createEvaluator(loadMeasured(bytes, 'plain.bsdf'));
  for (let i = 1; i < 300; i++) {
    const [L, V] = [spread(i, 0.5), direction(Math.cos((i % 4) * 0.1 * Math.PI), i) as Vector3];
    const expected = gloss(L, V)[1];
    expect(Math.abs(measured.f(L, V)[1] / expected - 1)).toBeLessThan(0.04);
  }
});

test('spectra have the colours that they have under D65', () => {
  // Red above 590 nm, nothing below: the same share of each sample's first value.
  const flat: RglOptions = { thetas: 3, resolution: 4 };
  const wavelengths = Array.from({ length: 89 }, (_, i) => 360 + 5 * i);
  const of = (at: (nm: number) => number) => {
    const bytes = writeRgl(() => [0.3, 0.3, 0.3], {
      ...flat,
      spectrum: { wavelengths, at: ([r], nm) => r * at(nm) },
    });
    return createEvaluator(loadMeasured(bytes, 'spectral.bsdf')).f([0.6, 0, 0.8], [0, 0, 1]);
  };
  const [white, red, blue] = [of(() => 1), of((nm) => (nm > 590 ? 1 : 0)), of((nm) => (nm < 480 ? 1 : 0))];
  const [r, g, b] = white as Vector3;
  expect(g / r).toBeCloseTo(1, 4);
  expect(b / r).toBeCloseTo(1, 4);
  expect((red[0] as number) / r).toBeGreaterThan(0.9);
  // Outside Rec. 709 below 0, which is 0.
  expect(red[1]).toBeLessThan(0.1 * (red[0] as number));
  expect(blue[2]).toBeGreaterThan(5 * (blue[1] as number));
  expect(Math.min(...red, ...blue)).toBeGreaterThanOrEqual(0);
});
