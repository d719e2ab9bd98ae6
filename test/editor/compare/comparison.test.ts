import { expect, test } from 'vitest';
import {
  type Comparison,
  missingOf,
  otherModels,
  withModel,
} from '../../../src/editor/compare/comparison.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { materialDefaults } from '../../../src/scene/material-schema.ts';
import { objectDefaults } from '../../../src/scene/schema.ts';

const document = createDocument();

test('the same look in another model is what it knows of it', () => {
  const material = {
    ...materialDefaults,
    parameters: { baseColor: [1, 0, 0] as [number, number, number], roughness: 0.2, clearcoat: 1 },
  };
  const { material: other } = withModel(document, material, 'principled-thesis');
  expect(other).toMatchObject({ model: 'principled-thesis', parameters: material.parameters });
  const { parameters } = withModel(document, material, 'cook-torrance').material;
  expect(parameters.albedo).toEqual([1, 0, 0]);
  expect(parameters.roughness).toBeCloseTo(0.2 ** 2, 5);
  expect(Object.keys(parameters)).toHaveLength(2);
  expect(otherModels(document, material)).not.toContain('principled');
});

test('there is nothing to compare without A, without B, or when no object has A', () => {
  const materials = { a: materialDefaults, b: materialDefaults };
  const box = { ...objectDefaults, material: 'a' };
  const comparison: Comparison = { material: 'a', other: { kind: 'scene', id: 'b' }, title: 'B' };
  const missing = (content: object) =>
    missingOf({ ...document, materials, objects: { box }, ...content }, comparison);
  expect(missing({})).toBeNull();
  expect(missing({ materials: { b: materialDefaults } })).toBe('A');
  expect(missing({ materials: { a: materialDefaults } })).toBe('B');
  expect(missing({ objects: {} })).toBe('objects');
  expect(missing({ objects: { box: { ...box, material: 'b' } } })).toBe('objects');
});
