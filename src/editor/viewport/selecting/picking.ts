/** What is under a pixel of the picture. */
import { Matrix4, Mesh, Ray, Raycaster, Vector2, type Vector3 } from 'three/webgpu';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { firstHit } from '../meshes/mesh-tree.ts';
import { isSmall, type Meshes, pageMeshes } from '../meshes/meshes.ts';

export interface Picked {
  readonly id: string;
  readonly point: Vector3;
}

/**
 * The visible objects of the document along a ray, the nearest first, each once. Where the ray may meet a large mesh that has no
 * tree yet: a promise of when it is worth asking again.
 */
export function pickAlong(
  mirror: SceneMirror,
  ray: Ray,
  meshes: Meshes = pageMeshes,
): Picked[] | Promise<void> {
  const raycaster = new Raycaster(ray.origin, ray.direction);
  raycaster.camera = mirror.camera;
  const found: (Picked & { readonly distance: number })[] = [];
  let waiting: Promise<void> | null = null;
  mirror.scene.traverse((object) => {
    const id = object.visible && object instanceof Mesh ? mirror.idFor(object) : null;
    if (id === null) return;
    const point = firstOf(object as Mesh, raycaster, meshes);
    if (point instanceof Promise) waiting = point;
    else if (point) found.push({ id, point, distance: point.distanceTo(ray.origin) });
  });
  return waiting ?? found.sort((a, b) => a.distance - b.distance);
}

/** Where a ray first meets a mesh, in the world. */
function firstOf(mesh: Mesh, raycaster: Raycaster, meshes: Meshes): Vector3 | Promise<void> | null {
  const { geometry, matrixWorld } = mesh;
  if (isSmall(geometry)) return raycaster.intersectObject(mesh, false)[0]?.point ?? null;
  const { material } = mesh;
  if (Array.isArray(material)) return null;
  const local = new Ray().copy(raycaster.ray).applyMatrix4(new Matrix4().copy(matrixWorld).invert());
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  if (geometry.boundingSphere && !local.intersectsSphere(geometry.boundingSphere)) return null;
  const tree = meshes.tree(geometry);
  if (tree instanceof Promise) return tree;
  return firstHit(tree, meshes.shape(geometry), local, material.side)?.applyMatrix4(matrixWorld) ?? null;
}

/** Asks for the trees of all large meshes that can be picked, one after another: their triangles are copied while the page waits. */
export async function plantTrees(mirror: SceneMirror, meshes: Meshes = pageMeshes): Promise<void> {
  const large: Mesh[] = [];
  mirror.scene.traverseVisible((object) => {
    if (object instanceof Mesh && !isSmall(object.geometry) && mirror.idFor(object) !== null)
      large.push(object);
  });
  for (const { geometry } of large) await meshes.tree(geometry);
}

/** Into the scene, at normalised device coordinates. */
export function rayAt(mirror: SceneMirror, x: number, y: number): Ray {
  const raycaster = new Raycaster();
  mirror.camera.updateMatrixWorld();
  raycaster.setFromCamera(new Vector2(x, y), mirror.camera);
  return raycaster.ray;
}

/**
 * Hands over what is along a ray: at once if that can be, and else when it is known, unless something has changed since.
 *
 * @param state what must still be the same then
 */
export async function whenPicked(
  mirror: SceneMirror,
  ray: Ray,
  state: () => readonly unknown[],
  use: (picked: Picked[]) => void,
  meshes: Meshes = pageMeshes,
): Promise<void> {
  const before = state();
  let picked = pickAlong(mirror, ray, meshes);
  while (picked instanceof Promise) {
    await picked;
    if (state().some((value, i) => value !== before[i])) return;
    picked = pickAlong(mirror, ray, meshes);
  }
  use(picked);
}
