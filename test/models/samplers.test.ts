import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { sidakLevel } from '../../src/analysis/chi-squared.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { testSampler } from '../../src/analysis/sampler-test.ts';
import { direction, type Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';

/**
 * The samplers of the models against their densities and against the models themselves.
 */

/** Materials that between them use every lobe, at widths that the cells of a histogram can hold. */
const MATERIALS: Readonly<Record<string, readonly ParameterValues[]>> = {
  lambert: [{}],
  'cook-torrance': [
    {},
    { kd: 0, roughness: 0.15 },
    { metallic: 1, roughness: 0.6 },
    { kd: 1 },
    { albedo: [0, 0, 0], ior: 1, kd: 0.3 },
  ],
  principled: [
    {},
    { metallic: 1, roughness: 0.3 },
    { metallic: 1, roughness: 0.5, anisotropic: 1 },
    { metallic: 0.5, roughness: 1, anisotropic: 0.6 },
    { baseColor: [0, 0, 0], specular: 0, clearcoat: 1, clearcoatGloss: 0 },
    { baseColor: [0.02, 0.02, 0.02], sheen: 1, clearcoat: 1, clearcoatGloss: 0.3 },
    { baseColor: [0, 0, 0], specular: 0, roughness: 0.4 },
  ],
  'principled-thesis': [
    {},
    { metallic: 1, roughness: 0.4, anisotropic: 0.8 },
    { baseColor: [0, 0, 0], metallic: 1 },
    { subsurface: 1, clearcoat: 1, clearcoatGloss: 0 },
  ],
  // An index below 1 is a body seen from inside.
  dielectric: [{ roughness: 0.5 }, { roughness: 0.6, ior: 1 / 1.5 }],
  'principled-bsdf': [
    { specTrans: 0.6, roughness: 0.5, clearcoat: 1, clearcoatGloss: 0 },
    { specTrans: 1, roughness: 0.6, ior: 1 / 1.4 },
    { thin: true, specTrans: 0.3, diffTrans: 0.4, roughness: 0.6, sheen: 1 },
  ],
};

const VIEWS: readonly Vec3[] = [direction(1, 0), direction(0.7, 0.5), direction(0.15, 4)];

const cases = [...shippedModels].flatMap(([name, model]) =>
  (MATERIALS[name] ?? [{}]).map((p) => [name, JSON.stringify(p), model, p] as const),
);
// All together are wrong by chance once in a thousand seeds; the seed is fixed.
const level = sidakLevel(1e-3, cases.length * VIEWS.length);

const mirrorOf = (v: Vec3): Vec3 => [-v[0], -v[1], v[2]];

describe.each(cases)('%s %s', (_name, _json, model, p) => {
  const evaluator = createEvaluator(model, p);
  const transmits = model.file.transmission !== null;

  it.each(VIEWS)('samples as its density says, seen from %d %d %d', (...v) => {
    const { pValue, mass } = testSampler(
      { sample: (u) => evaluator.sampleL(u, v), pdf: (l) => evaluator.pdf(l, v) },
      {
        samples: 6000,
        random: createRandom(41),
        // The sphere is twice the hemisphere: cells as large as two of its own keep the time.
        cells: transmits ? [12, 12] : [8, 16],
        maxEvaluations: 5000,
        sphere: transmits,
        focus: [mirrorOf(v)],
      },
    );
    expect(pValue).toBeGreaterThan(level);
    expect(mass).toBeLessThan(1.0001);
  });

  it('has the mean weight f cos/pdf that is its albedo', () => {
    const random = createRandom(42);
    for (const v of VIEWS) {
      const { value: albedo } = directionalAlbedo((l) => evaluator.f(l, v), v, { tolerance: 4e-3 });
      const count = 2000;
      const sum = [0, 0, 0];
      const squares = [0, 0, 0];
      for (let i = 0; i < count; i++) {
        const l = evaluator.sampleL([random(), random()], v);
        // The albedo is that of reflection.
        if (!l || l[2] < 0) continue;
        const density = evaluator.pdf(l, v);
        for (const [c, f] of evaluator.f(l, v).entries()) {
          const weight = (f * l[2]) / density;
          sum[c]! += weight;
          squares[c]! += weight * weight;
        }
      }
      for (const c of [0, 1, 2]) {
        const mean = sum[c]! / count;
        const deviation = Math.sqrt(Math.max(0, squares[c]! / count - mean * mean) / count);
        // 5 deviations: wrong by chance once in 2 million.
        expect(Math.abs(mean - albedo[c]!)).toBeLessThan(5 * deviation + 4e-3);
      }
    }
  });
});
