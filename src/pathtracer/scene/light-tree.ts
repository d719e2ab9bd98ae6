import { LIGHT_NODE_SLOTS, MAX_LIGHT_DEPTH } from './layout.ts';
import { groupCost, type LightBounds, uniteLights } from './light-bounds.ts';
import type { Pace } from './pace.ts';
import type { Words } from './words.ts';

export interface TreeLight {
  /** The light's number. */
  readonly light: number;
  readonly bounds: LightBounds;
}

/** As in pbrt-v4's BVHLightSampler, section 12.6.3 of "Physically Based Rendering". */
const BUCKETS = 12;
/** Where there are more, only the longest axis is tried. */
const MANY = 512;

const centre = ({ bounds: { box } }: TreeLight, axis: number): number => (box[axis]! + box[axis + 3]!) / 2;

interface Range {
  readonly from: number;
  readonly to: number;
  readonly depth: number;
  readonly trail: number;
  readonly slot: number;
}

/**
 * Writes the tree.
 *
 * @param lights are put into the order of the leaves
 * @param setTrail gets each light's number and the path to it: bit d is set where child 1 is taken at depth d
 * @returns the root's slot, 0 if there are no lights
 */
export async function writeLightTree(
  words: Words,
  lights: TreeLight[],
  pace: Pace,
  setTrail: (light: number, trail: number) => void,
): Promise<number> {
  if (lights.length === 0) return 0;
  const root = words.allocate(LIGHT_NODE_SLOTS);
  const pending: Range[] = [{ from: 0, to: lights.length, depth: 0, trail: 0, slot: root }];
  for (let range = pending.pop(); range !== undefined; range = pending.pop()) {
    if (pace.due) await pace.rest();
    const { from, to, depth, trail, slot } = range;
    let bounds: LightBounds | null = null;
    for (let i = from; i < to; i += 1) bounds = uniteLights(bounds, lights[i]!.bounds);
    const group = bounds as LightBounds;
    writeBounds(words, slot, group);
    if (to - from === 1) {
      const { light } = lights[from] as TreeLight;
      words.setUints(slot + 3, light, 0, 1, Number(group.twoSided));
      setTrail(light, trail);
      continue;
    }
    const middle = split(lights, range, group);
    const children = words.allocate(2 * LIGHT_NODE_SLOTS);
    const [first, second] = [children, children + LIGHT_NODE_SLOTS];
    words.setUints(slot + 3, first, second, 0, Number(group.twoSided));
    pending.push(
      { from: middle, to, depth: depth + 1, trail: (trail | (1 << depth)) >>> 0, slot: second },
      { from, to: middle, depth: depth + 1, trail, slot: first },
    );
  }
  return root;
}

function writeBounds(words: Words, slot: number, { box, axis, ...bounds }: LightBounds): void {
  words.setFloats(slot, ...box.slice(0, 3), bounds.power);
  words.setFloats(slot + 1, ...box.slice(3), bounds.cosNormals);
  words.setFloats(slot + 2, ...axis, bounds.cosEmission);
}

/** Parts a range in two; returns where. */
function split(lights: TreeLight[], { from, to, depth }: Range, { box }: LightBounds): number {
  const count = to - from;
  const [low, high] = [
    [0, 1, 2].map(() => Number.POSITIVE_INFINITY),
    [0, 1, 2].map(() => Number.NEGATIVE_INFINITY),
  ];
  for (let i = from; i < to; i += 1)
    for (let axis = 0; axis < 3; axis += 1) {
      const c = centre(lights[i] as TreeLight, axis);
      low[axis] = Math.min(low[axis]!, c);
      high[axis] = Math.max(high[axis]!, c);
    }
  const extents = [0, 1, 2].map((axis) => high[axis]! - low[axis]!);
  const longest = extents.indexOf(Math.max(...extents));
  const half = from + (count >> 1);
  // The levels that are left just suffice for halves.
  const mustHalve = depth + Math.ceil(Math.log2(count)) >= MAX_LIGHT_DEPTH;
  const best = mustHalve ? null : cheapest(lights, from, to, box, low, extents, longest);
  if (best === null) {
    const sorted = lights.slice(from, to).sort((a, b) => centre(a, longest) - centre(b, longest));
    for (const [i, light] of sorted.entries()) lights[from + i] = light;
    return half;
  }
  let middle = from;
  for (let i = from; i < to; i += 1) {
    const light = lights[i] as TreeLight;
    if (bucketOf(light, best.axis, low, extents) > best.bucket) continue;
    lights[i] = lights[middle] as TreeLight;
    lights[middle] = light;
    middle += 1;
  }
  return middle;
}

function bucketOf(
  light: TreeLight,
  axis: number,
  low: readonly number[],
  extents: readonly number[],
): number {
  const part = (centre(light, axis) - low[axis]!) / extents[axis]!;
  return Math.min(Math.floor(part * BUCKETS), BUCKETS - 1);
}

/** The split of least cost; null if none is better than another, as where all lights are points on a line. */
function cheapest(
  lights: readonly TreeLight[],
  from: number,
  to: number,
  box: readonly number[],
  low: readonly number[],
  extents: readonly number[],
  longest: number,
): { axis: number; bucket: number } | null {
  let best: { axis: number; bucket: number } | null = null;
  let least = Number.POSITIVE_INFINITY;
  const sides = [0, 1, 2].map((axis) => box[axis + 3]! - box[axis]!);
  for (const axis of to - from > MANY ? [longest] : [0, 1, 2]) {
    if (!(extents[axis]! > 0)) continue;
    const buckets: (LightBounds | null)[] = Array.from({ length: BUCKETS }, () => null);
    for (let i = from; i < to; i += 1) {
      const light = lights[i] as TreeLight;
      const bucket = bucketOf(light, axis, low, extents);
      buckets[bucket] = uniteLights(buckets[bucket]!, light.bounds);
    }
    const elongation = Math.max(...sides) / sides[axis]!;
    const above: number[] = [];
    let group: LightBounds | null = null;
    for (let bucket = BUCKETS - 1; bucket > 0; bucket -= 1) {
      group = uniteLights(group, buckets[bucket]!);
      above[bucket] = group === null ? 0 : groupCost(group, elongation);
    }
    group = null;
    for (let bucket = 0; bucket < BUCKETS - 1; bucket += 1) {
      group = uniteLights(group, buckets[bucket]!);
      const cost = (group === null ? 0 : groupCost(group, elongation)) + above[bucket + 1]!;
      if (!(cost > 0 && cost < least)) continue;
      least = cost;
      best = { axis, bucket };
    }
  }
  return best;
}
