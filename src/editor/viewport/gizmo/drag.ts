/** What a handle's way under the pointer means: an offset, a turn or factors. */
import { MathUtils, type Ray, Vector3 } from 'three/webgpu';
import type { Steps } from '../../state.ts';
import type { Pixel } from '../projector.ts';
import type { Frame } from './frame.ts';
import { AXES, type GizmoTool, type GizmoView, type HandleId, PLANES, SIZES } from './handles.ts';
import type { Change, Triple } from './placed.ts';
import { alongLine, angleAbout, onPlane, unwrapped } from './rays.ts';

export interface Pointer {
  /** CSS pixels of the viewport. */
  readonly at: Pixel;
  readonly ray: Ray;
}

/** Scales stay above this: a thing that is turned inside out is hard to get hold of. */
const LEAST_FACTOR = 0.01;
/** A plane that is seen more from its edge than this (cosine) is turned along its edge. */
const EDGE_ON = 0.25;
/** CSS pixels to the upper right that make all of it twice as large. */
const DOUBLING_PX = 120;

/** The change from where the pointer took hold to where it is; null where it says nothing. @param snap in steps */
export type Drag = (now: Pointer, snap: boolean) => Change | null;

export function startDrag(
  tool: GizmoTool,
  id: HandleId,
  frame: Frame,
  view: GizmoView,
  start: Pointer,
  steps: Steps,
): Drag {
  if (tool === 'rotate') return turning(id, frame, view, start, MathUtils.degToRad(steps.rotate));
  return tool === 'move'
    ? moving(id, frame, view, start, steps.move)
    : scaling(id, frame, start, steps.scale);
}

const snapped = (value: number, step: number, snap: boolean) =>
  snap ? Math.round(value / step) * step : value;

export const axisOf = (id: HandleId): number => AXES.indexOf(id as (typeof AXES)[number]);
const planeOf = (id: HandleId): number => PLANES.indexOf(id as (typeof PLANES)[number]);
export const towards = ({ pivot }: Frame, { eye }: GizmoView): Vector3 => eye.clone().sub(pivot).normalize();

function moving(id: HandleId, frame: Frame, view: GizmoView, start: Pointer, step: number): Drag {
  const { pivot, axes } = frame;
  const axis = axes[axisOf(id)];
  if (axis) {
    const from = alongLine(start.ray, pivot, axis);
    return ({ ray }, snap) => {
      const to = alongLine(ray, pivot, axis);
      if (from === null || to === null) return null;
      return { type: 'move', offset: axis.clone().multiplyScalar(snapped(to - from, step, snap)) };
    };
  }
  const normal = axes[planeOf(id)] ?? towards(frame, view);
  const from = onPlane(start.ray, pivot, normal);
  return ({ ray }, snap) => {
    const to = onPlane(ray, pivot, normal);
    if (from === null || to === null) return null;
    const offset = to.sub(from);
    if (!snap) return { type: 'move', offset };
    const steps = new Vector3();
    for (const direction of axes)
      steps.addScaledVector(direction, snapped(offset.dot(direction), step, true));
    return { type: 'move', offset: steps };
  };
}

function turning(id: HandleId, frame: Frame, view: GizmoView, start: Pointer, step: number): Drag {
  const sight = towards(frame, view);
  const axis = frame.axes[axisOf(id)] ?? sight;
  const measure =
    Math.abs(axis.dot(sight)) > EDGE_ON
      ? angleInPlane(axis, frame, start)
      : angleAlongEdge(axis, sight, frame, view, start);
  let last = 0;
  return (now, snap) => {
    const angle = measure(now, last);
    if (angle === null) return null;
    last = angle;
    return { type: 'turn', axis: axis.clone(), angle: snapped(angle, step, snap) };
  };
}

type Measure = (now: Pointer, before: number) => number | null;

/** What the pointer goes round the pivot, in the ring's plane. */
function angleInPlane(axis: Vector3, { pivot }: Frame, start: Pointer): Measure {
  const zero = onPlane(start.ray, pivot, axis)?.sub(pivot);
  return ({ ray }, before) => {
    const point = onPlane(ray, pivot, axis);
    if (!zero || !point || zero.lengthSq() === 0) return null;
    return unwrapped(angleAbout(point, pivot, axis, zero.clone().normalize()), before);
  };
}

/** A ring that is seen from its edge is a line: along it, its radius on the screen is one radian. */
function angleAlongEdge(
  axis: Vector3,
  sight: Vector3,
  { pivot }: Frame,
  view: GizmoView,
  start: Pointer,
): Measure {
  // The way of the point that is nearest to the eye; where on the ring it was taken hold of does not matter.
  const way = new Vector3().crossVectors(axis, sight).normalize();
  const radius = SIZES.ring * view.pixel;
  const [a, b] = [view.project(pivot), view.project(pivot.clone().addScaledVector(way, radius))];
  if (!a || !b) return () => null;
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length2 = dx * dx + dy * dy;
  return ({ at }) => (length2 > 0 ? ((at.x - start.at.x) * dx + (at.y - start.at.y) * dy) / length2 : null);
}

function scaling(id: HandleId, { pivot, axes }: Frame, start: Pointer, step: number): Drag {
  const limited = (factor: number, snap: boolean) =>
    Math.max(snap ? step : LEAST_FACTOR, snapped(factor, step, snap));
  const axis = axisOf(id);
  const plane = planeOf(id);
  if (id === 'centre') {
    return ({ at }, snap) => {
      const factor = limited(2 ** ((at.x - start.at.x - (at.y - start.at.y)) / DOUBLING_PX), snap);
      return { type: 'scale', factors: [factor, factor, factor] };
    };
  }
  const only = (i: number, factor: number): Triple =>
    [0, 1, 2].map((k) => ((plane >= 0 ? k !== i : k === i) ? factor : 1)) as Triple;
  const measure = (pointer: Pointer): number | null => {
    if (axis >= 0) return alongLine(pointer.ray, pivot, axes[axis] as Vector3);
    const [u, v] = [axes[(plane + 1) % 3] as Vector3, axes[(plane + 2) % 3] as Vector3];
    // Along the plane's diagonal, on which its handle is.
    return (
      onPlane(pointer.ray, pivot, axes[plane] as Vector3)
        ?.sub(pivot)
        .dot(u.clone().add(v).normalize()) ?? null
    );
  };
  const from = measure(start);
  return (now, snap) => {
    const to = measure(now);
    if (from === null || to === null || from === 0) return null;
    return { type: 'scale', factors: only(axis >= 0 ? axis : plane, limited(to / from, snap)) };
  };
}
