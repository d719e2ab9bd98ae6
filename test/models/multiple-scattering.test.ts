/** The switch for what facets reflect to one another: what it adds is what was missing. */
import { expect, it } from 'vitest';
import { loadModel, shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import type { Model } from '../../src/glsl/model.ts';
import { evenLight, material, meanOf, narrowCamera, scene, wall } from '../pathtracer/scenes.ts';
import { trace } from '../pathtracer/tracer.ts';

const VIEWS = [1, 0.7, 0.4, 0.2, 0.08];
const ROUGHNESS = [0.15, 0.35, 0.6, 0.8, 1];

/** By float32 as WebAssembly: its rounding is far below what is looked for. */
function albedoOf(name: string) {
  const evaluator = createQuickEvaluator(shippedModels.get(name) as Model);
  return (parameters: ParameterValues, cosine: number, term: string): number => {
    evaluator.set(parameters);
    const f = evaluator.term(term);
    const v = [Math.sqrt(1 - cosine * cosine), 0, cosine] as const;
    return directionalAlbedo((l, view) => f(l, view), v, { tolerance: 1e-3 }).value[0] as number;
  };
}

it('principled: a white metal gives back all light within 1 %, however rough', () => {
  const albedo = albedoOf('principled');
  let most = 0;
  for (const roughness of ROUGHNESS) {
    for (const cosine of VIEWS) {
      const parameters = { baseColor: [1, 1, 1], metallic: 1, roughness } as const;
      const all = albedo(parameters, cosine, 'withMultipleScattering');
      expect(Math.abs(all - 1)).toBeLessThan(0.01);
      most = Math.max(most, all - albedo(parameters, cosine, 'BRDF'));
    }
  }
  expect(most).toBeGreaterThan(0.5);
});

it('cook-torrance: it adds the share that Kulla and Conty give of what is missing', () => {
  // The facets alone: their reflectance is the same for all directions where ior is 1e9, which is F = 1.
  const albedo = albedoOf('cook-torrance');
  const mirror = { albedo: [1, 1, 1], kd: 0, metallic: 1, ior: 1e9 } as const;
  for (const roughness of ROUGHNESS) {
    for (const cosine of VIEWS) {
      const all = albedo({ ...mirror, roughness }, cosine, 'withMultipleScattering');
      expect(Math.abs(all - 1)).toBeLessThan(0.015);
    }
  }
});

it('the path traced furnace shows it: a rough white metal vanishes when the switch is on', async () => {
  const furnace = (multipleScattering: boolean) =>
    scene({
      ...evenLight,
      camera: narrowCamera(0.5),
      objects: { wall: wall() },
      materials: {
        m: material(
          'principled',
          { baseColor: [1, 1, 1], metallic: 1, roughness: 1 },
          { multipleScattering },
        ),
      },
    });
  const options = { samples: 256, width: 16, height: 16, maxDepth: 4 };
  const [off] = meanOf((await trace(furnace(false), options)).mean());
  const [on] = meanOf((await trace(furnace(true), options)).mean());
  expect(off).toBeLessThan(0.55);
  expect(Math.abs(on - 1)).toBeLessThan(0.015);
});

it('a header that names a term that is not there is refused', () => {
  const text = [
    'analytic',
    '# multiple scattering: more',
    '::begin parameters',
    '::end parameters',
    '::begin shader',
    'vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(0.3); }',
    '::end shader',
  ].join('\n');
  expect(() => loadModel(text, 'mine.brdf')).toThrow(/mine\.brdf:1: .*names more\(\), which is no term/);
});
