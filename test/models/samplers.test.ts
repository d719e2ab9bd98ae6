import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { sidakLevel } from '../../src/analysis/chi-squared.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { testSampler } from '../../src/analysis/sampler-test.ts';
import { direction, type Vec3 } from '../../src/analysis/vector.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { DULL } from '../pathtracer/generic-materials.ts';

/**
 * The samplers of the models against their densities and against the models themselves. Integrals are of float32, which
 * test/analysis/quick-evaluator.test.ts holds to float64; what is sampled, and the weights' densities, are float64.
 */

const VIEWS: readonly Vec3[] = [direction(1, 0), direction(0.7, 0.5), direction(0.15, 4)];

const cases = [...shippedModels].flatMap(([name, model]) =>
  (DULL[name] ?? [{}]).map((p) => [name, JSON.stringify(p), model, p] as const),
);
// All together are wrong by chance once in a thousand seeds; the seed is fixed.
const level = sidakLevel(1e-3, cases.length * VIEWS.length);

const mirrorOf = (v: Vec3): Vec3 => [-v[0], -v[1], v[2]];

describe.each(cases)('%s %s', (_name, _json, model, p) => {
  const evaluator = createEvaluator(model, p);
  const quick = createQuickEvaluator(model, p);
  const [f, pdf] = [quick.term('BRDF'), quick.pdf()];
  const transmits = model.file.transmission !== null;

  it.each(VIEWS)('samples as its density says, seen from %d %d %d', (...v) => {
    const { pValue, mass } = testSampler(
      { sample: (u) => evaluator.sampleL(u, v), pdf: (l) => pdf(l, v) },
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
      const { value: albedo } = directionalAlbedo(f, v, { tolerance: 4e-3 });
      const count = 2000;
      const sum = [0, 0, 0];
      const squares = [0, 0, 0];
      for (let i = 0; i < count; i++) {
        const l = evaluator.sampleL([random(), random()], v);
        // The albedo is that of reflection.
        if (!l || l[2] < 0) continue;
        const density = evaluator.pdf(l, v);
        for (const [c, value] of evaluator.f(l, v).entries()) {
          const weight = (value * l[2]) / density;
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
