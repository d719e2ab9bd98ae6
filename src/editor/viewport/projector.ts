/** World space to pixels of the viewport, with lines cut where they pass behind the camera. */
import { type PerspectiveCamera, Vector3 } from 'three/webgpu';

export type Point = readonly [number, number, number];

export interface Pixel {
  x: number;
  y: number;
}

export interface Projector {
  /** Null for what is behind the camera. */
  point(world: Point): Pixel | null;
  segment(a: Point, b: Point): readonly [Pixel, Pixel] | null;
}

export function createProjector(camera: PerspectiveCamera, width: number, height: number): Projector {
  camera.updateMatrixWorld();
  const near = -camera.near;
  const scratch = new Vector3();
  const toView = (world: Point) => new Vector3(...world).applyMatrix4(camera.matrixWorldInverse);
  const toPixel = (view: Vector3): Pixel => {
    scratch.copy(view).applyMatrix4(camera.projectionMatrix);
    return { x: ((scratch.x + 1) / 2) * width, y: ((1 - scratch.y) / 2) * height };
  };
  return {
    point(world) {
      const view = toView(world);
      return view.z > near ? null : toPixel(view);
    },
    segment(a, b) {
      const from = toView(a);
      const to = toView(b);
      if (from.z > near && to.z > near) return null;
      if (from.z > near) from.lerp(to, (from.z - near) / (from.z - to.z));
      else if (to.z > near) to.lerp(from, (to.z - near) / (to.z - from.z));
      return [toPixel(from), toPixel(to)];
    },
  };
}
