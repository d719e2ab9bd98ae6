import { describe, expect, test } from 'vitest';
import { between, randomised, scaleOf } from '../../../src/analysis/library/variation.ts';
import type { FloatParameter } from '../../../src/brdf/model.ts';
import { fromOklab, oklab } from '../../../src/color/oklab.ts';
import { findModel } from '../../../src/scene/models.ts';

const modelOf = (name: string) => findModel({ models: {}, assets: {} }, name)!;
const principled = modelOf('principled');
const cookTorrance = modelOf('cook-torrance');
const float = (model: typeof principled, name: string) =>
  model.parameters.find((parameter) => parameter.name === name) as FloatParameter;

describe('Oklab', () => {
  test('has white at lightness 1 without a hue, and comes back', () => {
    const [lightness, a, b] = oklab([1, 1, 1]);
    expect(lightness).toBeCloseTo(1, 5);
    expect(Math.hypot(a, b)).toBeLessThan(1e-4);
    const color = [0.3, 0.05, 0.7] as const;
    for (const [i, c] of fromOklab(oklab(color)).entries()) expect(c).toBeCloseTo(color[i]!, 5);
  });
});

describe('a randomised material', () => {
  const values = { baseColor: [0.5, 0.2, 0.1] as const, roughness: 0.3 };

  test('is the same for the same seed, another for another, and stays where nothing may change', () => {
    const once = randomised(principled, values, { amount: 0.5, seed: 3 });
    expect(randomised(principled, values, { amount: 0.5, seed: 3 })).toEqual(once);
    expect(randomised(principled, values, { amount: 0.5, seed: 4 })).not.toEqual(once);
    expect(randomised(principled, values, { amount: 0, seed: 3 })).toMatchObject(values);
  });

  test.each(['principled', 'cook-torrance', 'principled-bsdf', 'dielectric', 'lambert'])(
    'of %s stays within its ranges',
    (name) => {
      const model = modelOf(name);
      for (let seed = 1; seed <= 200; seed++) {
        const found = randomised(model, {}, { amount: seed / 200, seed });
        for (const parameter of model.parameters) {
          const value = found[parameter.name]!;
          if (parameter.type === 'bool') expect(value).toBe(parameter.default);
          const [low, high] = parameter.type === 'float' ? [parameter.min, parameter.max] : [0, 1];
          for (const number of [value].flat().map(Number)) {
            expect(number).toBeGreaterThanOrEqual(low);
            expect(number).toBeLessThanOrEqual(high);
          }
        }
      }
    },
  );

  test('goes as far as it was told', () => {
    for (let seed = 1; seed <= 100; seed++) {
      const { roughness } = randomised(principled, values, { amount: 0.1, seed });
      expect(Math.abs((roughness as number) - 0.3)).toBeLessThanOrEqual(0.1 + 1e-3);
    }
  });

  test('has roughnesses that are even to the eye', () => {
    // Burley's is the square root of the facets' width already; Cook and Torrance's is the width.
    const width = { principled: 2, 'cook-torrance': 1 };
    for (const model of [principled, cookTorrance]) {
      const roots = Array.from({ length: 2000 }, (_, seed) => {
        const { roughness } = randomised(model, {}, { amount: 1, seed });
        return (roughness as number) ** (width[model.name as 'principled'] / 2);
      });
      for (let part = 0; part < 4; part++) {
        const count = roots.filter((root) => root >= part / 4 && root < (part + 1) / 4).length;
        expect(count / roots.length).toBeGreaterThan(0.21);
        expect(count / roots.length).toBeLessThan(0.29);
      }
    }
  });
});

describe('between two materials', () => {
  const [a, b] = [
    { albedo: [0.9, 0.1, 0.1] as const, roughness: 0.04, metallic: 0 },
    { albedo: [0.1, 0.2, 0.8] as const, roughness: 0.64, ior: 2 },
  ];

  test('are both at the ends', () => {
    expect(between(cookTorrance, a, b, 0)).toMatchObject(a);
    expect(between(cookTorrance, a, b, 1)).toMatchObject(b);
  });

  test('is the middle of what is seen', () => {
    const middle = between(cookTorrance, a, b, 0.5);
    // The square roots .2 and .8 have .5 between them.
    expect(middle.roughness).toBeCloseTo(0.25, 2);
    expect(middle.ior).toBeCloseTo(1.75, 3);
    const lightness = (color: unknown) => oklab(color as [number, number, number])[0];
    expect(lightness(middle.albedo)).toBeCloseTo((lightness(a.albedo) + lightness(b.albedo)) / 2, 2);
  });

  test('a scale and its inverse cancel', () => {
    for (const [model, name] of [
      [principled, 'roughness'],
      [principled, 'sheen'],
      [cookTorrance, 'roughness'],
      [cookTorrance, 'ior'],
    ] as const) {
      const parameter = float(model, name);
      const { place, value } = scaleOf(model, parameter);
      const at = parameter.min + 0.37 * (parameter.max - parameter.min);
      expect(value(place(at))).toBeCloseTo(at, 9);
    }
  });
});
