/** The lobe: f over the whole hemisphere of light for one viewer, on a grid that is fine where the peaks are. */
import { direction } from '../vector.ts';
import { HORIZON, type Reflectance, radians, reflected } from './curve.ts';
import { type LightSliceOptions, viewer } from './light-slice.ts';

export interface Lobe {
  /** Degrees, rising: of the grid's rows, from 0 to the horizon. */
  readonly thetas: readonly number[];
  /** Degrees, rising: of its columns, from 0 on; the first comes again after the last. */
  readonly phis: readonly number[];
  /** RGB, 1/sr, row by row. */
  readonly values: Float32Array;
}

/** Degrees between the lines of the grid away from the peaks: first, and at the end. */
const STEPS = [7.5, 3.75] as const;
const ROWS_AT_ONCE = 8;

/** null in the pauses. */
export function* lobe(f: Reflectance, options: LightSliceOptions): Generator<Lobe | null> {
  const v = viewer(options);
  for (const step of STEPS) {
    const thetas = thetasOf(options.thetaV, step);
    const phis = phisOf(options, step);
    const values = new Float32Array(3 * thetas.length * phis.length);
    for (const [row, theta] of thetas.entries()) {
      for (const [column, phi] of phis.entries()) {
        const l = direction(Math.cos(radians(theta)), radians(phi));
        values.set(reflected(f, l, v, options.cosine), 3 * (row * phis.length + column));
      }
      if (row % ROWS_AT_ONCE === ROWS_AT_ONCE - 1) yield null;
    }
    yield { thetas, phis, values };
  }
}

function thetasOf(thetaV: number, step: number): number[] {
  const thetas = new Set([0, HORIZON]);
  for (let theta = step; theta < HORIZON; theta += step) thetas.add(theta);
  for (const offset of closerAndCloser(step)) thetas.add(thetaV + offset);
  return [...thetas].filter((theta) => theta >= 0 && theta <= HORIZON).sort((a, b) => a - b);
}

/** Closer about the planes of the mirror direction and of the viewer, the wider the nearer they are to the pole. */
function phisOf({ thetaV, phiV }: LightSliceOptions, step: number): number[] {
  const phis = new Set<number>();
  for (let phi = 0; phi < 360; phi += step) phis.add(phi);
  const perDegree = 1 / Math.max(0.1, Math.sin(radians(thetaV)));
  for (const peak of [phiV, phiV + 180]) {
    for (const offset of closerAndCloser(step)) {
      const phi = peak + Math.max(-180, Math.min(180, offset * perDegree));
      phis.add(((phi % 360) + 360) % 360);
    }
  }
  return [...phis].sort((a, b) => a - b);
}

function closerAndCloser(step: number): number[] {
  const offsets = [0];
  for (let distance = 0.75 * step; distance > 0.3; distance *= 0.6) offsets.push(distance, -distance);
  return offsets;
}
