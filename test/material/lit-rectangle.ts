import type { Evaluator, Frame, Vector3 } from '../../src/glsl/evaluator.ts';
import { BrdfRectLight } from '../../src/lights/rect-light.ts';
import { EXACT, lattice, nearby, ROUNDED, STRIDE, samplingFrame } from './broad-light.ts';
import { dot, type Expectation } from './lit-sphere.ts';

/** A rectangle over a surface, and what the renderer says that it computes of it. */

export const LUMINANCE = 5;

/** Samples on the rectangle, and directions drawn from the model: as src/material/lighting-model.ts has them. */
const POINTS = 26;
const DIRECTIONS = 48;
const DIRECTIONS_TRUST = 0.5;
const LEAST_SQUARE = 1e-3;

export interface Panel {
  readonly center: Vector3;
  /** Unit vectors along its sides, and the way that it shines. */
  readonly right: Vector3;
  readonly up: Vector3;
  readonly facing: Vector3;
  readonly width: number;
  readonly height: number;
}

export function rectangle(): BrdfRectLight {
  const light = new BrdfRectLight(0xffffff, LUMINANCE, 1.6, 1);
  light.position.set(0.8, 1.2, 2);
  light.lookAt(0, 0, 0);
  light.updateMatrixWorld();
  return light;
}

const e = rectangle().matrixWorld.elements;
/** rectangle() as a panel. */
export const OVER_THE_SPHERE: Panel = {
  center: [e[12], e[13], e[14]],
  right: [e[0], e[1], e[2]],
  up: [e[4], e[5], e[6]],
  facing: [-e[8], -e[9], -e[10]],
  width: rectangle().width,
  height: rectangle().height,
};

/** What is lit: a point, and how it reflects towards V. */
export interface Lit {
  readonly evaluator: Pick<Evaluator, 'f' | 'pdf' | 'sampleL'>;
  readonly point: Vector3;
  readonly V: Vector3;
  readonly frame: Frame;
}

/** From a point to the panel's point (a, b), each -1/2..1/2. */
function towards({ center, right, up, facing, width, height }: Panel, point: Vector3, a: number, b: number) {
  const d = along(center, (c, i) => c + a * width * right[i] + b * height * up[i] - point[i]);
  const r = Math.hypot(...d);
  const l = along(d, (c) => c / r);
  return { l, r2: r * r, atLight: -dot(l, facing) };
}

const along = (v: Vector3, change: (c: number, i: 0 | 1 | 2) => number): Vector3 => [
  change(v[0], 0),
  change(v[1], 1),
  change(v[2], 2),
];

/** The integral over the rectangle of f (n.l) (n'.l)/r^2, by the midpoint rule with `steps` points a side. */
export function converged({ evaluator, point, V, frame }: Lit, panel: Panel, steps: number): number[] {
  const sums = [0, 0, 0];
  for (let i = 0; i < steps; i++) {
    for (let j = 0; j < steps; j++) {
      const { l, r2, atLight } = towards(panel, point, (i + 0.5) / steps - 0.5, (j + 0.5) / steps - 0.5);
      const cosine = dot(l, frame.N);
      if (cosine > 0 && atLight > 0) add(sums, evaluator.f(l, V, frame), (cosine * atLight) / r2);
    }
  }
  return sums.map((sum) => (sum * LUMINANCE * panel.width * panel.height) / steps ** 2);
}

function add(sums: number[], f: readonly number[], weight: number): void {
  for (const c of [0, 1, 2]) sums[c] = (sums[c] as number) + (f[c] as number) * weight;
}

/** Directions that the model draws, how densely in 1/sr, and what it reflects of them; the same for every panel. */
export interface Drawn {
  readonly count: number;
  readonly directions: readonly { l: Vector3; density: number; f: readonly number[] }[];
}

export function drawn({ evaluator, V, frame }: Lit, count = DIRECTIONS, rounding = EXACT): Drawn {
  const directions = Array.from({ length: count }, (_, i) => {
    const l = evaluator.sampleL(lattice(i, count, rounding), V, frame);
    const density = l && dot(l, frame.N) > 0 ? count * evaluator.pdf(l, V, frame) : 0;
    return l && density > 0 ? [{ l, density, f: [...evaluator.f(l, V, frame)] }] : [];
  });
  return { count, directions: directions.flat() };
}

/**
 * The renderer's quadrature: points and directions, by multiple importance sampling with the power heuristic. Of the square
 * that a direction stands for, the part counts that the panel covers.
 */
export function quadrature(
  lit: Lit,
  panel: Panel,
  { count, directions } = drawn(lit),
  points = POINTS,
): number[] {
  const { evaluator, point, V, frame } = lit;
  const { center, right, up, facing, width, height } = panel;
  const sums = [0, 0, 0];
  const weigh = (l: Vector3, f: readonly number[], own: number, other: number, part: number) =>
    add(sums, f, (part * dot(l, frame.N) * own) / (own * own + other * other));
  for (let i = 0; i < points; i++) {
    const [x, y] = lattice(i, points);
    const { l, r2, atLight } = towards(panel, point, x - 0.5, y - 0.5);
    if (dot(l, frame.N) <= 0 || atLight <= 0) continue;
    const other = DIRECTIONS_TRUST * count * evaluator.pdf(l, V, frame);
    weigh(l, evaluator.f(l, V, frame), (points * r2) / (atLight * width * height), other, 1);
  }
  const toCenter = along(center, (c, i) => c - point[i]);
  for (const { l, density, f } of directions) {
    const atLight = -dot(l, facing);
    const t = -dot(toCenter, facing) / atLight;
    if (atLight <= 0 || t <= 0) continue;
    const hit = along(l, (c, i) => c * t - toCenter[i]);
    const area = (t * t) / atLight;
    const half = Math.sqrt(area / density) / 2;
    const part =
      covered((2 * dot(hit, right)) / width, (2 * half) / width) *
      covered((2 * dot(hit, up)) / height, (2 * half) / height);
    if (part > 0) weigh(l, f, density, (points * area) / (width * height * DIRECTIONS_TRUST), part);
  }
  return sums.map((sum) => sum * LUMINANCE);
}

/** Of x - half..x + half, the part that is in -1..1. */
function covered(x: number, half: number): number {
  const h = Math.max(half, LEAST_SQUARE);
  return Math.max(0, Math.min(x + h, 1) - Math.max(x - h, -1)) / (2 * h);
}

export const rectangleCase = () => ({
  lights: [rectangle()],
  expectation: (evaluator: Evaluator): Expectation => ({
    stride: STRIDE,
    at: ({ point, V, frame }) => drawnBy({ evaluator, point, V, frame: samplingFrame(frame.N) }),
    // A direction may just miss the rectangle, or follow another lobe.
    near: ({ point, V, frame: { N } }) => {
      const lit = { evaluator, point, frame: samplingFrame(N) };
      return [
        ...nearby(V, lit.frame).map((w) => drawnBy({ ...lit, V: w })),
        ...ROUNDED.map((rounding) => drawnBy({ ...lit, V }, rounding)),
      ];
    },
  }),
});

const drawnBy = (lit: Lit, rounding = EXACT): number[] =>
  quadrature(lit, OVER_THE_SPHERE, drawn(lit, DIRECTIONS, rounding));
