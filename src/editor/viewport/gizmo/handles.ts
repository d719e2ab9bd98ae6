/**
 * The handles of a gizmo as shapes on the screen. What is drawn and what the pointer hits are the same shapes, so that
 * nobody grabs what is not seen.
 */
import type { Vector3 } from 'three/webgpu';
import type { Pixel } from '../projector.ts';
import type { Frame } from './frame.ts';

export type GizmoTool = 'move' | 'rotate' | 'scale';

/** An axis, the plane across an axis, the middle (in the screen's plane, or all axes at once), the ring that faces the eye. */
export type HandleId = 'x' | 'y' | 'z' | 'yz' | 'zx' | 'xy' | 'centre' | 'view';

export const AXES = ['x', 'y', 'z'] as const;
/** The plane across each axis. */
export const PLANES = ['yz', 'zx', 'xy'] as const;

/** The axes that a handle changes, by their places: of the middle, all. */
export function axesIn(id: HandleId): readonly (0 | 1 | 2)[] {
  return ([0, 1, 2] as const).filter((i) => id === 'centre' || id.includes(AXES[i]));
}

/** How the scene is seen where the gizmo stands. */
export interface GizmoView {
  readonly eye: Vector3;
  /** CSS pixels; null behind the camera. */
  project(point: Vector3): Pixel | null;
  /** The length of a CSS pixel at the pivot, m. */
  readonly pixel: number;
}

export interface Handle {
  readonly id: HandleId;
  /** A line, or the outline of an area. */
  readonly points: readonly Pixel[];
  readonly area: boolean;
  /** Parts of a line that are turned away: seen, but not grabbed. */
  readonly away: readonly (readonly Pixel[])[];
  /** 0..1: handles that point at the eye fade. */
  readonly strength: number;
  /** Further than the pivot: drawn before what is nearer. */
  readonly depth: number;
}

/** CSS pixels: handles are as large wherever they stand. */
export const SIZES = {
  axisFrom: 14,
  axis: 88,
  planeFrom: 24,
  planeTo: 44,
  centre: 8,
  ring: 78,
  viewRing: 96,
} as const;

/** Sides of a ring. */
const SIDES = 72;
/** Cosines between an axis and the line of sight from which the axis fades, and is gone. */
const FADES = [0.94, 0.985] as const;
/** Likewise for planes that are seen from their edges. */
const EDGE_ON = [0.2, 0.1] as const;
/** What is fainter is not grabbed. */
const LEAST_STRENGTH = 0.25;

export function handlesOf(tool: GizmoTool, frame: Frame, view: GizmoView): Handle[] {
  const centre = view.project(frame.pivot);
  if (centre === null) return [];
  const sight = frame.pivot.clone().sub(view.eye).normalize();
  const handles: Handle[] = [];
  const add = (handle: Handle | null) => handle && handles.push(handle);
  if (tool === 'rotate') {
    for (const i of [0, 1, 2] as const) add(ringHandle(frame, view, i, sight));
    add(screenHandle('view', circle(centre, SIZES.viewRing), 2, false));
  } else {
    for (const i of [0, 1, 2] as const) {
      add(planeHandle(frame, view, i, sight));
      add(axisHandle(frame, view, i, sight));
    }
    add(screenHandle('centre', circle(centre, SIZES.centre), -2, true));
  }
  return handles.sort((a, b) => b.depth - a.depth);
}

/**
 * The handle under a pixel.
 *
 * @param reach how far beside a line still counts, CSS pixels
 */
export function handleAt(handles: readonly Handle[], at: Pixel, reach: number): HandleId | null {
  let best: { id: HandleId; distance: number } | null = null;
  for (const { id, points, area: isArea, strength } of handles) {
    if (strength < LEAST_STRENGTH) continue;
    // Areas are grabbed within, lines from beside, too. The middle is small and in front of everything.
    const within = isArea && isInside(points, at);
    const beside = isArea && id !== 'centre' ? Number.POSITIVE_INFINITY : distanceTo(points, at);
    const distance = id === 'centre' ? (within ? -1 : beside / 2) : within ? 0 : beside;
    // Of two that are as near, the later one is nearer to the eye.
    if (distance <= (best?.distance ?? reach)) best = { id, distance };
  }
  return best?.id ?? null;
}

function fade(value: number, [from, to]: readonly [number, number]): number {
  return Math.min(1, Math.max(0, (value - to) / (from - to)));
}

