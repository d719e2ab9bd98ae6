/**
 * The image slice of BRDF Explorer: theta_h to the right on a square-root axis, because highlights are near
 * 0; theta_d upwards. Most of what a measured material is can be seen in it (Burley 2012, section 3.1).
 */
import { type Reflectance, type Rgb, radians, reflected } from './curve.ts';
import { directionsFrom } from './half-difference.ts';

export interface ImageSlice {
  readonly size: number;
  /** RGB, rows from the top: theta_d from 90 degrees to 0. */
  readonly pixels: Float32Array;
}

export interface ImageSliceOptions {
  /** Degrees. */
  readonly phiD: number;
  readonly cosine: boolean;
}

/** The angles (degrees) at a point of the unit square, y upwards. */
export function imageAngles(x: number, y: number): { thetaH: number; thetaD: number } {
  return { thetaH: 90 * x * x, thetaD: 90 * y };
}

export function imageSliceAt(f: Reflectance, x: number, y: number, options: ImageSliceOptions): Rgb {
  const { thetaH, thetaD } = imageAngles(x, y);
  const { l, v } = directionsFrom({
    thetaH: radians(thetaH),
    phiH: 0,
    thetaD: radians(thetaD),
    phiD: radians(options.phiD),
  });
  return reflected(f, l, v, options.cosine);
}

/** Pictures of growing size: who asks can show the first while the next is made. */
export function* imageSlice(f: Reflectance, options: ImageSliceOptions): Generator<ImageSlice> {
  for (const size of [16, 32, 64, 128]) {
    const pixels = new Float32Array(3 * size * size);
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < size; column++) {
        const rgb = imageSliceAt(f, (column + 0.5) / size, 1 - (row + 0.5) / size, options);
        pixels.set(rgb, 3 * (row * size + column));
      }
    }
    yield { size, pixels };
  }
}
