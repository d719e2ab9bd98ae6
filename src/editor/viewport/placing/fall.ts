/**
 * How far something falls straight down until it touches what is below. Seen from above, every triangle of what falls
 * overlaps some of what is below in convex polygons; over each the gap between both planes is linear, so that it is least at
 * one of the polygon's corners. The least of all gaps is exact: corners on faces, faces on corners, edges on edges.
 */

import type { Matrix4 } from 'three/webgpu';
import { type Shape, vertexOf } from '../meshes/shape.ts';

/** World-space triangles: xyz of three corners each. y is up. */
export type Triangles = Float64Array;

export interface Body {
  readonly triangles: Triangles;
  /** Only what is lower than its middle holds it: what it has sunk into lifts it, what it stands under does not. */
  readonly middle: number;
}

/** Overlaps smaller than this, m², are only touches: a box beside another does not rest on it. */
const LEAST_AREA = 1e-10;
/** Cells along each side of the grid at most. */
const MAX_CELLS = 256;

/**
 * @param ground the height of a ground that holds everything; without one, what nothing is below falls to y = 0
 * @returns m; negative for what has to be lifted; null if there are no triangles
 */
export function fallOf(
  bodies: readonly Body[],
  obstacles: readonly Triangles[],
  ground: number | null = null,
): number | null {
  const plan = planOf(bodies.map(({ triangles }) => triangles));
  if (plan === null) return null;
  const total = bodies.reduce((sum, { triangles }) => sum + triangles.length / 9, 0);
  const grid = new PlanGrid(plan, Math.min(MAX_CELLS, Math.ceil(Math.sqrt(total))));
  for (const triangles of obstacles) for (const below of facetsOf(triangles)) grid.add(below);
  let least = Number.POSITIVE_INFINITY;
  for (const { triangles, middle } of bodies) {
    // The lowest first: most of the others are then out of reach at once.
    const facets = facetsOf(triangles).sort((a, b) => a.low - b.low);
    for (const above of facets)
      for (const below of grid.near(above, above.low - least))
        if (above.low - below.high < least && below.low <= middle)
          least = Math.min(least, gapBetween(above, below, middle));
  }
  if (ground !== null) return Math.min(least, plan.low - ground);
  return Number.isFinite(least) ? least : plan.low;
}

/** @param toWorld from the mesh's own space */
export function worldTriangles(shape: Shape, toWorld: Matrix4): Triangles {
  const { positions, index } = shape;
  const e = toWorld.elements;
  const count = index?.length ?? positions.length / 3;
  const triangles = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) {
    const at = 3 * vertexOf(shape, i);
    const [x, y, z] = [positions[at]!, positions[at + 1]!, positions[at + 2]!];
    for (let row = 0; row < 3; row++)
      triangles[3 * i + row] = e[row]! * x + e[row + 4]! * y + e[row + 8]! * z + e[row + 12]!;
  }
  return triangles;
}

/** The height of the lowest corner in the world. */
export function lowestOf(shape: Shape, toWorld: Matrix4): number {
  const { positions, index } = shape;
  const [, x, , , , y, , , , z, , , , w] = toWorld.elements as unknown as number[];
  const count = index?.length ?? positions.length / 3;
  let lowest = Number.POSITIVE_INFINITY;
  for (let i = 0; i < count; i++) {
    const at = 3 * vertexOf(shape, i);
    lowest = Math.min(lowest, x! * positions[at]! + y! * positions[at + 1]! + z! * positions[at + 2]! + w!);
  }
  return lowest;
}

/** Null of nothing. */
export const leastOf = (heights: readonly number[]): number | null =>
  heights.length > 0 ? Math.min(...heights) : null;

function facetsOf(triangles: Triangles): Facet[] {
  const facets: Facet[] = [];
  for (let at = 0; at < triangles.length; at += 9) {
    const found = facet(triangles, at);
    if (found) facets.push(found);
  }
  return facets;
}

type Corner = readonly [x: number, z: number];

/** A triangle that is not upright. */
interface Facet {
  /** x and z of its corners, in the order that goes about y counter-clockwise, as seen from -y. */
  readonly corners: readonly [Corner, Corner, Corner];
  /** Its height is h(x, z) = a x + b z + c. */
  readonly plane: readonly [a: number, b: number, c: number];
  readonly low: number;
  readonly high: number;
}

function facet(t: Triangles, at: number): Facet | null {
  const [ax, ay, az] = [t[at]!, t[at + 1]!, t[at + 2]!];
  const [ux, uy, uz] = [t[at + 3]! - ax, t[at + 4]! - ay, t[at + 5]! - az];
  const [vx, vy, vz] = [t[at + 6]! - ax, t[at + 7]! - ay, t[at + 8]! - az];
  const area = ux * vz - uz * vx;
  if (Math.abs(area) < LEAST_AREA) return null;
  const a = (uy * vz - uz * vy) / area;
  const b = (ux * vy - uy * vx) / area;
  const [first, second, third]: [Corner, Corner, Corner] = [
    [ax, az],
    [ax + ux, az + uz],
    [ax + vx, az + vz],
  ];
  return {
    corners: area > 0 ? [first, second, third] : [first, third, second],
    plane: [a, b, ay - a * ax - b * az],
    low: ay + Math.min(0, uy, vy),
    high: ay + Math.max(0, uy, vy),
  };
}

