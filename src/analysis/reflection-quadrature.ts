/**
 * Integration over all directions l of what a surface reflects towards v.
 *
 * Lobes are narrow in the half vector h, and as wide for every v: seen at a grazing angle, a mirror's lobe is a sliver
 * over l that an adaptive rule misses without a sign of it, but a round spot over h. So the integral is taken over h in
 * spherical angles about the normal, dl = 4 (v.h) dh, up to the angle at which l meets the horizon; and theta_h grows
 * with sinh, so that each power of ten of it has its share of the points.
 */
import { type Integral, integrateRectangle, type QuadratureOptions } from './quadrature.ts';
import type { Vec3 } from './vector.ts';

/**
 * theta_h = theta_max sinh(K u) / sinh(K): even in log(theta_h) above some 2e-5 and even in theta_h below, a fortieth
 * of the narrowest lobe that ships (slope .001).
 */
const K = 12;
/**
 * Cells over u and the azimuth to begin with. A lobe of any width spans one of the first; at grazing views theta_max changes
 * steeply where the azimuth is a quarter turn from that of v, which is an edge.
 */
const GRID = [8, 4] as const;
/** How often the cells around the direction back to v are halved, where some models have a peak. */
const BACKWARD_DEPTH = 4;

export interface ReflectionOptions extends QuadratureOptions {
  /** Whether to look closely at the direction back to v; true if not given. */
  readonly backward?: boolean;
}

/**
 * The integral over the hemisphere about +z with respect to solid angle (multiply by z for the cosine).
 *
 * @param v the direction to the viewer, above the surface
 */
export function integrateReflection(
  f: (l: Vec3) => readonly number[],
  v: Vec3,
  { backward = true, ...options }: ReflectionOptions = {},
): Integral {
  const c = v[2];
  const s = Math.hypot(v[0], v[1]);
  const [ex, ey] = s > 0 ? [v[0] / s, v[1] / s] : [1, 0];
  // n.l = c cos(2 theta_h) + s sin(2 theta_h) cos(phi_h) is 0 there.
  const horizon = (cosPhi: number) => Math.atan2(c, -s * cosPhi) / 2;
  const integrand = (u: number, phi: number): readonly number[] => {
    const [cosPhi, sinPhi] = [Math.cos(phi), Math.sin(phi)];
    const scale = horizon(cosPhi) / Math.sinh(K);
    const theta = scale * Math.sinh(K * u);
    const [sinTheta, z] = [Math.sin(theta), Math.cos(theta)];
    const vh = c * z + s * sinTheta * cosPhi;
    const [along, across] = [sinTheta * cosPhi, sinTheta * sinPhi];
    const [x, y] = [along * ex - across * ey, along * ey + across * ex];
    // Rounding may put what is on the horizon below it.
    const l: Vec3 = [2 * vh * x - v[0], 2 * vh * y - v[1], Math.max(0, 2 * vh * z - c)];
    const weight = 4 * vh * sinTheta * scale * K * Math.cosh(K * u);
    return f(l).map((value) => weight * value);
  };
  // h is v there.
  const back: [number, number] = [Math.asinh((Math.atan2(s, c) / horizon(1)) * Math.sinh(K)) / K, 0];
  const rectangle = { x: 0, y: -Math.PI, width: 1, height: 2 * Math.PI };
  return integrateRectangle(integrand, rectangle, {
    ...options,
    grid: GRID,
    focus: backward ? [back] : [],
    focusDepth: BACKWARD_DEPTH,
  });
}
