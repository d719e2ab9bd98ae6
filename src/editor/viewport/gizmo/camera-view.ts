/** The camera of the picture as a gizmo needs it. */
import { type PerspectiveCamera, Raycaster, Vector2, type Vector3 } from 'three/webgpu';
import { createProjector } from '../projector.ts';
import type { Pointer } from './drag.ts';
import type { GizmoView } from './handles.ts';

/** @param width @param height CSS pixels of the viewport */
export function gizmoView(
  camera: PerspectiveCamera,
  width: number,
  height: number,
  pivot: Vector3,
): GizmoView {
  const projector = createProjector(camera, width, height);
  const depth = -pivot.clone().applyMatrix4(camera.matrixWorldInverse).z;
  return {
    eye: camera.position,
    project: ({ x, y, z }) => projector.point([x, y, z]),
    pixel: (2 * depth * Math.tan((camera.fov * Math.PI) / 360)) / height,
  };
}

export function pointerRay(
  camera: PerspectiveCamera,
  canvas: HTMLElement,
  event: { readonly clientX: number; readonly clientY: number },
): Pointer {
  const box = canvas.getBoundingClientRect();
  const at = { x: event.clientX - box.left, y: event.clientY - box.top };
  camera.updateMatrixWorld();
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2((at.x / box.width) * 2 - 1, 1 - (at.y / box.height) * 2), camera);
  return { at, ray: raycaster.ray };
}
