/** CIE 1976 L*a*b* (CIE 15:2004, section 8.2.1), in which colours of charts and inks are published. */
import { adaptation } from './adaptation.ts';
import { type Triple, transform } from './matrix.ts';
import { XYZ_TO_RGB } from './rec709.ts';

/** XYZ of D50, the light of print and of colour management: ICC.1:2022, section 7.2.16. */
const D50: Triple = [0.9642, 1, 0.8249];
const adapt = adaptation(D50);

/** L*a*b* under D50, of the 2 degree observer, to linear Rec. 709; saturated colours may leave 0..1. */
export function labToRgb([lightness, a, b]: Triple): [number, number, number] {
  const y = (lightness + 16) / 116;
  return transform(
    XYZ_TO_RGB,
    adapt([D50[0] * cube(y + a / 500), D50[1] * cube(y), D50[2] * cube(y - b / 200)]),
  );
}

/** The cube, but straight where it is dark, so that the slope there stays finite. */
const cube = (t: number): number => (t > 6 / 29 ? t ** 3 : 3 * (6 / 29) ** 2 * (t - 4 / 29));
