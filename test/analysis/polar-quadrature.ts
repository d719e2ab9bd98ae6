/**
 * The directional albedo a second time, with nothing in common with src/analysis/quadrature.ts: polar coordinates
 * about the mirror direction, Gauss-Legendre in panels that double in width from it outwards, up to where the ray
 * meets the horizon (closed form), and the trapezoidal rule around, which converges geometrically on a period.
 */
import type { Reflectance, Rgb } from '../../src/analysis/plots/curve.ts';
import type { Vec3 } from '../../src/analysis/vector.ts';

/** Gauss-Legendre on 0..1, its nodes by Newton's method on Legendre's polynomial. */
function gaussLegendre(n: number): { x: number; weight: number }[] {
  return Array.from({ length: n }, (_, i) => {
    let x = Math.cos((Math.PI * (i + 0.75)) / (n + 0.5));
    let slope = 1;
    for (let step = 0; step < 50; step++) {
      let [p, before] = [1, 0];
      for (let k = 1; k <= n; k++) [p, before] = [((2 * k - 1) * x * p - (k - 1) * before) / k, p];
      slope = (n * (x * p - before)) / (x * x - 1);
      x -= p / slope;
    }
    return { x: (1 + x) / 2, weight: 1 / ((1 - x * x) * slope * slope) };
  });
}

const NODES = gaussLegendre(10);
/** The first panel is a hundredth of the narrowest lobe that ships, of slope .001. */
const FIRST = 1e-5;

/** @param spokes directions around the mirror direction; at grazing views the horizon needs many */
export function albedoAboutMirror(f: Reflectance, v: Vec3, spokes = 256): Rgb {
  const c = v[2];
  const s = Math.hypot(v[0], v[1]);
  const [ex, ey] = s > 0 ? [-v[0] / s, -v[1] / s] : [1, 0];
  // The mirror direction, the way from it to the horizon in the plane of incidence (upwards), and across.
  const mirror: Vec3 = [s * ex, s * ey, c];
  const up: Vec3 = [-c * ex, -c * ey, s];
  const across: Vec3 = [-ey, ex, 0];
  const sum: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < spokes; i++) {
    const phi = (2 * Math.PI * (i + 0.5)) / spokes;
    const [a, b] = [Math.cos(phi), Math.sin(phi)];
    const horizon = Math.atan2(c, -s * a);
    for (let from = 0; from < horizon; ) {
      const to = Math.min(horizon, from === 0 ? FIRST : 2 * from);
      for (const { x, weight } of NODES) {
        const theta = from + (to - from) * x;
        const [near, far] = [Math.cos(theta), Math.sin(theta)];
        const at = (k: 0 | 1 | 2) => near * mirror[k] + far * (a * up[k] + b * across[k]);
        const l: Vec3 = [at(0), at(1), at(2)];
        const factor = (weight * (to - from) * far * 2 * Math.PI * l[2]) / spokes;
        const value = f(l, v);
        for (const k of [0, 1, 2] as const) sum[k] += factor * value[k];
      }
      from = to;
    }
  }
  return sum;
}
