/** Reads a packed scene as docs/decisions/path-tracer.md describes it, in numbers of its own: a check of the packer. */
import type { PackedScene } from '../../../src/pathtracer/scene/pack.ts';

export type Vector = [number, number, number];
export type Four = [number, number, number, number];

export interface Hit {
  distance: number;
  instance: number;
  triangle: number;
}

const NONE = 0xffffffff;
const LEAF = 0x80000000;

const dot = (a: readonly number[], b: readonly number[]): number =>
  a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
const minus = (a: readonly number[], b: readonly number[]): Vector => [
  a[0]! - b[0]!,
  a[1]! - b[1]!,
  a[2]! - b[2]!,
];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export class Reader {
  readonly uints: Uint32Array;
  readonly floats: Float32Array;

  constructor({ words }: Pick<PackedScene, 'words'>) {
    this.uints = words;
    this.floats = new Float32Array(words.buffer);
  }

  uint4 = (slot: number): Four => [...this.uints.subarray(4 * slot, 4 * slot + 4)] as Four;
  float4 = (slot: number): Four => [...this.floats.subarray(4 * slot, 4 * slot + 4)] as Four;

  get instances(): number {
    return this.uint4(0)[3];
  }

  /** The slot of an instance, a light, ... */
  instance = (i: number): number => this.uint4(0)[1] + 8 * i;
  light = (i: number): number => this.uint4(1)[0] + 6 * i;
  infiniteLight = (i: number): number => this.uint4(2)[0] + 6 * i;
  material = (i: number): number => this.uint4(0)[2] + 5 * i;

  transform(rows: number, p: readonly number[], w: number): Vector {
    return [0, 1, 2].map((row) => {
      const r = this.float4(rows + row);
      return dot(r, p) + r[3] * w;
    }) as Vector;
  }

  /** The nearest hit of the ray; null if there is none. */
  trace(origin: Vector, direction: Vector): Hit | null {
    let best: Hit | null = null;
    this.walk(this.uint4(0)[0], origin, direction, (instance) => {
      const slot = this.instance(instance);
      const o = this.transform(slot, origin, 1);
      const d = this.transform(slot, direction, 0);
      const [mesh] = this.uint4(slot + 6);
      this.walk(this.uint4(mesh)[0], o, d, (block) => {
        for (let lane = 0; lane < 4; lane += 1) {
          const triangle = this.uint4(block + 9)[lane] as number;
          const corner = (i: number): Vector =>
            [0, 1, 2].map((k) => this.float4(block + 3 * i + k)[lane]) as Vector;
          if (triangle === NONE) continue;
          const distance = intersect(o, d, corner(0), corner(1), corner(2));
          if (distance !== null && distance < (best?.distance ?? Number.POSITIVE_INFINITY))
            best = { distance, instance, triangle };
        }
      });
    });
    return best;
  }

  /** Calls `leaf` with what the leaves that a ray meets refer to. */
  private walk(node: number, o: Vector, d: Vector, leaf: (reference: number) => void): void {
    const bounds = [0, 1, 2, 3, 4, 5].map((i) => this.float4(node + i));
    const children = this.uint4(node + 6);
    for (let lane = 0; lane < 4; lane += 1) {
      if (children[lane] === NONE) {
        if (bounds[0]![lane] !== Number.POSITIVE_INFINITY || bounds[1]![lane] !== Number.NEGATIVE_INFINITY)
          throw new Error('an empty child has bounds');
        continue;
      }
      let [enter, leave] = [0, Number.POSITIVE_INFINITY];
      for (let axis = 0; axis < 3; axis += 1) {
        const inverse = 1 / (Math.abs(d[axis]!) > 1e-20 ? d[axis]! : 1e-20);
        const a = (bounds[2 * axis]![lane]! - o[axis]!) * inverse;
        const b = (bounds[2 * axis + 1]![lane]! - o[axis]!) * inverse;
        enter = Math.max(enter, Math.min(a, b));
        leave = Math.min(leave, Math.max(a, b) * (1 + 1e-6));
      }
      if (enter > leave) continue;
      const child = children[lane] as number;
      if (child >= LEAF) leaf(child - LEAF);
      else this.walk(child, o, d, leaf);
    }
  }

  /** Every leaf of the tree of lights: the light's number, and the path to it. */
  lightLeaves(
    node = this.uint4(1)[1],
    trail = 0,
    depth = 0,
  ): { light: number; trail: number; depth: number }[] {
    if (node === 0) return [];
    const [a, b, isLeaf] = this.uint4(node + 3);
    if (isLeaf === 1) return [{ light: a, trail, depth }];
    return [
      ...this.lightLeaves(a, trail, depth + 1),
      ...this.lightLeaves(b, (trail | (1 << depth)) >>> 0, depth + 1),
    ];
  }

  /** The probability that the tree chooses each light for a point: "Physically Based Rendering", section 12.6.3. */
  lightProbabilities(p: Vector, node = this.uint4(1)[1], probability = 1): Map<number, number> {
    const [a, b, isLeaf] = this.uint4(node + 3);
    if (isLeaf === 1) return new Map([[a, probability]]);
    const importances = [this.importance(a, p), this.importance(b, p)] as const;
    const sum = importances[0] + importances[1];
    if (sum === 0) return new Map();
    return new Map(
      [a, b].flatMap((child, i) =>
        importances[i]! > 0
          ? [...this.lightProbabilities(p, child, (probability * importances[i]!) / sum)]
          : [],
      ),
    );
  }

  importance(node: number, p: Vector): number {
    const [low, high, axis] = [this.float4(node), this.float4(node + 1), this.float4(node + 2)];
    const centre = [0, 1, 2].map((i) => (low[i]! + high[i]!) / 2);
    const radius = Math.hypot(...minus(high, low)) / 2;
    const away = minus(p, centre);
    const distance = Math.hypot(...away);
    let cosine = distance > 0 ? dot(away, axis) / distance : 1;
    if (this.uint4(node + 3)[3] === 1) cosine = Math.abs(cosine);
    const angle = Math.acos(Math.min(Math.max(cosine, -1), 1));
    const subtended = distance > radius ? Math.asin(radius / distance) : Math.PI;
    const least = Math.max(0, angle - Math.acos(Math.max(high[3], -1)) - subtended);
    if (Math.cos(least) <= axis[3]) return 0;
    return (low[3] * Math.cos(least)) / Math.max(distance ** 2, radius, 1e-12);
  }
}

/** T. Moeller and B. Trumbore, 1997. */
export function intersect(o: Vector, d: Vector, a: Vector, b: Vector, c: Vector): number | null {
  const [e1, e2] = [minus(b, a), minus(c, a)];
  const p = cross(d, e2);
  const determinant = dot(e1, p);
  if (determinant === 0) return null;
  const s = minus(o, a);
  const u = dot(s, p) / determinant;
  const q = cross(s, e1);
  const v = dot(d, q) / determinant;
  const t = dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : null;
}

/** Numbers in 0..1 that are the same each time. */
export function sequence(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export function unitVector(random: () => number): Vector {
  const z = 2 * random() - 1;
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}
