/** A tree of a mesh's triangles, for what a hand asks of it: what a ray meets first. */
import { BackSide, FrontSide, type Ray, type Side, Vector3 } from 'three/webgpu';
import { type BinaryTree, buildBinaryTree } from '../../../pathtracer/scene/binary-tree.ts';
import type { Pace } from '../../../pathtracer/scene/pace.ts';
import { type Shape, vertexOf } from './shape.ts';

/** As BinaryTree, with the triangles in place of its items. */
export interface MeshTree extends Pick<BinaryTree, 'boxes' | 'first' | 'count'> {
  /** Leaf by leaf. */
  readonly triangles: Uint32Array;
}

/** Triangles of a leaf at most. */
const LEAF = 4;

export async function buildMeshTree(shape: Shape, pace: Pace): Promise<MeshTree> {
  const { positions, index } = shape;
  const count = Math.floor((index?.length ?? positions.length / 3) / 3);
  const boxes = new Float32Array(6 * count);
  const numbers = new Uint32Array(count);
  let items = 0;
  for (let triangle = 0; triangle < count; triangle++) {
    const at = 6 * items;
    let isWhole = true;
    for (let axis = 0; axis < 3; axis++) {
      const a = positions[3 * vertexOf(shape, 3 * triangle) + axis] as number;
      const b = positions[3 * vertexOf(shape, 3 * triangle + 1) + axis] as number;
      const c = positions[3 * vertexOf(shape, 3 * triangle + 2) + axis] as number;
      boxes[at + axis] = Math.min(a, b, c);
      boxes[at + 3 + axis] = Math.max(a, b, c);
      // What has no place is not met.
      isWhole &&= Number.isFinite(a + b + c);
    }
    if (isWhole) numbers[items++] = triangle;
  }
  const tree = await buildBinaryTree(boxes.subarray(0, 6 * items), LEAF, pace);
  return {
    boxes: tree.boxes.slice(0, 6 * tree.nodes),
    first: tree.first.slice(0, tree.nodes),
    count: tree.count.slice(0, tree.nodes),
    triangles: tree.order.map((item) => numbers[item] as number),
  };
}

/**
 * The place where a ray first meets a mesh, as three.js finds it by looking at every triangle.
 *
 * @param ray in the mesh's own space
 */
export function firstHit(tree: MeshTree, shape: Shape, ray: Ray, side: Side): Vector3 | null {
  const { boxes, first, count, triangles } = tree;
  const [a, b, c, hit] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  let found: Vector3 | null = null;
  let nearest = Number.POSITIVE_INFINITY;
  const entry = (node: number) => entryOf(boxes, 6 * node, ray);
  const pending: [node: number, entry: number][] = count.length > 0 ? [[0, entry(0)]] : [];
  for (let next = pending.pop(); next; next = pending.pop()) {
    const [node, distance] = next;
    if (distance > nearest) continue;
    const child = first[node] as number;
    const leaf = count[node] as number;
    for (let i = child; i < child + leaf; i++) {
      const corner = 3 * (triangles[i] as number);
      a.fromArray(shape.positions, 3 * vertexOf(shape, corner));
      b.fromArray(shape.positions, 3 * vertexOf(shape, corner + 1));
      c.fromArray(shape.positions, 3 * vertexOf(shape, corner + 2));
      if (!intersect(ray, a, b, c, side, hit)) continue;
      const along = hit.distanceTo(ray.origin);
      if (along >= nearest) continue;
      nearest = along;
      found = (found ?? new Vector3()).copy(hit);
    }
    if (leaf > 0) continue;
    const [near, far] = [entry(child), entry(child + 1)];
    // The nearer one on top.
    const children: [number, number][] = [
      [child, near],
      [child + 1, far],
    ];
    if (near < far) children.reverse();
    for (const each of children) if (each[1] < Number.POSITIVE_INFINITY) pending.push(each);
  }
  return found;
}

function intersect(ray: Ray, a: Vector3, b: Vector3, c: Vector3, side: Side, hit: Vector3): boolean {
  if (side === BackSide) return ray.intersectTriangle(c, b, a, true, hit) !== null;
  return ray.intersectTriangle(a, b, c, side === FrontSide, hit) !== null;
}

/** By this part a box is larger than its floats say: what a ray grazes is looked at. */
const MARGIN = 1e-6;

/** How far along a ray a box begins; 0 from within, infinite where the ray passes it. */
function entryOf(boxes: Float32Array, at: number, { origin, direction }: Ray): number {
  let [near, far] = [0, Number.POSITIVE_INFINITY];
  for (let axis = 0; axis < 3; axis++) {
    const [low, high] = [boxes[at + axis] as number, boxes[at + 3 + axis] as number];
    const slack = MARGIN * Math.max(Math.abs(low), Math.abs(high), Math.abs(origin.getComponent(axis)));
    const speed = direction.getComponent(axis);
    const from = low - slack - origin.getComponent(axis);
    const to = high + slack - origin.getComponent(axis);
    if (speed === 0) {
      if (from > 0 || to < 0) return Number.POSITIVE_INFINITY;
      continue;
    }
    near = Math.max(near, Math.min(from / speed, to / speed));
    far = Math.min(far, Math.max(from / speed, to / speed));
  }
  return near <= far ? near : Number.POSITIVE_INFINITY;
}
