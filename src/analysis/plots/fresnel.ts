/** Fresnel reflectance of a substance over the angle of incidence: exact, by Schlick, and what that is off. */
import type { WhiteLight } from '../../color/light.ts';
import { reflectedColor, schlickColor } from '../substances/reflectance.ts';
import type { Substance } from '../substances/substance.ts';
import { type Curve, type CurvePoint, type Rgb, radians } from './curve.ts';

export interface FresnelCurves {
  /** Shares of 0..1 per channel, linear Rec. 709. */
  readonly exact: Curve;
  readonly schlick: Curve;
  /** schlick - exact. */
  readonly error: Curve;
  /** At normal incidence. */
  readonly f0: Rgb;
}

export function fresnelCurves(
  substance: Substance,
  { light, step = 1 }: { light?: WhiteLight; step?: number } = {},
): FresnelCurves {
  const f0 = reflectedColor(substance, 1, light);
  const angles = [...Array(Math.ceil(90 / step)).keys()].map((i) => i * step);
  const points = [...angles, 90].map((angle) => {
    const cosine = Math.max(0, Math.cos(radians(angle)));
    const [exact, schlick] = [reflectedColor(substance, cosine, light), schlickColor(f0, cosine)];
    const error = schlick.map((c, i) => c - (exact[i] as number)) as unknown as Rgb;
    return { angle, exact, schlick, error };
  });
  const curve = (of: 'exact' | 'schlick' | 'error') =>
    points.map((point): CurvePoint => ({ angle: point.angle, rgb: point[of] }));
  return { exact: curve('exact'), schlick: curve('schlick'), error: curve('error'), f0 };
}
