import { NODE_WIDTH, STACK_ENTRIES } from './layout.ts';
import type { Pace } from './pace.ts';

/**
 * A binary tree over boxes by the surface area heuristic with bins (I. Wald, 2007, "On fast Construction of SAH-based
 * Bounding Volume Hierarchies", IEEE Symposium on Interactive Ray Tracing). It works in slices, on any thread.
 */
export interface BinaryTree {
  /** Number of nodes; node 0 is the root. None where there are no items. */
  readonly nodes: number;
  /** Six floats a node: minimum, maximum. */
  readonly boxes: Float32Array;
  /** Inner node: its first child, which the other one follows. Leaf: its first item in `order`. */
  readonly first: Uint32Array;
  /** Items of a leaf; 0 for inner nodes. */
  readonly count: Uint32Array;
  /** The items, leaf by leaf. */
  readonly order: Uint32Array;
}

const BINS = 16;
/** Nodes with fewer items are handled without looking at the clock, nor waiting for promises. */
const SMALL = 4096;
/**
 * Boxes in geometric progression would be peeled off one by one, and the kernel's stack is as deep as the tree: what
 * gets this deep is halved instead. Nodes of four leave up to three siblings on the stack at each of these levels.
 */
const DEEPEST = Math.floor(STACK_ENTRIES / (NODE_WIDTH - 1));

/** Bounds of boxes and of their centres, which are kept doubled: minimum + maximum. */
class Bounds {
  readonly box = new Float64Array(6);
  readonly centres = new Float64Array(6);

  clear(): void {
    this.box.fill(Number.POSITIVE_INFINITY, 0, 3).fill(Number.NEGATIVE_INFINITY, 3);
    this.centres.fill(Number.POSITIVE_INFINITY, 0, 3).fill(Number.NEGATIVE_INFINITY, 3);
  }

  add(boxes: Float32Array, from: number, to: number): void {
    for (let axis = 0; axis < 3; axis += 1) {
      let [min, max] = [this.box[axis] as number, this.box[axis + 3] as number];
      let [least, most] = [this.centres[axis] as number, this.centres[axis + 3] as number];
      for (let at = 6 * from + axis; at < 6 * to; at += 6) {
        const low = boxes[at] as number;
        const high = boxes[at + 3] as number;
        const centre = low + high;
        if (low < min) min = low;
        if (high > max) max = high;
        if (centre < least) least = centre;
        if (centre > most) most = centre;
      }
      this.box[axis] = min;
      this.box[axis + 3] = max;
      this.centres[axis] = least;
      this.centres[axis + 3] = most;
    }
  }
}

/** Half the surface of a box at `at`; 0 if it is empty. */
export function halfArea(boxes: Float32Array | Float64Array, at = 0): number {
  const x = (boxes[at + 3] as number) - (boxes[at] as number);
  const y = (boxes[at + 4] as number) - (boxes[at + 1] as number);
  const z = (boxes[at + 5] as number) - (boxes[at + 2] as number);
  return x >= 0 ? x * y + y * z + z * x : 0;
}

interface Split {
  readonly axis: number;
  /** Items in a lower bin go to the first child. */
  readonly bin: number;
  readonly origin: number;
  readonly scale: number;
}

/** The bins of the three axes, and what splitting between them would cost. */
class Bins {
  readonly #counts = new Uint32Array(3 * BINS);
  readonly #boxes = new Float64Array(3 * BINS * 6);
  readonly #scale = new Float64Array(3);
  readonly #origin = new Float64Array(3);
  readonly #costs = new Float64Array(BINS);
  /** The bounds of the bins that have been swept. */
  readonly #sweep = new Float64Array(6);
  #bins = BINS;

