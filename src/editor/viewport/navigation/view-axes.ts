/** Views along the world's axes, and the axes that the arrow keys move along. */
import { type PerspectiveCamera, Vector3 } from 'three/webgpu';

export type WorldAxis = 'x' | 'y' | 'z';

/** A direction along an axis, towards more of it or less. */
export interface AxisDirection {
  readonly axis: WorldAxis;
  readonly sign: 1 | -1;
}

export function directionOf({ axis, sign }: AxisDirection): Vector3 {
  return new Vector3(axis === 'x' ? sign : 0, axis === 'y' ? sign : 0, axis === 'z' ? sign : 0);
}

/** The world's direction that is nearest to `v`. */
export function nearestAxis(v: Vector3): AxisDirection {
  const sizes = [Math.abs(v.x), Math.abs(v.y), Math.abs(v.z)];
  const axis = (['x', 'y', 'z'] as const)[sizes.indexOf(Math.max(...sizes))] as WorldAxis;
  return { axis, sign: v[axis] < 0 ? -1 : 1 };
}

export interface ViewAxes {
  readonly right: Vector3;
  readonly up: Vector3;
  /** Away from the eye. */
  readonly away: Vector3;
}

/** The world's axes as they lie in the picture: the one nearest to the right, of the others the one nearest to up, and the third. */
export function viewAxes(camera: PerspectiveCamera): ViewAxes {
  camera.updateMatrixWorld();
  const [toRight, toUp, toEye] = [new Vector3(), new Vector3(), new Vector3()];
  camera.matrixWorld.extractBasis(toRight, toUp, toEye);
  const right = directionOf(nearestAxis(toRight));
  // What is to the right is not up as well.
  const up = directionOf(nearestAxis(toUp.addScaledVector(right, -toUp.dot(right))));
  const third = new Vector3().crossVectors(right, up);
  return { right, up, away: third.multiplyScalar(third.dot(toEye) > 0 ? -1 : 1) };
}
