/**
 * The outline of a mesh in the picture. Let every triangle that faces the eye be gone around counter-clockwise, and every
 * other one clockwise, so that on the screen all go the same way. Added up, the sides that two such triangles share cancel out;
 * what is left are closed lines, and what they go around (winding number not 0) is just what the mesh covers.
 */
import type { Matrix4, Vector3 } from 'three/webgpu';
import { type MeshEdges, NONE } from './mesh-edges.ts';

export interface SilhouetteView {
  /** In the mesh's own space. */
  readonly eye: Vector3;
  /** From the mesh's own space to clip space. */
  readonly toClip: Matrix4;
  /** What is nearer along the view is cut off, m. */
  readonly near: number;
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
}

/** x, y, x, y... in CSS pixels; closed. */
export type Loop = readonly number[];

/** Points nearer than this to the one before, in CSS pixels, are left out. */
const COARSE = 0.4;

export function silhouette(mesh: MeshEdges, view: SilhouetteView): Loop[] {
  const { corners, planes, edges, sides } = mesh;
  const { eye } = view;
  const triangles = corners.length / 3;
  const net = new Int8Array(edges.length / 2);
  const facing = new Int8Array(triangles);
  for (let i = 0, k = 0; i < triangles; i++, k += 4) {
    const height = planes[k]! * eye.x + planes[k + 1]! * eye.y + planes[k + 2]! * eye.z - planes[k + 3]!;
    const sign = height >= 0 ? 1 : -1;
    facing[i] = sign;
    for (let s = 3 * i; s < 3 * i + 3; s++) {
      const edge = sides[s]!;
      // The other way round, if it goes from its higher corner to its lower one.
      if (edge !== NONE) net[edge]! += corners[s] === edges[2 * edge] ? sign : -sign;
    }
  }
  const place = placesOf(mesh, view);
  const lines = new Lines();
  // Of a closed mesh each line is there twice: of a front and of a back.
  const share = place.isCut || net.some((times) => times % 2 !== 0) ? 1 : 2;
  for (let edge = 0; edge < net.length; edge++) {
    const times = net[edge]!;
    if (times === 0) continue;
    const [a, b] = [edges[2 * edge]!, edges[2 * edge + 1]!];
    const [from, to] = times > 0 ? [a, b] : [b, a];
    const [seenFrom, seenTo] = [place.isSeen(from), place.isSeen(to)];
    if (!seenFrom && !seenTo) continue;
    const cut = place.cut(edge);
    lines.add(seenFrom ? from : cut, seenTo ? to : cut, Math.abs(times) / share);
  }
  if (place.isCut) addCuts(mesh, facing, place, lines);
  return lines.loops().map((loop) => pixelsOf(loop, place));
}

/** Where triangles go through the plane before the eye, their sides are joined along it. */
function addCuts({ corners, sides }: MeshEdges, facing: Int8Array, place: Places, lines: Lines): void {
  for (let i = 0; i < corners.length; i += 3) {
    let [leaves, enters] = [NONE, NONE];
    for (let s = i; s < i + 3; s++) {
      const next = s === i + 2 ? i : s + 1;
      const [here, there] = [place.isSeen(corners[s]!), place.isSeen(corners[next]!)];
      if (here && !there) leaves = sides[s]!;
      if (!here && there) enters = sides[s]!;
    }
    if (leaves === NONE || enters === NONE) continue;
    const [from, to] = facing[i / 3]! > 0 ? [leaves, enters] : [enters, leaves];
    lines.add(place.cut(from), place.cut(to), 1);
  }
}

/** Corners, and points where edges are cut, by one number each. */
interface Places {
  readonly isCut: boolean;
  isSeen(corner: number): boolean;
  /** The number of the point where an edge is cut. */
  cut(edge: number): number;
  pixel(place: number): readonly [number, number];
}

function placesOf({ points, edges }: MeshEdges, { toClip, near, width, height }: SilhouetteView): Places {
  const e = toClip.elements;
  const count = points.length / 3;
  const row = (r: number, x: number, y: number, z: number) =>
    e[r]! * x + e[r + 4]! * y + e[r + 8]! * z + e[r + 12]!;
  // Clip space w is the distance along the view.
  const depth = (i: number) => row(3, points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!);
  const pixelAt = (x: number, y: number, z: number): readonly [number, number] => {
    const w = row(3, x, y, z);
    return [((row(0, x, y, z) / w + 1) / 2) * width, ((1 - row(1, x, y, z) / w) / 2) * height];
  };
  let isCut = false;
  for (let i = 0; i < count && !isCut; i++) isCut = depth(i) <= near;
  return {
    isCut,
    isSeen: isCut ? (corner) => depth(corner) > near : () => true,
    cut: (edge) => count + edge,
    pixel(place) {
      if (place < count) return pixelAt(points[3 * place]!, points[3 * place + 1]!, points[3 * place + 2]!);
      const [a, b] = [edges[2 * (place - count)]!, edges[2 * (place - count) + 1]!];
      const [da, db] = [depth(a), depth(b)];
      const t = (near - da) / (db - da);
      const mixed = (axis: number) =>
        points[3 * a + axis]! + t * (points[3 * b + axis]! - points[3 * a + axis]!);
      return pixelAt(mixed(0), mixed(1), mixed(2));
    },
  };
}

/** Directed lines from place to place, of which as many begin at each as end there. */
class Lines {
  readonly #from = new Map<number, number[]>();

  add(from: number, to: number, times: number): void {
    let ends = this.#from.get(from);
    if (!ends) {
      ends = [];
      this.#from.set(from, ends);
    }
    for (let k = 0; k < times; k++) ends.push(to);
  }

  loops(): number[][] {
    const loops: number[][] = [];
    for (const [start, ends] of this.#from) {
      while (ends.length > 0) {
        const loop: number[] = [];
        let at: number | undefined = start;
        do {
          loop.push(at);
          at = this.#from.get(at)?.pop();
        } while (at !== undefined && at !== start);
        loops.push(loop);
      }
    }
    return loops;
  }
}

function pixelsOf(loop: readonly number[], place: Places): number[] {
  const pixels: number[] = [];
  let [lastX, lastY] = [Number.NaN, Number.NaN];
  for (const one of loop) {
    const [x, y] = place.pixel(one);
    if (Math.abs(x - lastX) + Math.abs(y - lastY) < COARSE) continue;
    pixels.push(x, y);
    lastX = x;
    lastY = y;
  }
  return pixels;
}