  /** @param count of items: few need few bins */
  begin(centres: Float64Array, count: number): void {
    this.#bins = Math.min(BINS, 4 + (count >> 1));
    for (let axis = 0; axis < 3; axis += 1) {
      const first = axis * BINS;
      for (let bin = first; bin < first + this.#bins; bin += 1) {
        this.#counts[bin] = 0;
        clear(this.#boxes, 6 * bin);
      }
      const low = centres[axis] as number;
      const extent = (centres[axis + 3] as number) - low;
      this.#origin[axis] = low;
      // Below 1, so that the highest centre falls into the last bin.
      this.#scale[axis] = extent > 0 ? (this.#bins * (1 - 1e-9)) / extent : 0;
    }
  }

  add(boxes: Float32Array, from: number, to: number): void {
    const [ox, oy, oz] = this.#origin as unknown as [number, number, number];
    const [sx, sy, sz] = this.#scale as unknown as [number, number, number];
    const [counts, bins] = [this.#counts, this.#boxes];
    for (let at = 6 * from; at < 6 * to; at += 6) {
      const x0 = boxes[at] as number;
      const y0 = boxes[at + 1] as number;
      const z0 = boxes[at + 2] as number;
      const x1 = boxes[at + 3] as number;
      const y1 = boxes[at + 4] as number;
      const z1 = boxes[at + 5] as number;
      include(counts, bins, binAt(x0 + x1, ox, sx), x0, y0, z0, x1, y1, z1);
      include(counts, bins, BINS + binAt(y0 + y1, oy, sy), x0, y0, z0, x1, y1, z1);
      include(counts, bins, 2 * BINS + binAt(z0 + z1, oz, sz), x0, y0, z0, x1, y1, z1);
    }
  }

  /** The cheapest split, where `leaf` items cost as much as one; null if the centres are all in one place. */
  best(leaf: number): Split | null {
    let [axis, bin] = [-1, 0];
    let least = Number.POSITIVE_INFINITY;
    for (let along = 0; along < 3; along += 1) {
      if (this.#scale[along] === 0) continue;
      let above = 0;
      clear(this.#sweep, 0);
      for (let at = this.#bins - 1; at > 0; at -= 1) {
        above += this.#take(along * BINS + at);
        this.#costs[at] = above > 0 ? halfArea(this.#sweep) * Math.ceil(above / leaf) : -1;
      }
      let below = 0;
      clear(this.#sweep, 0);
      for (let at = 1; at < this.#bins; at += 1) {
        below += this.#take(along * BINS + at - 1);
        const rest = this.#costs[at] as number;
        if (below === 0 || rest < 0) continue;
        const cost = halfArea(this.#sweep) * Math.ceil(below / leaf) + rest;
        if (cost < least) [least, axis, bin] = [cost, along, at];
      }
    }
    if (axis < 0) return null;
    return { axis, bin, origin: this.#origin[axis] as number, scale: this.#scale[axis] as number };
  }

  /** Widens the sweep's box by a bin's. @returns the bin's count */
  #take(bin: number): number {
    const count = this.#counts[bin] as number;
    if (count === 0) return 0;
    const [sweep, bins] = [this.#sweep, this.#boxes];
    const at = 6 * bin;
    if ((bins[at] as number) < (sweep[0] as number)) sweep[0] = bins[at] as number;
    if ((bins[at + 1] as number) < (sweep[1] as number)) sweep[1] = bins[at + 1] as number;
    if ((bins[at + 2] as number) < (sweep[2] as number)) sweep[2] = bins[at + 2] as number;
    if ((bins[at + 3] as number) > (sweep[3] as number)) sweep[3] = bins[at + 3] as number;
    if ((bins[at + 4] as number) > (sweep[4] as number)) sweep[4] = bins[at + 4] as number;
    if ((bins[at + 5] as number) > (sweep[5] as number)) sweep[5] = bins[at + 5] as number;
    return count;
  }
}

/** @param centre doubled */
function binAt(centre: number, origin: number, scale: number): number {
  return ((centre - origin) * scale) | 0;
}

/** Makes a box empty. */
function clear(boxes: Float64Array, at: number): void {
  boxes[at] = Number.POSITIVE_INFINITY;
  boxes[at + 1] = Number.POSITIVE_INFINITY;
  boxes[at + 2] = Number.POSITIVE_INFINITY;
  boxes[at + 3] = Number.NEGATIVE_INFINITY;
  boxes[at + 4] = Number.NEGATIVE_INFINITY;
  boxes[at + 5] = Number.NEGATIVE_INFINITY;
}

/** Adds a box to a bin. Written out: three calls for each item at each level of the tree. */
function include(
  counts: Uint32Array,
  bins: Float64Array,
  bin: number,
  x0: number,
  y0: number,
  z0: number,
  x1: number,
  y1: number,
  z1: number,
): void {
  counts[bin] = (counts[bin] as number) + 1;
  const at = 6 * bin;
  if (x0 < (bins[at] as number)) bins[at] = x0;
  if (y0 < (bins[at + 1] as number)) bins[at + 1] = y0;
  if (z0 < (bins[at + 2] as number)) bins[at + 2] = z0;
  if (x1 > (bins[at + 3] as number)) bins[at + 3] = x1;
  if (y1 > (bins[at + 4] as number)) bins[at + 4] = y1;
  if (z1 > (bins[at + 5] as number)) bins[at + 5] = z1;
}

function swap(boxes: Float32Array, order: Uint32Array, a: number, b: number): void {
  const item = order[a] as number;
  order[a] = order[b] as number;
  order[b] = item;
  for (let i = 0; i < 6; i += 1) {
    const value = boxes[6 * a + i] as number;
    boxes[6 * a + i] = boxes[6 * b + i] as number;
    boxes[6 * b + i] = value;
  }
}

/** Puts the items below a split first. @returns the first one that is not */
function partition(
  boxes: Float32Array,
  order: Uint32Array,
  from: number,
  to: number,
  { axis, bin, origin, scale }: Split,
): number {
  const isBelow = (item: number): boolean =>
    binAt((boxes[6 * item + axis] as number) + (boxes[6 * item + axis + 3] as number), origin, scale) < bin;
  let [low, high] = [from, to - 1];
  for (;;) {
    while (low <= high && isBelow(low)) low += 1;
    while (low <= high && !isBelow(high)) high -= 1;
    if (low >= high) return low;
    swap(boxes, order, low, high);
  }
}

/** Nodes as they are added. */
class Nodes {
  length = 0;
  boxes = new Float32Array(6 * 64);
  first = new Uint32Array(64);
  count = new Uint32Array(64);

  add(): number {
    if (this.length === this.first.length) {
      const grow = <A extends Float32Array | Uint32Array>(old: A, empty: A): A => {
        empty.set(old);
        return empty;
      };
      this.boxes = grow(this.boxes, new Float32Array(2 * this.boxes.length));
      this.first = grow(this.first, new Uint32Array(2 * this.first.length));
      this.count = grow(this.count, new Uint32Array(2 * this.count.length));
    }
    this.length += 1;
    return this.length - 1;
  }
}

/**
 * @param boxes six floats an item: minimum, maximum; put into the order of the leaves
 * @param leaf the most items of a leaf, which cost as much to intersect as one: the kernel takes them together
 * @param onProgress called with the number of items that are in their leaves
 */
export async function buildBinaryTree(
  boxes: Float32Array,
  leaf: number,
  pace: Pace,
  onProgress?: (items: number) => void,
): Promise<BinaryTree> {
  const items = boxes.length / 6;
  const order = new Uint32Array(items);
  for (let i = 0; i < items; i += 1) order[i] = i;
  const nodes = new Nodes();
  if (items === 0) return { nodes: 0, boxes: nodes.boxes, first: nodes.first, count: nodes.count, order };
  const [bounds, bins] = [new Bounds(), new Bins()];
  const levels = (count: number): number => Math.ceil(Math.log2(Math.max(1, count / leaf)));
  let done = 0;

  const pending: [node: number, from: number, to: number, depth: number][] = [[nodes.add(), 0, items, 0]];
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    const [node, from, to, depth] = next;
    const count = to - from;
    bounds.clear();
    if (count <= SMALL) bounds.add(boxes, from, to);
    else await pace.each(from, to, (a, b) => bounds.add(boxes, a, b));
    nodes.boxes.set(bounds.box, 6 * node);
    if (count <= leaf) {
      nodes.first[node] = from;
      nodes.count[node] = count;
      done += count;
      if (pace.due) {
        onProgress?.(done);
        await pace.rest();
      }
      continue;
    }
    bins.begin(bounds.centres, count);
    if (count <= SMALL) bins.add(boxes, from, to);
    else await pace.each(from, to, (a, b) => bins.add(boxes, a, b));
    const split = depth + levels(count) < DEEPEST ? bins.best(leaf) : null;
    // Halves of whole leaves, in whatever order the items are: they are all in one place, or there are too many levels.
    let middle = from + leaf * Math.ceil(count / 2 / leaf);
    if (split !== null) middle = partition(boxes, order, from, to, split);
    const child = nodes.add();
    nodes.add();
    nodes.first[node] = child;
    pending.push([child + 1, middle, to, depth + 1], [child, from, middle, depth + 1]);
  }
  return { nodes: nodes.length, boxes: nodes.boxes, first: nodes.first, count: nodes.count, order };
}
