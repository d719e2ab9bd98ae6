import type { Evaluator, Frame, Vector3 } from '../../src/glsl/evaluator.ts';
import { BrdfRectLight } from '../../src/lights/rect-light.ts';
import { EXACT, lattice, nearby, ROUNDED, samplingFrame } from './broad-light.ts';
import { dot, type Expectation } from './lit-sphere.ts';

/** A rectangle over the sphere, and what the renderer says that it computes of it. */

const [WIDTH, HEIGHT] = [1.6, 1];
export const LUMINANCE = 5;
const POSITION: Vector3 = [0.8, 1.2, 2];

/** Samples on the rectangle, and directions drawn from the model: as src/material/lighting-model.ts has them. */
const POINTS = 48;
const DIRECTIONS = 32;

export function rectangle(): BrdfRectLight {
  const light = new BrdfRectLight(0xffffff, LUMINANCE, WIDTH, HEIGHT);
  light.position.set(...POSITION);
  light.lookAt(0, 0, 0);
  light.updateMatrixWorld();
  return light;
}

const e = rectangle().matrixWorld.elements;
const RIGHT: Vector3 = [e[0], e[1], e[2]];
const UP: Vector3 = [e[4], e[5], e[6]];
/** The way that it shines. */
const FACING: Vector3 = [-e[8], -e[9], -e[10]];

/** From a point to the rectangle's point (a, b), each -1/2..1/2. */
function towards(point: Vector3, a: number, b: number): { l: Vector3; r2: number; atLight: number } {
  const d = point.map(
    (c, i) => (POSITION[i] as number) + a * WIDTH * (RIGHT[i] as number) + b * HEIGHT * (UP[i] as number) - c,
  );
  const r = Math.hypot(...d);
  const l = d.map((c) => c / r) as unknown as Vector3;
  return { l, r2: r * r, atLight: -dot(l, FACING) };
}

/** The integral over the rectangle of f (n.l) (n'.l)/r^2, by the midpoint rule with `steps` points a side. */
export function converged(
  evaluator: Evaluator,
  point: Vector3,
  V: Vector3,
  frame: Frame,
  steps: number,
): number[] {
  const sums = [0, 0, 0];
  for (let i = 0; i < steps; i++) {
    for (let j = 0; j < steps; j++) {
      const { l, r2, atLight } = towards(point, (i + 0.5) / steps - 0.5, (j + 0.5) / steps - 0.5);
      const cosine = dot(l, frame.N);
      if (cosine > 0 && atLight > 0) add(sums, evaluator.f(l, V, frame), (cosine * atLight) / r2);
    }
  }
  return sums.map((sum) => (sum * LUMINANCE * WIDTH * HEIGHT) / steps ** 2);
}

function add(sums: number[], f: readonly number[], weight: number): void {
  for (const c of [0, 1, 2]) sums[c] = (sums[c] as number) + (f[c] as number) * weight;
}

/** The renderer's quadrature: points and directions, by multiple importance sampling with the power heuristic. */
export function quadrature(
  evaluator: Evaluator,
  point: Vector3,
  V: Vector3,
  N: Vector3,
  rounding = EXACT,
): number[] {
  const frame = samplingFrame(N);
  const sums = [0, 0, 0];
  const area = WIDTH * HEIGHT;
  const weigh = (l: Vector3, own: number, other: number) =>
    add(sums, evaluator.f(l, V, frame), (dot(l, N) * own) / (own * own + other * other));
  for (let i = 0; i < POINTS; i++) {
    const [x, y] = lattice(i, POINTS);
    const { l, r2, atLight } = towards(point, x - 0.5, y - 0.5);
    if (dot(l, N) <= 0 || atLight <= 0) continue;
    weigh(l, (POINTS * r2) / (atLight * area), DIRECTIONS * evaluator.pdf(l, V, frame));
  }
  const center = POSITION.map((c, i) => c - (point[i] as number)) as unknown as Vector3;
  for (let i = 0; i < DIRECTIONS; i++) {
    const l = evaluator.sampleL(lattice(i, DIRECTIONS, rounding), V, frame);
    const atLight = l ? -dot(l, FACING) : 0;
    if (!l || dot(l, N) <= 0 || atLight <= 0) continue;
    const t = -dot(center, FACING) / atLight;
    const hit = l.map((c, k) => c * t - (center[k] as number)) as unknown as Vector3;
    if (t <= 0 || Math.abs(dot(hit, RIGHT)) >= WIDTH / 2 || Math.abs(dot(hit, UP)) >= HEIGHT / 2) continue;
    const density = evaluator.pdf(l, V, frame);
    if (density > 0) weigh(l, DIRECTIONS * density, (POINTS * t * t) / (atLight * area));
  }
  return sums.map((sum) => sum * LUMINANCE);
}

export const rectangleCase = () => ({
  lights: [rectangle()],
  expectation: (evaluator: Evaluator): Expectation => ({
    stride: 2,
    at: ({ point, V, frame }) => quadrature(evaluator, point, V, frame.N),
    // A direction may just miss the rectangle, or follow another lobe.
    near: ({ point, V, frame }) => [
      ...nearby(V, frame).map((w) => quadrature(evaluator, point, w, frame.N)),
      ...ROUNDED.map((rounding) => quadrature(evaluator, point, V, frame.N, rounding)),
    ],
  }),
});
