/**
 * The half and difference angles: S. Rusinkiewicz, 1998, "A New Change of Variables for Efficient BRDF
 * Representation". h is the half vector in spherical angles; d is l in a frame in which h is the pole.
 */
import type { Vec3 } from '../vector.ts';

/** Radians. */
export interface HalfDifference {
  readonly thetaH: number;
  readonly phiH: number;
  readonly thetaD: number;
  readonly phiD: number;
}

export function directionsFrom({ thetaH, phiH, thetaD, phiD }: HalfDifference): { l: Vec3; v: Vec3 } {
  const spread = Math.sin(thetaD);
  const d: Vec3 = [spread * Math.cos(phiD), spread * Math.sin(phiD), Math.cos(thetaD)];
  // v is l on the other side of h: the same d turned by half a circle about the pole.
  return { l: fromHalfFrame(d, thetaH, phiH), v: fromHalfFrame([-d[0], -d[1], d[2]], thetaH, phiH) };
}

export function halfDifferenceOf(l: Vec3, v: Vec3): HalfDifference {
  const sum: Vec3 = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
  const thetaH = Math.atan2(Math.hypot(sum[0], sum[1]), sum[2]);
  const phiH = Math.atan2(sum[1], sum[0]);
  const [c, s] = [Math.cos(phiH), Math.sin(phiH)];
  const x = c * l[0] + s * l[1];
  const y = c * l[1] - s * l[0];
  const [ch, sh] = [Math.cos(thetaH), Math.sin(thetaH)];
  const dx = ch * x - sh * l[2];
  return {
    thetaH,
    phiH,
    thetaD: Math.atan2(Math.hypot(dx, y), sh * x + ch * l[2]),
    phiD: Math.atan2(y, dx),
  };
}

function fromHalfFrame(d: Vec3, thetaH: number, phiH: number): Vec3 {
  const [ch, sh] = [Math.cos(thetaH), Math.sin(thetaH)];
  const x = ch * d[0] + sh * d[2];
  const [c, s] = [Math.cos(phiH), Math.sin(phiH)];
  return [c * x - s * d[1], s * x + c * d[1], ch * d[2] - sh * d[0]];
}
