/** The slice over theta_h at a fixed theta_d: the shape of the highlight, mostly the distribution of normals. */
import { type Curve, type CurvePoint, HORIZON, type Reflectance, radians, reflected } from './curve.ts';
import { directionsFrom } from './half-difference.ts';

export interface HalfSliceOptions {
  /** Degrees. */
  readonly thetaD: number;
  readonly phiH: number;
  readonly cosine: boolean;
}

const POINTS = 220;

/** phi_d is 90 degrees, where l and v are above the surface for every theta_h and theta_d. */
export function halfSliceAt(f: Reflectance, thetaH: number, options: HalfSliceOptions): CurvePoint {
  const { l, v } = directionsFrom({
    thetaH: radians(thetaH),
    phiH: radians(options.phiH),
    thetaD: radians(options.thetaD),
    phiD: Math.PI / 2,
  });
  return { angle: thetaH, rgb: reflected(f, l, v, options.cosine) };
}

/** The angles are squares: highlights are near 0. */
export function halfSlice(f: Reflectance, options: HalfSliceOptions): Curve {
  return Array.from({ length: POINTS + 1 }, (_, i) => halfSliceAt(f, HORIZON * (i / POINTS) ** 2, options));
}
