import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { carriedLook } from '../../src/scene/carried-look.ts';
import { textureRef } from '../../src/scene/material-schema.ts';
import type { Material } from '../../src/scene/schema.ts';
import { iorOf, specularOf } from '../../src/scene/specular.ts';

const carried = (from: string, to: string, parameters: Material['parameters'], textures = {}) =>
  carriedLook(shippedModels.get(from), shippedModels.get(to), { parameters, textures });

test('a look survives the way to another model and back', () => {
  const values: Material['parameters'] = { baseColor: [0.4, 0.1, 0.05], roughness: 0.3, specular: 0.6 };
  const there = carried('principled', 'cook-torrance', values).parameters;
  expect(there).toMatchObject({ albedo: values.baseColor, roughness: 0.09 });
  // Burley: 8 % of specular; Fresnel at normal incidence.
  expect(((Number(there.ior) - 1) / (Number(there.ior) + 1)) ** 2).toBeCloseTo(0.048, 4);
  const back = carried('cook-torrance', 'principled', there).parameters;
  expect(back.baseColor).toEqual(values.baseColor);
  expect(back.roughness).toBeCloseTo(0.3, 3);
  expect(back.specular).toBeCloseTo(0.6, 3);
});

test('models with the same distribution have the same number for it', () => {
  for (const roughness of [0, 0.123456789, 1])
    expect(carried('principled', 'dielectric', { roughness }).parameters).toEqual({ roughness });
});

test('what the other model has no word for goes, and so does a texture of it', () => {
  const map = textureRef('wood');
  const { parameters, textures } = carried(
    'principled',
    'lambert',
    { sheen: 1, roughness: 0.2, baseColor: [0.1, 0.2, 0.3] },
    { baseColor: map, roughness: map },
  );
  expect(parameters).toEqual({ albedo: [0.1, 0.2, 0.3] });
  expect(textures).toEqual({ albedo: map });
  // A texture of Burley's number is none of an index.
  expect(carried('principled', 'cook-torrance', {}, { specular: map }).textures).toEqual({});
});

test('an index and a gloss are each other’s inverse', () => {
  for (const ior of [1, 1.33, 1.5, 1.8]) expect(iorOf(specularOf(ior))).toBeCloseTo(ior, 12);
});
