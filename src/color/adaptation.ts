/** What a colour seen under one white is under that of Rec. 709. */
import { inverse, type Matrix3, type Triple, transform } from './matrix.ts';
import { WHITE_XYZ } from './rec709.ts';

/** XYZ to the responses of three kinds of cones: K. M. Lam, 1985, thesis, University of Bradford. */
const BRADFORD: Matrix3 = [
  [0.8951, 0.2664, -0.1614],
  [-0.7502, 1.7135, 0.0367],
  [0.0389, -0.0685, 1.0296],
];
const FROM_BRADFORD = inverse(BRADFORD);

/** XYZ under a white to XYZ under D65: the white becomes Rec. 709's. @param white XYZ with Y = 1 */
export function adaptation(white: Triple): (xyz: Triple) => [number, number, number] {
  const [from, to] = [transform(BRADFORD, white), transform(BRADFORD, WHITE_XYZ)];
  return (xyz) => {
    const [l, m, s] = transform(BRADFORD, xyz);
    return transform(FROM_BRADFORD, [(l * to[0]) / from[0], (m * to[1]) / from[1], (s * to[2]) / from[2]]);
  };
}
