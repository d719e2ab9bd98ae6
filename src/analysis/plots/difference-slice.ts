/** The slice over theta_d at a fixed theta_h: mostly the Fresnel reflectance and the masking. */
import { type Curve, type CurvePoint, HORIZON, type Reflectance, radians, reflected } from './curve.ts';
import { directionsFrom } from './half-difference.ts';

export interface DifferenceSliceOptions {
  /** Degrees. */
  readonly thetaH: number;
  readonly phiH: number;
  readonly cosine: boolean;
}

const POINTS = 180;

/** phi_d is 90 degrees, as in the slice over theta_h. */
export function differenceSliceAt(
  f: Reflectance,
  thetaD: number,
  options: DifferenceSliceOptions,
): CurvePoint {
  const { l, v } = directionsFrom({
    thetaH: radians(options.thetaH),
    phiH: radians(options.phiH),
    thetaD: radians(thetaD),
    phiD: Math.PI / 2,
  });
  return { angle: thetaD, rgb: reflected(f, l, v, options.cosine) };
}

export function differenceSlice(f: Reflectance, options: DifferenceSliceOptions): Curve {
  return Array.from({ length: POINTS + 1 }, (_, i) => differenceSliceAt(f, (HORIZON * i) / POINTS, options));
}
