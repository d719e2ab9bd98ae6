/** The part of a picture that meshes may cover. */
import { Matrix4, type Mesh, type PerspectiveCamera } from 'three/webgpu';

/** Whole pixels of the canvas, from its upper left corner. */
export interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Holds their bounds with a border around them, as far as it is in the canvas or within that border of it; null if nothing is.
 * Matrices must be up to date.
 */
export function screenBounds(
  meshes: Iterable<Mesh>,
  camera: PerspectiveCamera,
  canvas: { readonly width: number; readonly height: number },
  border: number,
): Rectangle | null {
  const { width, height } = canvas;
  const viewProjection = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const toClip = new Matrix4();
  let [left, top, right, bottom] = [width + border, height + border, -border, -border];
  for (const { geometry, matrixWorld } of meshes) {
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox!;
    const e = toClip.multiplyMatrices(viewProjection, matrixWorld).elements;
    let [behind, before] = [false, false];
    for (let corner = 0; corner < 8; corner++) {
      const x = corner & 1 ? max.x : min.x;
      const y = corner & 2 ? max.y : min.y;
      const z = corner & 4 ? max.z : min.z;
      // In clip space w is the distance along the view.
      const w = e[3] * x + e[7] * y + e[11] * z + e[15];
      if (w < camera.near) {
        behind = true;
        continue;
      }
      before = true;
      const px = ((e[0] * x + e[4] * y + e[8] * z + e[12]) / w + 1) * 0.5 * width;
      const py = (1 - (e[1] * x + e[5] * y + e[9] * z + e[13]) / w) * 0.5 * height;
      left = Math.min(left, Math.floor(px) - border);
      right = Math.max(right, Math.ceil(px) + border);
      top = Math.min(top, Math.floor(py) - border);
      bottom = Math.max(bottom, Math.ceil(py) + border);
    }
    // What reaches past the camera may be anywhere.
    if (behind && before) [left, top, right, bottom] = [-border, -border, width + border, height + border];
  }
  left = Math.max(left, -border);
  top = Math.max(top, -border);
  right = Math.min(right, width + border);
  bottom = Math.min(bottom, height + border);
  return left < right && top < bottom ? { x: left, y: top, width: right - left, height: bottom - top } : null;
}
