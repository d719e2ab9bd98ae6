/** What is under a pixel of the picture. */
import { type Ray, Raycaster, Vector2, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';

export interface Picked {
  readonly id: string;
  readonly point: Vector3;
}

/** The visible objects of the document along a ray, the nearest first, each once. */
export function pickAlong(mirror: SceneMirror, ray: Ray): Picked[] {
  const raycaster = new Raycaster();
  raycaster.ray.copy(ray);
  raycaster.camera = mirror.camera;
  const found = new Map<string, Picked>();
  for (const { object, point } of raycaster.intersectObject(mirror.scene, true)) {
    const id = object.visible ? mirror.idFor(object) : null;
    if (id !== null && !found.has(id)) found.set(id, { id, point });
  }
  return [...found.values()];
}

/** The same at normalised device coordinates. */
export function pickAt(mirror: SceneMirror, x: number, y: number): Picked[] {
  const raycaster = new Raycaster();
  mirror.camera.updateMatrixWorld();
  raycaster.setFromCamera(new Vector2(x, y), mirror.camera);
  return pickAlong(mirror, raycaster.ray);
}

/** The distance along the view, in metres, of what is at normalised device coordinates, and what it is. */
export function pickDistance(
  mirror: SceneMirror,
  x: number,
  y: number,
): { id: string; distance: number } | null {
  const found = pickAt(mirror, x, y)[0];
  if (!found) return null;
  const forward = mirror.camera.getWorldDirection(new Vector3());
  const distance = found.point.clone().sub(mirror.camera.position).dot(forward);
  return { id: found.id, distance };
}
