import { Camera, type CoordinateSystem, type Matrix4 } from 'three/webgpu';

/**
 * A camera that maps are drawn with.
 *
 * @param view from its space, in which it looks along -z, to the world's
 */
export function mapCamera(view: Matrix4, projection: Matrix4, coordinateSystem: CoordinateSystem): Camera {
  const camera = new Camera();
  // Else three.js would compute a projection of its own for it.
  camera.coordinateSystem = coordinateSystem;
  camera.matrixAutoUpdate = false;
  camera.matrix.copy(view);
  camera.updateMatrixWorld(true);
  camera.projectionMatrix.copy(projection);
  camera.projectionMatrixInverse.copy(projection).invert();
  return camera;
}
