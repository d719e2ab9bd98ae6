/** Whether a mesh is within a rectangle of the picture, or touches it. */
import { Matrix4 } from 'three/webgpu';

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

export interface Triangles {
  /** xyz of each vertex. */
  readonly positions: ArrayLike<number>;
  /** Three vertices for each triangle; null if they follow one another. */
  readonly index: ArrayLike<number> | null;
}

/** x, y, w of a corner. */
type Corner = readonly [x: number, y: number, w: number];

/**
 * @param toRectangle from the mesh's own space
 * @param touching whether a part is enough; else all of it must be within
 */
export function isInRectangle(
  { positions, index }: Triangles,
  toRectangle: Matrix4,
  touching: boolean,
): boolean {
  const e = toRectangle.elements;
  const corner = (i: number): Corner => {
    const [x, y, z] = [
      positions[3 * i] as number,
      positions[3 * i + 1] as number,
      positions[3 * i + 2] as number,
    ];
    const row = (r: number) => e[r]! * x + e[r + 4]! * y + e[r + 8]! * z + e[r + 12]!;
    return [row(0), row(1), row(3)];
  };
  const count = index?.length ?? positions.length / 3;
  if (!touching) {
    for (let i = 0; i < count; i++) {
      const [x, y, w] = corner(index ? (index[i] as number) : i);
      if (w <= 0 || Math.abs(x) > w || Math.abs(y) > w) return false;
    }
    return count > 0;
  }
  for (let i = 0; i + 2 < count; i += 3) {
    const triangle = [0, 1, 2].map((k) => corner(index ? (index[i + k] as number) : i + k));
    if (meets(triangle)) return true;
  }
  return false;
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
