import { describe, expect, test } from 'vitest';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import { BrdfRectLight } from '../../src/lights/rect-light.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, drawSurface, modelNamed, SIZE, sphereGeometry, surfaceAt } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const surfaces = await drawSurface(renderer, geometry);

const [WIDTH, HEIGHT, LUMINANCE] = [1.6, 1, 5];
const POSITION: Vector3 = [0.8, 1.2, 2];

function rectangle(): BrdfRectLight {
  const light = new BrdfRectLight(0xffffff, LUMINANCE, WIDTH, HEIGHT);
  light.position.set(...POSITION);
  light.lookAt(0, 0, 0);
  light.updateMatrixWorld();
  return light;
}

/** The axes of the rectangle in the world: along its width, its height, and the way that it shines. */
function axes(): [Vector3, Vector3, Vector3] {
  const e = rectangle().matrixWorld.elements;
  return [
    [e[0], e[1], e[2]],
    [e[4], e[5], e[6]],
    [-e[8], -e[9], -e[10]],
  ];
}

/** Points per side of the quadrature over the rectangle. */
const STEPS = 120;

const dot = (a: Vector3, b: Vector3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

describe.each([
  ['lambert', {}, 0.05],
  ['principled', { roughness: 0.8 }, 0.05],
  ['principled', { roughness: 0.4 }, 0.06],
  ['cook-torrance', { roughness: 0.5 }, 0.06],
] as const)('%s %o under a rectangle', (name, values, tolerance) => {
  test('is the integral of the shading equation over it', async () => {
    const model = modelNamed(name);
    const pixels = await drawSphere(renderer, geometry, new BrdfMaterial(model, values), [rectangle()]);
    const evaluator = createEvaluator(model, values);
    const [right, up, facing] = axes();
    let compared = 0;
    for (let y = 8; y < SIZE; y += 16) {
      for (let x = 8; x < SIZE; x += 16) {
        const surface = surfaceAt(surfaces, x, y);
        if (!surface || dot(surface.V, surface.frame.N) < 0.25) continue;
        const { point, V, frame } = surface;
        let expected = 0;
        for (let i = 0; i < STEPS; i++) {
          for (let j = 0; j < STEPS; j++) {
            const [a, b] = [((i + 0.5) / STEPS - 0.5) * WIDTH, ((j + 0.5) / STEPS - 0.5) * HEIGHT];
            const d = [0, 1, 2].map(
              (c) =>
                (POSITION[c] as number) +
                a * (right[c] as number) +
                b * (up[c] as number) -
                (point[c] as number),
            );
            const r = Math.hypot(...d);
            const l = d.map((c) => c / r) as unknown as Vector3;
            const [cosine, atLight] = [dot(l, frame.N), -dot(l, facing)];
            if (cosine <= 0 || atLight <= 0) continue;
            expected += (evaluator.f(l, V, frame)[1] * cosine * atLight) / (r * r);
          }
        }
        expected *= (LUMINANCE * WIDTH * HEIGHT) / STEPS ** 2;
        const got = pixels[(y * SIZE + x) * 4 + 1] as number;
        compared++;
        // Where the rectangle is just above the horizon its few samples show: count against 1 % of its own radiance.
        const error = Math.abs(got - expected) / Math.max(expected, 0.01 * LUMINANCE);
        expect(error, `pixel ${x}, ${y}: ${got} is not ${expected}`).toBeLessThan(tolerance);
      }
    }
    expect(compared).toBeGreaterThan(10);
  });
});
