import { Box3, type Mesh, type Scene, Vector3, type Vector4 } from 'three/webgpu';

const own = new Box3();
const all = new Box3();
const size = new Vector3();

/**
 * The sphere around all objects, in which the fog is: that of the path tracer. What casts no shadow is no object: the
 * editor's own lines and handles.
 *
 * @param sphere receives centre and radius; 0 where there are no objects
 */
export function boundingSphere(scene: Scene, sphere: Vector4): void {
  all.makeEmpty();
  scene.traverseVisible((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || !mesh.castShadow || !mesh.geometry.hasAttribute('position')) return;
    if (mesh.geometry.boundingBox === null) mesh.geometry.computeBoundingBox();
    all.union(own.copy(mesh.geometry.boundingBox as Box3).applyMatrix4(mesh.matrixWorld));
  });
  if (all.isEmpty()) {
    sphere.set(0, 0, 0, 0);
    return;
  }
  const { x, y, z } = all.getCenter(size);
  sphere.set(x, y, z, all.getSize(size).length() / 2);
}
