/**
 * The image slice of BRDF Explorer: theta_h to the right, on a square-root axis because highlights are near 0;
 * theta_d upwards. Most of what a measured material is can be seen in it (Burley 2012, section 3.1).
 */
import { type Reflectance, type Rgb, radians, reflected } from './curve.ts';
import { directionsFrom } from './half-difference.ts';

export interface ImageSliceOptions {
  /** Degrees. */
  readonly phiD: number;
  readonly cosine: boolean;
  /** theta_h grows with the square of x. */
  readonly squareRoot: boolean;
}

/** The angles (degrees) at a point of the unit square, y upwards. */
export function imageAngles(
  x: number,
  y: number,
  { squareRoot }: Pick<ImageSliceOptions, 'squareRoot'>,
): { thetaH: number; thetaD: number } {
  return { thetaH: 90 * (squareRoot ? x * x : x), thetaD: 90 * y };
}

export function imageSliceAt(f: Reflectance, x: number, y: number, options: ImageSliceOptions): Rgb {
  const { thetaH, thetaD } = imageAngles(x, y, options);
  const { l, v } = directionsFrom({
    thetaH: radians(thetaH),
    phiH: 0,
    thetaD: radians(thetaD),
    phiD: radians(options.phiD),
  });
  return reflected(f, l, v, options.cosine);
}
