import { describe, expect, it, test } from 'vitest';
import { loadModel, shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';

/** Models that let light through: what reflection's tests do not ask. */

const under = ([x, y, z]: Vector3): Vector3 => [x, y, -z];

/** Of radiance, since it is ior^2 times denser on the far side: the share of light that comes through. */
function transmittance(model: Model, values: Record<string, unknown>, v: Vector3): number {
  const { ior } = { ior: 1.5, ...values } as { ior: number };
  const evaluator = createEvaluator(model, values);
  const { value } = directionalAlbedo((l) => evaluator.f(under(l), v), v, { tolerance: 1e-3 });
  return value[0]! * ior * ior;
}

describe('dielectric', () => {
  const model = shippedModels.get('dielectric') as Model;

  it('obeys reciprocity through the boundary: f(l, v) n_v^2 = f(v, l) n_l^2 (Veach 1997, section 5.2)', () => {
    const random = createRandom(5);
    for (let i = 0; i < 300; i++) {
      const ior = 1 + 1.4 * random() + 0.01;
      const roughness = 0.2 + 0.8 * random();
      const [a, b] = [random(), random()].map((u) => 0.05 + 0.95 * u) as [number, number];
      const [p, q] = [random() * 6.28, random() * 6.28];
      const v: Vector3 = [Math.sqrt(1 - a * a) * Math.cos(p), Math.sqrt(1 - a * a) * Math.sin(p), a];
      const l: Vector3 = [Math.sqrt(1 - b * b) * Math.cos(q), Math.sqrt(1 - b * b) * Math.sin(q), -b];
      const forth = createEvaluator(model, { ior, roughness }).f(l, v)[0];
      // The other way round, seen from the other side.
      const back = createEvaluator(model, { ior: 1 / ior, roughness }).f(under(v), under(l))[0];
      expect(Math.abs(forth * ior * ior - back)).toBeLessThan(1e-9 * Math.max(1e-6, back));
    }
  });

  it('reflects and refracts all light, from either side, but for what facets reflect to one another', () => {
    // Head-on into glass: Fresnel's ((n - 1)/(n + 1))^2 comes back.
    const v: Vector3 = [0, 0, 1];
    const values = { ior: 1.5, roughness: 0.3 };
    const evaluator = createEvaluator(model, values);
    const { value } = directionalAlbedo((l) => evaluator.f(l, v), v, { tolerance: 1e-4 });
    expect(value[0]!).toBeCloseTo(0.04, 2);
    const through = transmittance(model, values, v);
    expect(value[0]! + through).toBeGreaterThan(0.985);
    expect(value[0]! + through).toBeLessThan(1.001);
  });

  it('reflects totally beyond the critical angle', () => {
    const evaluator = createEvaluator(model, { ior: 1 / 1.5, roughness: 0 });
    // asin(1/1.5) is 41.8 degrees.
    const [s, c] = [Math.sin(0.8), Math.cos(0.8)];
    for (let i = 0; i < 50; i++) {
      const l = evaluator.sampleL([(i + 0.5) / 50, 0.37], [s, 0, c]);
      if (l) expect(l[2]).toBeGreaterThan(0);
    }
  });
});

test('a thin sheet of principled-bsdf bends no ray and lets the base colour through', () => {
  const model = shippedModels.get('principled-bsdf') as Model;
  const values = { thin: true, specTrans: 1, baseColor: [0.3, 0.6, 0.9], roughness: 0, ior: 1.5 };
  const evaluator = createEvaluator(model, values);
  const v: Vector3 = [0.6, 0, 0.8];
  const random = createRandom(3);
  const sum = [0, 0, 0];
  const count = 4000;
  let across = 0;
  let through = 0;
  for (let i = 0; i < count; i++) {
    const l = evaluator.sampleL([random(), random()], v);
    if (!l || l[2] > 0) continue;
    across += l[0];
    through++;
    const f = evaluator.f(l, v);
    for (const c of [0, 1, 2] as const) sum[c]! += (f[c] * -l[2]) / evaluator.pdf(l, v) / count;
  }
  // Facets tilt single rays, yet the mean goes straight on.
  expect(across / through).toBeCloseTo(-0.6, 2);
  expect(sum[1]! / sum[0]!).toBeCloseTo(2, 5);
  expect(sum[2]! / sum[0]!).toBeCloseTo(3, 5);
});

describe('a header about light that passes through', () => {
  const file = (header: string) => () =>
    loadModel(
      `analytic
# A model.
${header}
::begin parameters
float ior 1 2 1.5
color tint 1 1 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return tint * ior; }
::end shader`,
      'model.brdf',
    );

  it('names parameters of the right types', () => {
    expect(file('# transmits: ior')().file.transmission).toEqual({ ior: 'ior', thin: null, medium: null });
    expect(file('# transmits: ior\n# medium: tint, ior')().file.transmission?.medium).toEqual({
      color: 'tint',
      depth: 'ior',
      scatter: null,
      anisotropy: null,
    });
    expect(file('# Nothing.')().file.transmission).toBeNull();
  });

  it.each([
    ['# transmits: tint', "model.brdf:3: 'tint' is no float parameter"],
    ['# transmits: nothing', "model.brdf:3: 'nothing' is no float parameter"],
    ['# transmits: ior\n# transmits: ior', 'model.brdf:4'],
    ['# thin: ior', 'model.brdf:3: nothing passes through this surface'],
    ['# transmits: ior\n# medium: ior, tint', "model.brdf:4: 'ior' is no color parameter"],
  ])('%s is an error with a place', (header, message) => {
    expect(file(header)).toThrow(message);
  });
});
