/** What the selected lights look at: a point that can be dragged over the scene. */
import { type PerspectiveCamera, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import type { Entity } from '../../state.ts';
import { createProjector, type Pixel } from '../projector.ts';
import { pickAlong } from '../selecting/picking.ts';
import type { Pointer } from './drag.ts';
import { roundTo, type Triple } from './placed.ts';
import { onPlane } from './rays.ts';

export interface Target {
  /** Of the light. */
  readonly id: string;
  readonly name: string;
  readonly position: Triple;
  readonly at: Pixel;
}

export function targetsOf(
  document: Document,
  selected: readonly Entity[],
  camera: PerspectiveCamera,
  width: number,
  height: number,
): Target[] {
  if (!selected.some(({ kind }) => kind === 'lights')) return [];
  const projector = createProjector(camera, width, height);
  return selected.flatMap(({ kind, id }): Target[] => {
    const light = kind === 'lights' ? document.lights[id] : undefined;
    if (!light || light.locked || !('target' in light)) return [];
    const at = projector.point(light.target);
    return at ? [{ id, name: light.name, position: light.target, at }] : [];
  });
}

/** A tenth of a millimetre, as the camera is written. */
const STEP = 1e-4;

/**
 * The surface under the pointer; where there is none, the plane that faces the camera at the target's distance. Null while it is
 * not known.
 *
 * @param step that the place is a multiple of, m; null for none
 */
export function aimAt(
  mirror: SceneMirror,
  target: Target,
  { ray }: Pointer,
  step: number | null,
): Triple | null {
  const picked = pickAlong(mirror, ray);
  if (picked instanceof Promise) return null;
  const point =
    picked[0]?.point ??
    onPlane(ray, new Vector3(...target.position), mirror.camera.getWorldDirection(new Vector3()));
  if (!point) return null;
  return point.toArray().map((x) => roundTo(step === null ? x : Math.round(x / step) * step, STEP)) as Triple;
}
