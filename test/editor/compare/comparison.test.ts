import { expect, test } from 'vitest';
import { otherModels, withModel } from '../../../src/editor/compare/comparison.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { materialDefaults } from '../../../src/scene/material-schema.ts';

const document = createDocument();

test('the same values in another model are those that it knows', () => {
  const material = {
    ...materialDefaults,
    parameters: { baseColor: [1, 0, 0] as [number, number, number], roughness: 0.2, clearcoat: 1 },
  };
  const { material: other } = withModel(document, material, 'principled-thesis');
  expect(other).toMatchObject({ model: 'principled-thesis', parameters: material.parameters });
  const { parameters } = withModel(document, material, 'cook-torrance').material;
  expect(parameters).toEqual({ roughness: 0.2 });
  expect(otherModels(document, material)).not.toContain('principled');
});
