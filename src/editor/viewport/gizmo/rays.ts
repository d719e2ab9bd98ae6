/** A pointer's ray against the lines, planes and rings that a gizmo's handles move along. */
import type { Ray } from 'three/webgpu';
import { Vector3 } from 'three/webgpu';

/** Rays closer to parallel than this (sine squared) meet a line, or a plane, too far away to be of use. */
const PARALLEL = 1e-6;

/**
 * Where along a line it comes nearest to a ray, in lengths of `direction` (of length 1) from `point`; null if they are
 * parallel. With w from the ray's origin to `point` and b the cosine between both, the least distance is where
 * t = (b (d·w) − a·w) / (1 − b²).
 */
export function alongLine({ origin, direction: d }: Ray, point: Vector3, a: Vector3): number | null {
  const b = a.dot(d);
  const sine2 = 1 - b * b;
  if (sine2 < PARALLEL) return null;
  const w = point.clone().sub(origin);
  return (b * d.dot(w) - a.dot(w)) / sine2;
}

/** Where a ray meets a plane, before its origin; null if it does not. */
export function onPlane({ origin, direction }: Ray, point: Vector3, normal: Vector3): Vector3 | null {
  const slope = direction.dot(normal);
  if (slope * slope < PARALLEL) return null;
  const t = point.clone().sub(origin).dot(normal) / slope;
  return t > 0 ? origin.clone().addScaledVector(direction, t) : null;
}

/**
 * The angle of a point about an axis through `centre`, in radians, counter-clockwise seen from where the axis points to.
 *
 * @param zero where the angle is 0: of length 1 and perpendicular to the axis
 */
export function angleAbout(point: Vector3, centre: Vector3, axis: Vector3, zero: Vector3): number {
  const arm = point.clone().sub(centre);
  return Math.atan2(arm.dot(new Vector3().crossVectors(axis, zero)), arm.dot(zero));
}

/** The same angle, written so that it follows on `before` without a jump. */
export function unwrapped(angle: number, before: number): number {
  return angle + 2 * Math.PI * Math.round((before - angle) / (2 * Math.PI));
}
