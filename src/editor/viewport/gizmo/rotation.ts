/** A turn as the three angles of a document. */
import { MathUtils, Matrix4, type Quaternion } from 'three/webgpu';
import type { Triple } from './placed.ts';

/** Closer than this to looking along the first axis (1 − |sin y|), only the sum or difference of x and z is known. */
const LOCKED = 1e-9;

/**
 * Degrees about x, then y, then z, of a turn. There are always several such triples; this is the one nearest to
 * `before`, so that numbers under a hand run on and do not jump from 89 to 91 degrees as (180, 89, 180).
 */
export function nearestRotation(turn: Quaternion, before: Triple): Triple {
  const e = new Matrix4().makeRotationFromQuaternion(turn).elements;
  const at = (row: number, column: number) => e[4 * column + row] as number;
  // Rx Ry Rz: its first row is (cos y cos z, −cos y sin z, sin y).
  const sine = MathUtils.clamp(at(0, 2), -1, 1);
  const [, , z0] = before.map(MathUtils.degToRad) as Triple;
  const y = Math.asin(sine);
  if (1 - Math.abs(sine) < LOCKED) {
    // Where y is 90 degrees, the turn is about x by x + z; at −90, by x − z.
    const sum = Math.atan2(at(2, 1), at(1, 1));
    return near([sum - Math.sign(sine) * z0, y, z0], before);
  }
  const x = Math.atan2(-at(1, 2), at(2, 2));
  const z = Math.atan2(-at(0, 1), at(0, 0));
  const one = near([x, y, z], before);
  const other = near([x + Math.PI, Math.PI - y, z + Math.PI], before);
  return distance(one, before) <= distance(other, before) ? one : other;
}

/** In degrees, each within half a turn of what it was. */
function near(radians: Triple, before: Triple): Triple {
  return radians.map((angle, i) => {
    const degrees = MathUtils.radToDeg(angle);
    return degrees + 360 * Math.round(((before[i] as number) - degrees) / 360);
  }) as Triple;
}

function distance(a: Triple, b: Triple): number {
  return a.reduce((sum, x, i) => sum + (x - (b[i] as number)) ** 2, 0);
}
