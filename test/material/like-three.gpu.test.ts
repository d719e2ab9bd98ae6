import { expect, test } from 'vitest';
import { testRenderer } from '../support/gpu.ts';
import { brdf, different, draw, FEATURES, lambert } from './like-three.ts';
import { SIZE } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const plain = await draw(renderer, brdf(), {});

test.each(Object.entries(FEATURES))('%s looks as with MeshLambertMaterial', async (name, feature) => {
  const picture = await draw(renderer, brdf(), feature);
  expect(different(picture, await draw(renderer, lambert(), feature))).toBeLessThan(0.002);
  if (name !== 'no normals') expect(different(picture, plain), 'it does something').toBeGreaterThan(0.01);
});
