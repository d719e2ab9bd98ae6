/** Whether a mesh is within a rectangle of the picture, or touches it. */
import { Matrix4 } from 'three/webgpu';
import type { MeshTree } from '../meshes/mesh-tree.ts';
import { type Shape, vertexOf } from '../meshes/shape.ts';

/** In normalised device coordinates: -1..1, y up. */
export interface Rectangle {
  readonly left: number;
  readonly right: number;
  readonly bottom: number;
  readonly top: number;
}

/** World to a clip space whose picture is the rectangle alone: within it, |x| and |y| are at most w. */
export function rectangleProjection(
  viewProjection: Matrix4,
  { left, right, bottom, top }: Rectangle,
): Matrix4 {
  const [width, height] = [Math.max(right - left, 1e-9), Math.max(top - bottom, 1e-9)];
  return new Matrix4()
    .set(
      2 / width,
      0,
      0,
      -(left + right) / width,
      0,
      2 / height,
      0,
      -(bottom + top) / height,
      0,
      0,
      1,
      0,
      0,
      0,
      0,
      1,
    )
    .multiply(viewProjection);
}

/** x, y, w of a corner. */
type Corner = readonly [x: number, y: number, w: number];

/** @param e the elements of a matrix */
function project(e: readonly number[], x: number, y: number, z: number): Corner {
  const row = (r: number) => e[r]! * x + e[r + 4]! * y + e[r + 8]! * z + e[r + 12]!;
  return [row(0), row(1), row(3)];
}

/**
 * @param toRectangle from the mesh's own space
 * @param touching whether a part is enough; else all of it must be within
 * @param tree of the same triangles: what is wholly inside or outside need then not be looked at
 */
export function isInRectangle(
  shape: Shape,
  toRectangle: Matrix4,
  touching: boolean,
  tree: MeshTree | null = null,
): boolean {
  const { positions, index } = shape;
  const corner = (i: number): Corner => {
    const at = 3 * vertexOf(shape, i);
    return project(toRectangle.elements, positions[at]!, positions[at + 1]!, positions[at + 2]!);
  };
  const corners = (triangle: number) => [0, 1, 2].map((k) => corner(3 * triangle + k));
  const answerOf = (triangle: number) =>
    touching ? meets(corners(triangle)) : corners(triangle).every(isWithin);
  if (tree) return isTreeIn(tree, toRectangle, touching, answerOf);
  const count = Math.floor((index?.length ?? positions.length / 3) / 3);
  for (let triangle = 0; triangle < count; triangle++) if (answerOf(triangle) === touching) return touching;
  return !touching && count > 0;
}

const isWithin = ([x, y, w]: Corner): boolean => w > 0 && Math.abs(x) <= w && Math.abs(y) <= w;

/** All of it in the picture's rectangle, none of it, or not to be said from a box. */
export type Place = 'inside' | 'outside' | 'across';

/** Where a box is: minimum and maximum, six numbers from `at` on. An empty one is outside. */
export function placeOf(boxes: ArrayLike<number>, at: number, toRectangle: Matrix4): Place {
  if (!(boxes[at]! <= boxes[at + 3]!)) return 'outside';
  const corners = Array.from({ length: 8 }, (_, k) =>
    project(
      toRectangle.elements,
      boxes[at + 3 * (k & 1)]!,
      boxes[at + 1 + 3 * ((k >> 1) & 1)]!,
      boxes[at + 2 + 3 * (k >> 2)]!,
    ),
  );
  if (corners.every((corner) => PLANES.every((plane) => plane(corner) >= 0))) return 'inside';
  return PLANES.some((plane) => corners.every((corner) => plane(corner) < 0)) ? 'outside' : 'across';
}

/** Looks only into those boxes that the rectangle's edges go through. */
function isTreeIn(
  { boxes, first, count, triangles }: MeshTree,
  toRectangle: Matrix4,
  touching: boolean,
  answerOf: (triangle: number) => boolean,
): boolean {
  const pending = count.length > 0 ? [0] : [];
  for (let node = pending.pop(); node !== undefined; node = pending.pop()) {
    const place = placeOf(boxes, 6 * node, toRectangle);
    if (place !== 'across') {
      if ((place === 'inside') === touching) return touching;
      continue;
    }
    const child = first[node] as number;
    const leaf = count[node] as number;
    if (leaf === 0) pending.push(child, child + 1);
    for (let i = child; i < child + leaf; i++)
      if (answerOf(triangles[i] as number) === touching) return touching;
  }
  return !touching && count.length > 0;
}

/** Positive on the side of a plane that counts: before the eye, and within each edge of the rectangle. */
const PLANES: readonly ((corner: Corner) => number)[] = [
  ([, , w]) => w - 1e-9,
  ([x, , w]) => w + x,
  ([x, , w]) => w - x,
  ([, y, w]) => w + y,
  ([, y, w]) => w - y,
];

/** Cuts a polygon by each plane in turn (Sutherland and Hodgman, 1974): something is left, or nothing. */
function meets(triangle: readonly Corner[]): boolean {
  let polygon = triangle;
  for (const side of PLANES) {
    const distances = polygon.map(side);
    if (distances.every((d) => d < 0)) return false;
    if (distances.every((d) => d >= 0)) continue;
    polygon = polygon.flatMap((a, i) => {
      const next = (i + 1) % polygon.length;
      const b = polygon[next] as Corner;
      const [da, db] = [distances[i] as number, distances[next] as number];
      const kept: Corner[] = da >= 0 ? [a] : [];
      if (da >= 0 !== db >= 0) {
        const t = da / (da - db);
        kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])]);
      }
      return kept;
    });
  }
  return polygon.length > 0;
}
