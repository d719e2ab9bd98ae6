import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import type { Rgb } from '../../src/analysis/plots/curve.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { integrateReflection } from '../../src/analysis/reflection-quadrature.ts';
import { direction } from '../../src/analysis/vector.ts';
import type { Model } from '../../src/glsl/model.ts';
import { albedoAboutMirror } from './polar-quadrature.ts';

const apart = (a: readonly number[], b: Rgb) => Math.max(...b.map((x, c) => Math.abs((a[c] as number) - x)));

/** What tells the models' lobes from one another; each model takes of them what it has. */
const SETS: readonly Record<string, number>[] = [
  {},
  { metallic: 1, specTrans: 1 },
  { kd: 0, ior: 2.4, sheen: 1, clearcoat: 1, subsurface: 1 },
  { metallic: 0.5, anisotropic: 0.7, specular: 1, diffTrans: 0.5, clearcoatGloss: 0 },
];
const VIEWS = [direction(1, 0), direction(0.75, 0.4), direction(0.35, 2), direction(0.12, 5)];

const own = (model: Model, values: Readonly<Record<string, unknown>>) =>
  Object.fromEntries(
    Object.entries(values).filter(([name]) => model.parameters.some((parameter) => parameter.name === name)),
  );

/** In float32, the same function for both: what is compared is the quadratures. */
describe.each([...shippedModels])('%s: the directional albedo', (_name, model) => {
  it.each([0.1, 0.3, 1])('is that of another quadrature to 1e-4, at roughness %d', (roughness) => {
    const evaluator = createQuickEvaluator(model);
    const f = evaluator.term('BRDF');
    const seen = new Set<string>();
    for (const set of SETS) {
      const parameters = own(model, { ...set, roughness });
      if (seen.has(JSON.stringify(parameters))) continue;
      seen.add(JSON.stringify(parameters));
      evaluator.set(parameters);
      for (const v of VIEWS) {
        const { value } = directionalAlbedo(f, v);
        expect(apart(value, albedoAboutMirror(f, v, 192)), `${JSON.stringify(parameters)} ${v}`).toBeLessThan(
          1e-4,
        );
      }
    }
  });
});

describe('mirrors', () => {
  const mirrors = [
    ['cook-torrance', { kd: 0, roughness: 0, ior: 3, albedo: [1, 1, 1] }],
    ['principled', { metallic: 1, roughness: 0 }],
    ['dielectric', { roughness: 0 }],
  ] as const;
  it.each(mirrors)('%s: no view misses the lobe, which is a sliver at grazing angles', (name, parameters) => {
    const f = createQuickEvaluator(shippedModels.get(name) as Model, parameters).term('BRDF');
    for (const cosine of [0.9, 0.1, 0.01]) {
      for (const azimuth of [0, 0.4, Math.PI / 4]) {
        const v = direction(cosine, azimuth);
        const truth = albedoAboutMirror(f, v, cosine < 0.1 ? 2048 : 512);
        const options = { tolerance: 1e-3, maxEvaluations: 6000 };
        expect(apart(directionalAlbedo(f, v, options).value, truth), `${v}`).toBeLessThan(1e-3);
      }
    }
  });
});

describe('integrateReflection', () => {
  it('covers the hemisphere once, for every viewer', () => {
    for (const cosine of [1, 0.5, 0.05]) {
      const { value } = integrateReflection(([x, y, z]) => [1, z, x * x, y], direction(cosine, 1), {
        tolerance: 1e-6,
      });
      const expected = [2 * Math.PI, Math.PI, (2 * Math.PI) / 3, 0];
      for (const [i, x] of expected.entries()) expect(value[i]).toBeCloseTo(x, 5);
    }
  });

  it('finds a narrow peak back to the viewer', () => {
    for (const cosine of [0.9, 0.4]) {
      const v = direction(cosine, 1);
      const kappa = 1e4;
      const peak = (l: typeof v) =>
        (kappa / (2 * Math.PI)) * Math.exp(kappa * (l[0] * v[0] + l[1] * v[1] + l[2] * v[2] - 1));
      const { value } = integrateReflection((l) => [peak(l)], v, { tolerance: 1e-4 });
      expect(value[0]).toBeCloseTo(1, 3);
    }
  });
});
