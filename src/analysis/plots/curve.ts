/** What every plot over an angle is made of. No plot knows a model: it is given a function of l and v. */
import type { Vec3 } from '../vector.ts';

export type Rgb = readonly [number, number, number];

/** A BRDF or one term of it, 1/sr, in the local frame: n = +z, tangent = +x. */
export type Reflectance = (l: Vec3, v: Vec3) => Rgb;

export interface CurvePoint {
  /** Degrees. */
  readonly angle: number;
  readonly rgb: Rgb;
}

export type Curve = readonly CurvePoint[];

/** Degrees. On the horizon itself most models are 0/0, and 0 by a guard: a curve ends just before it. */
export const HORIZON = 89.99;

export const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** f, or f times the cosine at the light's side; zero where a direction is below the surface. */
export function reflected(f: Reflectance, l: Vec3, v: Vec3, cosine: boolean): Rgb {
  if (l[2] < 0 || v[2] < 0) return [0, 0, 0];
  const [r, g, b] = f(l, v);
  return cosine ? [r * l[2], g * l[2], b * l[2]] : [r, g, b];
}
