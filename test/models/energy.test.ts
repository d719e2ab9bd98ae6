import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { integrateHemisphere } from '../../src/analysis/quadrature.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { direction } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { cornerParameters } from './hostile.ts';

/**
 * How much of the light each model gives back: the figures that the model files' headers state, by
 * quadrature of float32. White surfaces, so that the albedo is that of the model and not of its colour.
 */

const white = { baseColor: [1, 1, 1] } as const;

function albedo(name: string, p: ParameterValues, cosTheta: number, maxEvaluations = 8_000): number {
  const f = createQuickEvaluator(shippedModels.get(name)!, p).term('BRDF');
  const view = direction(cosTheta, 0.4);
  return directionalAlbedo(f, view, { tolerance: 1e-3, maxEvaluations }).value[0]!;
}

/** Equal to within 1 %. */
function expectAlbedo(actual: number, expected: number) {
  expect(Math.abs(actual / expected - 1), `${actual}, not ${expected}`).toBeLessThan(0.01);
}

describe('directional albedo', () => {
  it('lambert: the albedo, for every direction', () => {
    for (const cosTheta of [1, 0.5, 0.01]) expectAlbedo(albedo('lambert', {}, cosTheta), 0.8);
  });

  it('cook-torrance: at most 1, even white and with the strongest reflection', () => {
    for (const kd of [0, 0.5, 1]) {
      for (const roughness of [0.1, 0.3, 1]) {
        for (const cosTheta of [1, 0.3, 0.05, 0.01]) {
          const p = { albedo: [1, 1, 1], ior: 3, kd, roughness } as const;
          expect(albedo('cook-torrance', p, cosTheta)).toBeLessThan(1.001);
        }
      }
    }
  });

  it('principled metals: at most 1; rough ones lose what facets reflect more than once', () => {
    const metal = { ...white, metallic: 1 };
    for (const roughness of [0.2, 0.5, 1]) {
      for (const cosTheta of [1, 0.5, 0.1, 0.01]) {
        expect(albedo('principled', { ...metal, roughness }, cosTheta)).toBeLessThan(1.001);
      }
    }
    expectAlbedo(albedo('principled', { ...metal, roughness: 0.2 }, 1), 0.998);
    expectAlbedo(albedo('principled', { ...metal, roughness: 0.5 }, 1), 0.916);
    expectAlbedo(albedo('principled', { ...metal, roughness: 1 }, 1), 0.307);
  });

  it('principled dielectrics: above 1 where white, but bounded', () => {
    expectAlbedo(albedo('principled', white, 1), 1.043);
    expectAlbedo(albedo('principled', white, 0.1), 1.18);
    expectAlbedo(albedo('principled', { ...white, roughness: 1 }, 0.01), 1.581);
    expectAlbedo(albedo('principled', { ...white, roughness: 0.2, subsurface: 1 }, 0.1), 1.641);
  });

  it("principled: below 2 at all corners of its parameters' ranges", () => {
    const { parameters } = shippedModels.get('principled')!;
    for (const corner of cornerParameters(parameters, 0)) {
      // Wide lobes, so that few points see them; how much they reflect hardly depends on their width.
      const p = {
        ...corner,
        clearcoatGloss: 0,
        roughness: Math.max(0.3, (corner.roughness as number | undefined) ?? 0.5),
      };
      for (const cosTheta of [0.1, 0.01]) expect(albedo('principled', p, cosTheta, 6000)).toBeLessThan(2);
    }
    expectAlbedo(
      albedo(
        'principled',
        { ...white, roughness: 1, specular: 1, sheen: 1, clearcoat: 1, clearcoatGloss: 0 },
        0.01,
      ),
      1.738,
    );
  });

  it('principled-thesis: the product in f_subsurface gives back more than it receives, without bound', () => {
    const p = { ...white, subsurface: 1 };
    expectAlbedo(albedo('principled-thesis', p, 1), 2.25);
    expectAlbedo(albedo('principled-thesis', p, 0.1), 12.9);
    expectAlbedo(albedo('principled-thesis', p, 0.01), 64.8);
    expectAlbedo(albedo('principled', p, 0.01), 1.253);
    expect(albedo('principled-thesis', p, 0.001)).toBeGreaterThan(500);
  });

  it('principled-thesis: metals are dark', () => {
    const p = { ...white, metallic: 1, roughness: 0.3 };
    expectAlbedo(albedo('principled-thesis', p, 1), 0.0275);
    expectAlbedo(albedo('principled-thesis', { ...p, specular: 1 }, 1), 0.081);
    expectAlbedo(albedo('principled', p, 1), 0.991);
  });
});

describe('the share of samples that is not lost below the surface', () => {
  const mass = (name: string, p: ParameterValues, cosTheta: number): number => {
    const pdf = createQuickEvaluator(shippedModels.get(name)!, p).pdf();
    const [view, mirror] = [direction(cosTheta, 0.4), direction(cosTheta, 0.4 + Math.PI)];
    return integrateHemisphere((l) => [pdf(l, view)], { focus: [mirror], tolerance: 1e-3 }).value[0]!;
  };

  it('lambert: all', () => {
    for (const cosTheta of [1, 0.3]) expect(mass('lambert', {}, cosTheta)).toBeCloseTo(1, 3);
  });

  it('principled metals: all but what visible facets send down', () => {
    expect(mass('principled', { metallic: 1, roughness: 0.3 }, 0.1)).toBeCloseTo(0.964, 2);
    expect(mass('principled', { metallic: 1, roughness: 1 }, 1)).toBeCloseTo(0.5, 2);
  });

  it('cook-torrance metals: at grazing angles about half, whose facets look away', () => {
    expect(mass('cook-torrance', { metallic: 1, roughness: 0.3 }, 1)).toBeCloseTo(1, 2);
    expect(mass('cook-torrance', { metallic: 1, roughness: 0.3 }, 0.1)).toBeCloseTo(0.589, 2);
  });
});
