/** Where a gizmo stands, and which way its axes point. */
import { Euler, MathUtils, Quaternion, Vector3 } from 'three/webgpu';
import type { Triple } from './placed.ts';

export type Axes = readonly [x: Vector3, y: Vector3, z: Vector3];

export interface Frame {
  /** In world space. */
  readonly pivot: Vector3;
  /** Perpendicular, right-handed, of length 1. */
  readonly axes: Axes;
}

export const worldAxes = (): Axes => [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** A turn in degrees about x, then the turned y, then z, as documents have it. */
export function turnOf(rotation: Triple): Quaternion {
  const [x, y, z] = rotation.map(MathUtils.degToRad) as [number, number, number];
  return new Quaternion().setFromEuler(new Euler(x, y, z, 'XYZ'));
}

export function axesOf(turn: Quaternion): Axes {
  const [x, y, z] = worldAxes();
  return [x.applyQuaternion(turn), y.applyQuaternion(turn), z.applyQuaternion(turn)];
}

/** The axes of a light that looks at its target: -z points there, x is level. */
export function aimedAxes(position: Triple, target: Triple): Axes {
  const z = new Vector3(...position).sub(new Vector3(...target));
  if (z.lengthSq() === 0) return worldAxes();
  z.normalize();
  // As light-lines.ts draws it: straight up and down there is no level direction of its own.
  const helper = Math.abs(z.y) > 0.9999 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  const x = new Vector3().crossVectors(helper, z).normalize();
  return [x, new Vector3().crossVectors(z, x), z];
}

/** The middle of points: their mean. */
export function middleOf(points: readonly Triple[]): Vector3 {
  const sum = new Vector3();
  for (const point of points) sum.add(new Vector3(...point));
  return points.length > 0 ? sum.divideScalar(points.length) : sum;
}
