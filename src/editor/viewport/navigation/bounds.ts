/** What a camera that looks at something has to see. */
import { Box3, Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';
import type { Entity } from '../../state.ts';

/** Around a light, which is a point, m. */
const LIGHT_MARGIN = 0.5;

/** Of all that is selected, of what has a selected material, or of every object. */
export function boundsOf(document: Document, mirror: SceneMirror, selected: readonly Entity[]): Box3 {
  const box = new Box3();
  for (const { kind, id } of selected) {
    if (kind === 'lights') expandByLight(box, document, id);
    else
      for (const [object, { material }] of Object.entries(document.objects))
        if (object === id || (kind === 'materials' && material === id)) expandByMesh(box, mirror, object);
  }
  if (box.isEmpty()) for (const id of Object.keys(document.objects)) expandByMesh(box, mirror, id);
  return box;
}

function expandByLight(box: Box3, { lights }: Document, id: string): void {
  const light = lights[id];
  if (!light || !('position' in light)) return;
  const own = new Box3().expandByPoint(new Vector3(...light.position));
  if ('target' in light) own.expandByPoint(new Vector3(...light.target));
  box.union(own.expandByScalar(LIGHT_MARGIN));
}

function expandByMesh(box: Box3, mirror: SceneMirror, id: string): void {
  const mesh = mirror.objectFor(id);
  if (mesh) box.expandByObject(mesh);
}
