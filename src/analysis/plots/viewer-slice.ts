/**
 * The slice over theta_v in the plane of the light: negative on the light's side and positive opposite to it, so that
 * the mirror direction is at theta_v = theta_l. For a reciprocal model it is the slice over theta_l, exchanged.
 */
import type { Curve, CurvePoint, Reflectance } from './curve.ts';
import { lightSlice, lightSliceAt } from './light-slice.ts';

export interface ViewerSliceOptions {
  /** Degrees. */
  readonly thetaL: number;
  readonly phiL: number;
  readonly cosine: boolean;
}

export function viewerSliceAt(f: Reflectance, thetaV: number, options: ViewerSliceOptions): CurvePoint {
  return lightSliceAt(exchanged(f, options), thetaV, lightOf(options));
}

export function viewerSlice(f: Reflectance, options: ViewerSliceOptions): Curve {
  return lightSlice(exchanged(f, options), lightOf(options));
}

const lightOf = ({ thetaL, phiL }: ViewerSliceOptions) => ({ thetaV: thetaL, phiV: phiL, cosine: false });

/** What moves comes first; the cosine is that of the light, which stays. */
function exchanged(f: Reflectance, { cosine }: ViewerSliceOptions): Reflectance {
  return (v, l) => {
    const [r, g, b] = f(l, v);
    return cosine ? [r * l[2], g * l[2], b * l[2]] : [r, g, b];
  };
}
