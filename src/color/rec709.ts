/** Linear Rec. 709, the colours of everything here. */
import { inverse, type Matrix3, type Triple, transform } from './matrix.ts';

/** XYZ (CIE 1931, 2 degrees, white D65) to linear Rec. 709: IEC 61966-2-1. */
export const XYZ_TO_RGB: Matrix3 = [
  [3.2404541621141054, -1.5371385127977166, -0.4985314095560161],
  [-0.9692660305051868, 1.8760108454466942, 0.0415560175303498],
  [0.0556434309591147, -0.2040259135167538, 1.0572251882231791],
];

/** XYZ of white, RGB 1 1 1: D65 with Y = 1. */
export const WHITE_XYZ: Triple = transform(inverse(XYZ_TO_RGB), [1, 1, 1]);

/** Y of a colour, by the four digits of ITU-R BT.709-6, item 3.2. */
export function luminance([r, g, b]: Triple): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
