import { describe, expect, test } from 'vitest';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import { samplingFrame } from './broad-light.ts';
import { converged, LUMINANCE, OVER_THE_SPHERE, quadrature } from './lit-rectangle.ts';
import { dot, modelNamed } from './lit-sphere.ts';

/**
 * How far the renderer's quadrature over a rectangle is from the integral. That its pixels are this quadrature
 * is the affair of pixel-equals-equation.
 */

/** Points of the sphere that lit-sphere.ts draws, with the view from its camera. */
const POINTS: { point: Vector3; V: Vector3 }[] = [];
for (let y = -0.9; y <= 0.9; y += 0.36) {
  for (let x = -0.9; x <= 0.9; x += 0.36) {
    const z = Math.sqrt(1 - x * x - y * y);
    const d: Vector3 = [-x, -y, 3.2 - z];
    const V = d.map((c) => c / Math.hypot(...d)) as unknown as Vector3;
    if (dot([x, y, z], V) > 0.25) POINTS.push({ point: [x, y, z], V });
  }
}

// docs/decisions/wide-lights.md has the figures, from more points.
describe.each([
  // Matte surfaces: the error is that of the points where the horizon cuts the rectangle.
  ['lambert', {}, { worst: 0.03, rms: 0.01 }],
  ['principled', { roughness: 0.4 }, { worst: 0.03, rms: 0.01 }],
  // Glossy ones: few of the directions belong to the highlight.
  ['principled', { roughness: 0.2 }, { worst: 0.06, rms: 0.018 }],
  // A metal has nothing beside its highlight.
  ['principled', { roughness: 0.3, metallic: 1 }, { worst: 0.05, rms: 0.012 }],
] as const)('%s %o under a rectangle', (name, values, bound) => {
  test('errs by no more than is known, relative to the integral or to 1 % of the light', () => {
    const evaluator = createEvaluator(modelNamed(name), values);
    const errors = POINTS.map(({ point, V }) => {
      const lit = { evaluator, point, V, frame: samplingFrame(point) };
      const exact = converged(lit, OVER_THE_SPHERE, 60)[1] as number;
      const drawn = quadrature(lit, OVER_THE_SPHERE)[1] as number;
      return Math.abs(drawn - exact) / Math.max(exact, 0.01 * LUMINANCE);
    });
    expect(Math.max(...errors)).toBeLessThan(bound.worst);
    expect(Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length)).toBeLessThan(bound.rms);
  });
});
