/** The edges of a mesh, found once: corners at the same place are one, whatever normals they have. */

export interface MeshEdges {
  /** xyz of each corner, each place once. */
  readonly points: Float32Array;
  /** Three corners of each triangle. */
  readonly corners: Uint32Array;
  /** Of each triangle: normal (of any length) and offset. A point p is on its front where n·p > offset. */
  readonly planes: Float32Array;
  /** The lower and the higher corner of each edge. */
  readonly edges: Uint32Array;
  /** The edge of each side of each triangle, from its k-th corner to the next; NONE where both are one. */
  readonly sides: Uint32Array;
}

export const NONE = 0xffffffff;

export function meshEdges(positions: ArrayLike<number>, index: ArrayLike<number> | null): MeshEdges {
  const { points, ids } = welded(positions);
  const count = Math.floor((index?.length ?? ids.length) / 3);
  const corners = new Uint32Array(3 * count);
  for (let i = 0; i < corners.length; i++) corners[i] = ids[index ? (index[i] as number) : i] as number;
  const sides = new Uint32Array(3 * count);
  const found = new Uint32Array(6 * count);
  const table = new PairTable(3 * count);
  for (let i = 0; i < sides.length; i++) {
    const a = corners[i] as number;
    const b = corners[i % 3 === 2 ? i - 2 : i + 1] as number;
    if (a === b) {
      sides[i] = NONE;
      continue;
    }
    const [low, high] = a < b ? [a, b] : [b, a];
    const edge = table.idOf(low, high);
    sides[i] = edge;
    found[2 * edge] = low;
    found[2 * edge + 1] = high;
  }
  return { points, corners, planes: planesOf(points, corners), edges: found.slice(0, 2 * table.size), sides };
}

function planesOf(points: Float32Array, corners: Uint32Array): Float32Array {
  const planes = new Float32Array((corners.length / 3) * 4);
  const at = (i: number, axis: number) => points[3 * (corners[i] as number) + axis] as number;
  for (let i = 0, k = 0; i < corners.length; i += 3, k += 4) {
    const [ax, ay, az] = [at(i, 0), at(i, 1), at(i, 2)];
    const [ux, uy, uz] = [at(i + 1, 0) - ax, at(i + 1, 1) - ay, at(i + 1, 2) - az];
    const [vx, vy, vz] = [at(i + 2, 0) - ax, at(i + 2, 1) - ay, at(i + 2, 2) - az];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    planes[k] = nx;
    planes[k + 1] = ny;
    planes[k + 2] = nz;
    planes[k + 3] = nx * ax + ny * ay + nz * az;
  }
  return planes;
}

/** Corners at the very same place get one number. */
function welded(positions: ArrayLike<number>): { points: Float32Array; ids: Uint32Array } {
  // Adding 0 makes -0 the 0 that it equals.
  const values = Float32Array.from(positions, (x) => x + 0);
  const bits = new Uint32Array(values.buffer);
  const count = Math.floor(values.length / 3);
  const ids = new Uint32Array(count);
  const points = new Float32Array(3 * count);
  const size = tableSize(count);
  const table = new Uint32Array(size).fill(NONE);
  let used = 0;
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [bits[3 * i] as number, bits[3 * i + 1] as number, bits[3 * i + 2] as number];
    let slot = hash(hash(x, y), z) & (size - 1);
    for (;;) {
      const other = table[slot] as number;
      if (other === NONE) {
        table[slot] = used;
        points.set(values.subarray(3 * i, 3 * i + 3), 3 * used);
        ids[i] = used;
        used += 1;
        break;
      }
      const at = 3 * other;
      if (
        points[at] === values[3 * i] &&
        points[at + 1] === values[3 * i + 1] &&
        points[at + 2] === values[3 * i + 2]
      ) {
        ids[i] = other;
        break;
      }
      slot = (slot + 1) & (size - 1);
    }
  }
  return { points: points.slice(0, 3 * used), ids };
}

/** Numbers pairs in the order in which they come. */
class PairTable {
  readonly #slots: Uint32Array;
  readonly #pairs: Uint32Array;
  size = 0;

  constructor(capacity: number) {
    this.#slots = new Uint32Array(tableSize(capacity)).fill(NONE);
    this.#pairs = new Uint32Array(2 * capacity);
  }

  idOf(a: number, b: number): number {
    const mask = this.#slots.length - 1;
    let slot = hash(a, b) & mask;
    for (;;) {
      const id = this.#slots[slot] as number;
      if (id === NONE) {
        this.#slots[slot] = this.size;
        this.#pairs[2 * this.size] = a;
        this.#pairs[2 * this.size + 1] = b;
        this.size += 1;
        return this.size - 1;
      }
      if (this.#pairs[2 * id] === a && this.#pairs[2 * id + 1] === b) return id;
      slot = (slot + 1) & mask;
    }
  }
}

/** A power of two at least twice as large as what is put in. */
const tableSize = (count: number): number => 2 ** Math.ceil(Math.log2(Math.max(2, 2 * count)));

/** Multiplies by odd constants and folds the high bits down, as the finaliser of MurmurHash3 (Appleby, 2011). */
function hash(a: number, b: number): number {
  let h = Math.imul(a ^ Math.imul(b, 0x9e3779b1), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}