function axisHandle({ pivot, axes }: Frame, view: GizmoView, i: 0 | 1 | 2, sight: Vector3): Handle | null {
  const along = axes[i].dot(sight);
  const at = (pixels: number) => view.project(pivot.clone().addScaledVector(axes[i], pixels * view.pixel));
  const [from, to] = [at(SIZES.axisFrom), at(SIZES.axis)];
  const strength = fade(Math.abs(along), FADES);
  if (!from || !to || strength === 0) return null;
  return { id: AXES[i], points: [from, to], area: false, away: [], strength, depth: along };
}

function planeHandle({ pivot, axes }: Frame, view: GizmoView, i: 0 | 1 | 2, sight: Vector3): Handle | null {
  const [u, v] = [axes[(i + 1) % 3] as Vector3, axes[(i + 2) % 3] as Vector3];
  const corner = (a: number, b: number) =>
    view.project(
      pivot
        .clone()
        .addScaledVector(u, a * view.pixel)
        .addScaledVector(v, b * view.pixel),
    );
  const { planeFrom: from, planeTo: to } = SIZES;
  const points = [corner(from, from), corner(to, from), corner(to, to), corner(from, to)];
  const strength = fade(Math.abs(axes[i].dot(sight)), EDGE_ON);
  if (strength === 0 || points.some((point) => point === null)) return null;
  const depth = (u.dot(sight) + v.dot(sight)) / 2;
  return { id: PLANES[i], points: points as Pixel[], area: true, away: [], strength, depth };
}

function ringHandle({ pivot, axes }: Frame, view: GizmoView, i: 0 | 1 | 2, sight: Vector3): Handle | null {
  const [u, v] = [axes[(i + 1) % 3] as Vector3, axes[(i + 2) % 3] as Vector3];
  const radius = SIZES.ring * view.pixel;
  const facesUs = Math.abs(axes[i].dot(sight)) > 0.99;
  const near: Pixel[][] = [[]];
  const far: Pixel[][] = [[]];
  // Begins where the ring goes away from us, so that the near half is one line.
  const start = Math.atan2(v.dot(sight), u.dot(sight));
  for (let k = 0; k <= SIDES; k++) {
    const angle = start + (2 * Math.PI * k) / SIDES;
    const arm = u.clone().multiplyScalar(Math.cos(angle)).addScaledVector(v, Math.sin(angle));
    const pixel = view.project(pivot.clone().addScaledVector(arm, radius));
    if (pixel === null) return null;
    const isNear = facesUs || arm.dot(sight) <= 1e-6;
    const [list, other] = isNear ? [near, far] : [far, near];
    list.at(-1)?.push(pixel);
    if ((other.at(-1)?.length ?? 0) > 0) {
      // Both halves meet.
      other.at(-1)?.push(pixel);
      other.push([]);
    }
  }
  const points = near.flat();
  return {
    id: AXES[i],
    points,
    area: false,
    away: far.filter((line) => line.length > 1),
    strength: 1,
    depth: 0,
  };
}

function screenHandle(id: HandleId, points: Pixel[], depth: number, area: boolean): Handle {
  return { id, points, area, away: [], strength: 1, depth };
}

function circle({ x, y }: Pixel, radius: number): Pixel[] {
  return Array.from({ length: SIDES + 1 }, (_, k) => {
    const angle = (2 * Math.PI * k) / SIDES;
    return { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) };
  });
}

/** From a pixel to the nearest point of a line. */
export function distanceTo(line: readonly Pixel[], at: Pixel): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 1; i < line.length; i++) {
    const [a, b] = [line[i - 1] as Pixel, line[i] as Pixel];
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const length2 = dx * dx + dy * dy;
    const t = length2 > 0 ? ((at.x - a.x) * dx + (at.y - a.y) * dy) / length2 : 0;
    const s = Math.min(1, Math.max(0, t));
    least = Math.min(least, Math.hypot(a.x + s * dx - at.x, a.y + s * dy - at.y));
  }
  return least;
}

/** Whether a pixel is within an outline: a ray to the right crosses it an odd number of times. */
export function isInside(outline: readonly Pixel[], { x, y }: Pixel): boolean {
  let inside = false;
  for (let i = 0, j = outline.length - 1; i < outline.length; j = i++) {
    const [a, b] = [outline[i] as Pixel, outline[j] as Pixel];
    if (a.y > y !== b.y > y && x < ((b.x - a.x) * (y - a.y)) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}
