/**
 * The slice over theta_l in the plane of incidence. theta_l is negative on the viewer's side and positive
 * opposite to it, so that the mirror direction is at theta_l = theta_v.
 */
import { direction, type Vec3 } from '../vector.ts';
import { type Curve, type CurvePoint, HORIZON, type Reflectance, radians, reflected } from './curve.ts';

export interface LightSliceOptions {
  /** Degrees. */
  readonly thetaV: number;
  readonly phiV: number;
  readonly cosine: boolean;
}

export function viewer({ thetaV, phiV }: LightSliceOptions): Vec3 {
  return direction(Math.cos(radians(thetaV)), radians(phiV));
}

export function lightSliceAt(f: Reflectance, thetaL: number, options: LightSliceOptions): CurvePoint {
  const phi = radians(options.phiV) + (thetaL < 0 ? 0 : Math.PI);
  const l = direction(Math.cos(radians(Math.abs(thetaL))), phi);
  return { angle: thetaL, rgb: reflected(f, l, viewer(options), options.cosine) };
}

export function lightSlice(f: Reflectance, options: LightSliceOptions): Curve {
  return lightAngles(options.thetaV).map((angle) => lightSliceAt(f, angle, options));
}

/** Every degree, and closer and closer about the two directions where a smooth surface has its peaks. */
function lightAngles(thetaV: number): number[] {
  const angles = new Set<number>([thetaV, -thetaV, HORIZON, -HORIZON]);
  for (let angle = -89; angle <= 89; angle++) angles.add(angle);
  for (let distance = 6; distance > 0.01; distance *= 0.75) {
    for (const peak of [thetaV, -thetaV]) {
      angles.add(peak - distance);
      angles.add(peak + distance);
    }
  }
  return [...angles].filter((angle) => Math.abs(angle) <= HORIZON).sort((a, b) => a - b);
}
