/** What is under a pixel of the picture. */
import { Raycaster, Vector2 } from 'three/webgpu';
import type { SceneMirror } from '../../scene/mirror.ts';

/** The nearest visible object of the document at normalised device coordinates, or null. */
export function pickObject(mirror: SceneMirror, x: number, y: number): string | null {
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2(x, y), mirror.camera);
  for (const { object } of raycaster.intersectObject(mirror.scene, true)) {
    if (!object.visible) continue;
    const id = mirror.idFor(object);
    if (id !== undefined && id !== null) return id;
  }
  return null;
}
