/** What is under a pixel of the picture. */
import { Raycaster, Vector2, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../scene/mirror.ts';

/** The nearest visible object of the document at normalised device coordinates, or null. */
export function pickObject(mirror: SceneMirror, x: number, y: number): string | null {
  return pick(mirror, x, y)?.id ?? null;
}

/** The distance along the view, in metres, of what is at normalised device coordinates, and what it is. */
export function pickDistance(
  mirror: SceneMirror,
  x: number,
  y: number,
): { id: string; distance: number } | null {
  const found = pick(mirror, x, y);
  if (found === null) return null;
  const forward = mirror.camera.getWorldDirection(new Vector3());
  const distance = found.point.clone().sub(mirror.camera.position).dot(forward);
  return { id: found.id, distance };
}

function pick(mirror: SceneMirror, x: number, y: number): { id: string; point: Vector3 } | null {
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2(x, y), mirror.camera);
  for (const { object, point } of raycaster.intersectObject(mirror.scene, true)) {
    if (!object.visible) continue;
    const id = mirror.idFor(object);
    if (id !== undefined && id !== null) return { id, point };
  }
  return null;
}
