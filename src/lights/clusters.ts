/**
 * Which of many lamps may reach which part of the view: the camera's pyramid in parts by screen tiles and distance, each with a
 * list (O. Olsson et al., 2012, "Clustered Deferred and Forward Shading", HPG). Lists are exact from the safe side: a lamp is
 * in each part that it reaches, and may be in a few that it does not. A lamp without a range reaches everywhere.
 */
import { MathUtils, type Matrix4, Vector3 } from 'three/webgpu';

export const COLUMNS = 16;
export const ROWS = 9;
export const SLICES = 16;
const CLUSTERS = COLUMNS * ROWS * SLICES;
/** A lamp that is in more parts than this is in one list for all of them. */
const MANY = CLUSTERS / 4;

/** The sphere around what a lamp lights, in view space; null of what has no end. */
export interface Reach {
  readonly centre: Vector3;
  readonly radius: number;
}

/** The part of the pyramid that a depth is in: parts grow with the distance. */
export const sliceScale = (near: number, far: number): number => SLICES / Math.log(far / near);

export class Clusters {
  /** Lamps' numbers: those of all parts first, then those of each part. */
  readonly entries: Float32Array;
  /** For each part, the first of its entries and how many they are. */
  readonly ranges = new Float32Array(2 * CLUSTERS);
  /** How many lamps are everywhere. */
  common = 0;
  /** How many entries are in use. */
  used = 0;
  readonly #counts = new Uint32Array(CLUSTERS);
  readonly #boxes: Int32Array[] = [];

  /** @param capacity of the list; lamps that do not fit in are everywhere */
  constructor(capacity: number) {
    this.entries = new Float32Array(capacity);
  }

  /** @param projection of a perspective camera, with its depths */
  fill(reaches: readonly (Reach | null)[], projection: Matrix4, near: number, far: number): void {
    const counts = this.#counts.fill(0);
    let free = this.entries.length - reaches.length;
    this.common = 0;
    const parts: { lamp: number; box: Int32Array }[] = [];
    for (const [lamp, reach] of reaches.entries()) {
      this.#boxes[lamp] ??= new Int32Array(6);
      const box = reach && clusterBox(reach, projection, near, far, this.#boxes[lamp] as Int32Array);
      const size = box ? (box[1]! - box[0]!) * (box[3]! - box[2]!) * (box[5]! - box[4]!) : MANY + 1;
      if (box === null || size > MANY || size > free) {
        this.entries[this.common++] = lamp;
        continue;
      }
      free -= size;
      parts.push({ lamp, box });
      eachCluster(box, (cluster) => counts[cluster]!++);
    }
    let next = this.common;
    for (let cluster = 0; cluster < CLUSTERS; cluster++) {
      this.ranges[2 * cluster] = next;
      this.ranges[2 * cluster + 1] = 0;
      next += counts[cluster]!;
    }
    this.used = next;
    for (const { lamp, box } of parts) {
      eachCluster(box, (cluster) => {
        const at = this.ranges[2 * cluster]! + this.ranges[2 * cluster + 1]!++;
        this.entries[at] = lamp;
      });
    }
  }
}

function eachCluster(box: Int32Array, visit: (cluster: number) => void): void {
  for (let z = box[4]!; z < box[5]!; z++)
    for (let y = box[2]!; y < box[3]!; y++)
      for (let x = box[0]!; x < box[1]!; x++) visit((z * ROWS + y) * COLUMNS + x);
}

const corner = new Vector3();

/** From (included) and to (excluded) along x, y and z; empty where the sphere is out of view. */
function clusterBox(
  { centre, radius }: Reach,
  projection: Matrix4,
  near: number,
  far: number,
  box: Int32Array,
): Int32Array {
  const [nearest, farthest] = [-centre.z - radius, -centre.z + radius];
  box.fill(0);
  if (farthest < near || nearest > far) return box;
  const scale = sliceScale(near, far);
  const slice = (depth: number) => Math.floor(Math.log(Math.max(depth, near) / near) * scale);
  box[4] = MathUtils.clamp(slice(nearest), 0, SLICES - 1);
  box[5] = MathUtils.clamp(slice(farthest) + 1, 1, SLICES);
  let [left, right, bottom, top] = [-1, 1, -1, 1];
  if (nearest > near) {
    // The corners of the box around the sphere lie around it on the screen, too.
    [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < 8; i++) {
      const sign = (bit: number) => (i & bit ? radius : -radius);
      corner.set(centre.x + sign(1), centre.y + sign(2), centre.z + sign(4)).applyMatrix4(projection);
      [left, right] = [Math.min(left, corner.x), Math.max(right, corner.x)];
      [bottom, top] = [Math.min(bottom, corner.y), Math.max(top, corner.y)];
    }
  }
  const tile = (ndc: number, count: number) => Math.floor((ndc * 0.5 + 0.5) * count);
  box[0] = MathUtils.clamp(tile(left, COLUMNS), 0, COLUMNS);
  box[1] = MathUtils.clamp(tile(right, COLUMNS) + 1, 0, COLUMNS);
  box[2] = MathUtils.clamp(tile(bottom, ROWS), 0, ROWS);
  box[3] = MathUtils.clamp(tile(top, ROWS) + 1, 0, ROWS);
  if (box[1] <= box[0] || box[3] <= box[2]) box.fill(0);
  return box;
}
