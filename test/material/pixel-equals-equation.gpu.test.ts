import { describe, expect, test } from 'vitest';
import { testRenderer } from '../support/gpu.ts';
import { albedoCurve, BROAD_LIGHTS, BROAD_MATERIALS, compareBroad, STRIDE } from './broad-light.ts';
import {
  compareSphere,
  drawSurface,
  LIGHT_CASES,
  MATERIAL_CASES,
  SIZE,
  sphereGeometry,
} from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const surfaces = await drawSurface(renderer, geometry);

describe.each(Object.keys(LIGHT_CASES))('a sphere under a light: %s', (light) => {
  test.each(Object.keys(MATERIAL_CASES))('%s is the shading equation in every pixel', async (material) => {
    const { count, worst, where } = await compareSphere(renderer, geometry, surfaces, material, light);
    expect(count).toBeGreaterThan(3000);
    expect(worst, where).toBeLessThan(1e-3);
  });
});

describe.each(Object.keys(BROAD_MATERIALS))('a sphere of %s', (material) => {
  const curve = albedoCurve(material);

  test.each(Object.keys(BROAD_LIGHTS))('under %s is the shading equation in every pixel', async (light) => {
    const { count, jumps, worst, where } = await compareBroad(
      renderer,
      geometry,
      surfaces,
      material,
      light,
      curve,
    );
    expect(count).toBeGreaterThan(3000 / STRIDE ** 2);
    expect(jumps / count).toBeLessThan(0.05);
    expect(worst, where).toBeLessThan(1e-3);
  });
});
