/** How much geometry the scene shows, as the thesis's GUI counted it. */
import { type BufferGeometry, InstancedMesh, Mesh, type Object3D } from 'three/webgpu';

export interface SceneCounts {
  vertices: number;
  triangles: number;
}

export function countScene(scene: Object3D): SceneCounts {
  const counts = { vertices: 0, triangles: 0 };
  scene.traverseVisible((object) => {
    if (!(object instanceof Mesh)) return;
    const geometry: BufferGeometry = object.geometry;
    const copies = object instanceof InstancedMesh ? object.count : 1;
    const vertices = geometry.getAttribute('position')?.count ?? 0;
    counts.vertices += vertices * copies;
    counts.triangles += Math.floor((geometry.index?.count ?? vertices) / 3) * copies;
  });
  return counts;
}
