/** What of an object or a light a gizmo changes, and how. Plain numbers, as documents have them. */
import { MathUtils, Quaternion, Vector3 } from 'three/webgpu';
import type { Frame } from './frame.ts';
import { turnOf } from './frame.ts';
import { nearestRotation } from './rotation.ts';

export type Triple = [number, number, number];

/** Objects turn and scale; lights aim at a target; rectangle lights have a size. */
export interface Placed {
  readonly position: Triple;
  /** Degrees about x, then y, then z. */
  readonly rotation?: Triple;
  readonly scale?: Triple;
  readonly target?: Triple;
  readonly width?: number;
  readonly height?: number;
}

export type Change =
  | { readonly type: 'move' /** In world space, m. */; readonly offset: Vector3 }
  /** About the gizmo's pivot. @property angle radians, counter-clockwise seen from where the axis points to */
  | { readonly type: 'turn'; readonly axis: Vector3; readonly angle: number }
  /** About the pivot, along the gizmo's axes. */
  | { readonly type: 'scale'; readonly factors: Triple };

/**
 * What a change makes of one thing.
 *
 * @param axes of the thing itself: sizes are along these
 * @param step what lengths are rounded to, m: no finer than the hand
 */
export function changed(
  placed: Placed,
  own: Frame['axes'],
  change: Change,
  frame: Frame,
  step: number,
): Placed {
  switch (change.type) {
    case 'move': {
      const move = (point: Triple) => rounded(new Vector3(...point).add(change.offset), step, point);
      return {
        position: move(placed.position),
        ...(placed.target && { target: move(placed.target) }),
      };
    }
    case 'turn': {
      const turn = new Quaternion().setFromAxisAngle(change.axis, change.angle);
      const about = (point: Triple) =>
        rounded(new Vector3(...point).sub(frame.pivot).applyQuaternion(turn).add(frame.pivot), step, point);
      return {
        position: about(placed.position),
        ...(placed.target && { target: about(placed.target) }),
        ...(placed.rotation && {
          rotation: nearestRotation(turn.multiply(turnOf(placed.rotation)), placed.rotation).map((degrees) =>
            roundTo(degrees, ANGLE_STEP),
          ) as Triple,
        }),
      };
    }
    case 'scale':
      return scaled(placed, own, change.factors, frame, step);
  }
}

/** Degrees: finer than a hand turns. */
const ANGLE_STEP = 0.01;
/** Digits of a scale. */
const SCALE_DIGITS = 5;

function scaled(placed: Placed, own: Frame['axes'], factors: Triple, frame: Frame, step: number): Placed {
  const stretch = (v: Vector3) => {
    const result = new Vector3();
    for (const [i, axis] of frame.axes.entries())
      result.addScaledVector(axis, v.dot(axis) * (factors[i] as number));
    return result;
  };
  // A thing at an angle to the gizmo would be sheared; it becomes as long along its own axes as it would then be.
  const along = own.map((axis) => stretch(axis).length()) as Triple;
  const offset = new Vector3(...placed.position).sub(frame.pivot);
  const moved = stretch(offset).sub(offset);
  const move = (point: Triple) => rounded(new Vector3(...point).add(moved), step, point);
  const size = (value: number, factor: number) => Number((value * factor).toPrecision(SCALE_DIGITS));
  return {
    position: move(placed.position),
    ...(placed.target && { target: move(placed.target) }),
    ...(placed.scale && { scale: placed.scale.map((s, i) => size(s, along[i] as number)) as Triple }),
    ...(placed.width !== undefined && { width: size(placed.width, along[0]) }),
    ...(placed.height !== undefined && { height: size(placed.height, along[1]) }),
  };
}

/** Coordinates that a change leaves alone stay the very numbers they were, however they were written. */
function rounded(point: Vector3, step: number, before: Triple): Triple {
  return point
    .toArray()
    .map((x, i) =>
      Math.abs(x - (before[i] as number)) < step / 2 ? (before[i] as number) : roundTo(x, step),
    ) as Triple;
}

/** To a multiple of a step that is a power of ten, in as few digits as that needs. */
export function roundTo(value: number, step: number): number {
  const digits = Math.max(0, Math.round(-Math.log10(step)));
  // Never -0, which would be another value than a document's 0.
  return Number((Math.round(value / step) * step).toFixed(digits)) + 0;
}

/** The power of ten below half a pixel, a centimetre at most: what a hand can mean. @param pixel the length of one, m */
export function handStep(pixel: number): number {
  return 10 ** Math.floor(Math.log10(MathUtils.clamp(pixel / 2, 1e-6, 0.01)));
}
