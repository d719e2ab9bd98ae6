/** Where the ground is, as the path tracer finds it: at the lowest point of what is visible, around its middle. */
import type { BufferGeometry, Matrix4, Mesh } from 'three/webgpu';
import type { Caster } from '../effects/shadows/casters.ts';

export interface Bounds {
  /** Metres; of an empty scene all are 0. */
  readonly low: readonly [x: number, y: number, z: number];
  readonly high: readonly [x: number, y: number, z: number];
}

/** The box around the boxes of all objects. */
export function boundsOf(casters: readonly Caster[]): Bounds {
  if (casters.length === 0) return { low: [0, 0, 0], high: [0, 0, 0] };
  const corners = casters.flatMap((caster) => caster.corners);
  const along = (pick: (...values: number[]) => number) =>
    (['x', 'y', 'z'] as const).map((axis) =>
      corners.reduce((found, corner) => pick(found, corner[axis]), corners[0]![axis]),
    ) as [number, number, number];
  return { low: along(Math.min), high: along(Math.max) };
}

/** The height of the lowest point; 0 of an empty scene. */
export function lowestOf(casters: readonly Caster[]): number {
  const lowest = casters.reduce(
    (least, { mesh }) => Math.min(least, lowestPoint(mesh)),
    Number.POSITIVE_INFINITY,
  );
  return Number.isFinite(lowest) ? lowest : 0;
}

interface Known {
  readonly geometry: BufferGeometry;
  readonly version: number;
  readonly row: readonly [number, number, number];
  readonly least: number;
}

/** A mesh that is only moved keeps its lowest vertex. */
const known = new WeakMap<Mesh, Known>();

function lowestPoint(mesh: Mesh): number {
  const { geometry } = mesh;
  const positions = geometry.getAttribute('position');
  const version = 'version' in positions ? positions.version : 0;
  const { elements: m } = mesh.matrixWorld as Matrix4;
  const [a, b, c] = [m[1]!, m[5]!, m[9]!];
  const before = known.get(mesh);
  if (before?.geometry === geometry && before.version === version) {
    const [x, y, z] = before.row;
    if (x === a && y === b && z === c) return before.least + m[13]!;
  }
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < positions.count; i++)
    least = Math.min(least, a * positions.getX(i) + b * positions.getY(i) + c * positions.getZ(i));
  known.set(mesh, { geometry, version, row: [a, b, c], least });
  return least + m[13]!;
}

/** The height of a caster's box. */
export function topOf({ corners }: Caster): number {
  return corners.reduce((top, { y }) => Math.max(top, y), Number.NEGATIVE_INFINITY);
}
