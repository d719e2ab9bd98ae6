/** What shows where a drag goes: the axes that it goes along, and the sector that it has turned through. */
import type { Vector3 } from 'three/webgpu';
import type { Pixel } from '../projector.ts';
import type { Pointer } from './drag.ts';
import type { Frame } from './frame.ts';
import { AXES, type GizmoView, type HandleId, SIZES } from './handles.ts';
import type { Change } from './placed.ts';
import { onPlane } from './rays.ts';

export interface Guides {
  readonly guides: readonly { readonly id: HandleId; readonly line: readonly Pixel[] }[];
  readonly sector: readonly Pixel[];
}

/** CSS pixels that a line goes to each side: across any screen. */
const FAR = 4000;
/** Pieces of a line that may end behind the camera, and degrees of a piece of the sector. */
const PIECES = 64;
const PIECE_DEGREES = 4;

interface Seen {
  readonly frame: Frame;
  readonly view: GizmoView;
}

/** @param start where the pointer took hold */
export function dragGuides(id: HandleId, change: Change, { frame, view }: Seen, start: Pointer): Guides {
  const guides = AXES.flatMap((axis, i) =>
    id.includes(axis) && (change.type !== 'turn' || id === axis)
      ? [{ id: axis, line: lineAlong(frame, frame.axes[i] as Vector3, view) }]
      : [],
  );
  return { guides, sector: change.type === 'turn' ? sectorOf(id, change, { frame, view }, start) : [] };
}

function lineAlong({ pivot }: Frame, axis: Vector3, view: GizmoView): Pixel[] {
  const line: Pixel[] = [];
  for (let k = -PIECES; k <= PIECES; k++) {
    // Finer near the gizmo, so that what is cut behind the camera is not missed.
    const far = (k / PIECES) ** 3 * FAR * view.pixel;
    const pixel = view.project(pivot.clone().addScaledVector(axis, far));
    if (pixel) line.push(pixel);
  }
  return line;
}

function sectorOf(
  id: HandleId,
  { axis, angle }: Extract<Change, { type: 'turn' }>,
  { frame: { pivot }, view }: Seen,
  start: Pointer,
): Pixel[] {
  const arm = onPlane(start.ray, pivot, axis)?.sub(pivot);
  const centre = view.project(pivot);
  if (!arm || !centre || arm.lengthSq() === 0) return [];
  arm.setLength((id === 'view' ? SIZES.viewRing : SIZES.ring) * view.pixel);
  const pieces = Math.max(1, Math.ceil((Math.abs(angle) * 180) / Math.PI / PIECE_DEGREES));
  const edge: Pixel[] = [];
  for (let k = 0; k <= pieces; k++) {
    const pixel = view.project(pivot.clone().add(arm.clone().applyAxisAngle(axis, (angle * k) / pieces)));
    if (pixel) edge.push(pixel);
  }
  return [centre, ...edge, centre];
}
