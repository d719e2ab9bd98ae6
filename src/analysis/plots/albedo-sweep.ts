/** The directional albedo over one parameter of a model, for a few angles of the viewer. */
import { albedoAt } from './albedo-curve.ts';
import type { Reflectance, Rgb } from './curve.ts';

/** Degrees: across the disc of a sphere, and near its rim. */
export const sweepAngles = [0, 45, 70, 85] as const;

export interface SweepPoint {
  /** Of the parameter. */
  readonly value: number;
  /** One albedo for each of sweepAngles. */
  readonly albedos: readonly Rgb[];
}

export type Sweep = readonly SweepPoint[];

/** A power of two, so that the first values are spread evenly. */
const INTERVALS = 16;
export const SWEEP_POINTS = INTERVALS + 1;

export interface SweepOptions {
  readonly min: number;
  readonly max: number;
  /** Degrees. */
  readonly phiV: number;
}

/**
 * @param at the model with the parameter at a value
 * @returns the points so far in the order of their values, first far apart, then between; null in the pauses
 */
export function* albedoSweep(
  at: (value: number) => Reflectance,
  { min, max, phiV }: SweepOptions,
): Generator<Sweep | null> {
  const points: SweepPoint[] = [];
  const done = new Set<number>();
  for (let stride = INTERVALS; stride >= 1; stride /= 2) {
    for (let i = 0; i <= INTERVALS; i += stride) {
      if (done.has(i)) continue;
      done.add(i);
      const value = min + ((max - min) * i) / INTERVALS;
      const f = at(value);
      const albedos: Rgb[] = [];
      for (const angle of sweepAngles) {
        albedos.push(albedoAt(f, angle, phiV).rgb);
        yield null;
      }
      points.push({ value, albedos });
      points.sort((a, b) => a.value - b.value);
      yield [...points];
    }
  }
}