function gapBetween(above: Facet, below: Facet, middle: number): number {
  let polygon: readonly Corner[] = above.corners;
  for (const [i, from] of below.corners.entries()) {
    polygon = cut(polygon, from, below.corners[(i + 1) % 3] as Corner);
    if (polygon.length < 3) return Number.POSITIVE_INFINITY;
  }
  if (areaOf(polygon) < LEAST_AREA) return Number.POSITIVE_INFINITY;
  let least = Number.POSITIVE_INFINITY;
  for (const [x, z] of polygon) {
    const floor = heightAt(below, x, z);
    if (floor <= middle) least = Math.min(least, heightAt(above, x, z) - floor);
  }
  return least;
}

const heightAt = ({ plane: [a, b, c] }: Facet, x: number, z: number): number => a * x + b * z + c;

/** What of a polygon is to the left of the line (Sutherland and Hodgman, 1974). */
function cut(polygon: readonly Corner[], [fx, fz]: Corner, [tx, tz]: Corner): Corner[] {
  const side = ([x, z]: Corner) => (tx - fx) * (z - fz) - (tz - fz) * (x - fx);
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length] as Corner;
    const [da, db] = [side(a), side(b)];
    const kept: Corner[] = da >= 0 ? [a] : [];
    if (da >= 0 !== db >= 0) {
      const t = da / (da - db);
      kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
    }
    return kept;
  });
}

function areaOf(polygon: readonly Corner[]): number {
  return (
    polygon.reduce((sum, [x, z], i) => {
      const [nx, nz] = polygon[(i + 1) % polygon.length] as Corner;
      return sum + x * nz - nx * z;
    }, 0) / 2
  );
}

interface Plan {
  readonly x: readonly [number, number];
  readonly z: readonly [number, number];
  readonly low: number;
}

function planOf(soups: readonly Triangles[]): Plan | null {
  let [x0, x1, z0, z1, low] = [Infinity, -Infinity, Infinity, -Infinity, Infinity];
  for (const soup of soups)
    for (let i = 0; i < soup.length; i += 3) {
      x0 = Math.min(x0, soup[i]!);
      x1 = Math.max(x1, soup[i]!);
      low = Math.min(low, soup[i + 1]!);
      z0 = Math.min(z0, soup[i + 2]!);
      z1 = Math.max(z1, soup[i + 2]!);
    }
  return x0 <= x1 ? { x: [x0, x1], z: [z0, z1], low } : null;
}

/** The triangles below, by where they are seen from above. */
class PlanGrid {
  readonly #plan: Plan;
  readonly #cells: number;
  readonly #lists: Facet[][];
  /** The height of the highest in each cell. */
  readonly #tops: Float64Array;

  constructor(plan: Plan, cells: number) {
    this.#plan = plan;
    this.#cells = cells;
    this.#lists = Array.from({ length: cells * cells }, () => []);
    this.#tops = new Float64Array(cells * cells).fill(Number.NEGATIVE_INFINITY);
  }

  add(below: Facet): void {
    this.#eachCell(below, (cell) => {
      this.#lists[cell]?.push(below);
      this.#tops[cell] = Math.max(this.#tops[cell] as number, below.high);
    });
  }

  /** What is under a triangle, from cells that reach higher than `from`; some of it more than once. */
  near(above: Facet, from: number): Facet[] {
    const found: Facet[][] = [];
    this.#eachCell(above, (cell) => {
      if ((this.#tops[cell] as number) > from) found.push(this.#lists[cell] as Facet[]);
    });
    return found.length === 1 ? (found[0] as Facet[]) : found.flat();
  }

  #eachCell({ corners: [a, b, c] }: Facet, visit: (cell: number) => void): void {
    const { x, z } = this.#plan;
    const [x0, x1] = this.#range(Math.min(a[0], b[0], c[0]), Math.max(a[0], b[0], c[0]), x);
    const [z0, z1] = this.#range(Math.min(a[1], b[1], c[1]), Math.max(a[1], b[1], c[1]), z);
    for (let row = z0; row <= z1; row++)
      for (let column = x0; column <= x1; column++) visit(row * this.#cells + column);
  }

  /** Cells from the first to the last; none for what is beside the plan. */
  #range(low: number, high: number, [from, to]: readonly [number, number]): readonly [number, number] {
    if (high < from || low > to) return [0, -1];
    const cell = (value: number) =>
      Math.min(this.#cells - 1, Math.max(0, Math.floor(((value - from) / (to - from || 1)) * this.#cells)));
    return [cell(low), cell(high)];
  }
}
