/** Maps of a light that shines from a place: one, or the faces of a cube, no larger than what casts shadows needs. */
import { type Camera, type CoordinateSystem, Matrix4, Vector3 } from 'three/webgpu';
import { type Caster, shadesNothing } from './casters.ts';
import { mapCamera } from './map-camera.ts';
import { axisOf, FACES, type Placement } from './rows.ts';

export interface CentralLight {
  /** From its own space to the world's, without scale; z is where it shines. */
  readonly frame: Matrix4;
  /** Tangents that the +z map goes to: 1 where others go on beside it. */
  readonly reach: number;
  /** The maps that it has: indices into FACES. */
  readonly faces: readonly number[];
  /** Whether it shines from a rectangle in the frame's xy plane rather than from a disc that faces what it lights. */
  readonly isPanel: boolean;
}

export interface CentralMap {
  readonly placement: Placement;
  /** What it may show. */
  readonly casters: readonly Caster[];
  readonly camera: Camera;
}

export interface CentralFit {
  /** Of the nearest caster: its distance, or along z for a rectangle. */
  readonly nearest: number;
  /** By face; null where nothing casts. */
  readonly maps: readonly (CentralMap | null)[];
}

/** The depth buffer's nearest over its farthest plane: it orders what is nearer than a thousandth of the way. */
const LEAST_RATIO = 2e-4;
/** Texels beyond what casts, where filters look, too. */
const BORDER = 0.02;

export function fitCentral(
  { frame, reach, faces, isPanel }: CentralLight,
  casters: readonly Caster[],
  coordinateSystem: CoordinateSystem,
): CentralFit {
  const position = new Vector3().setFromMatrixPosition(frame);
  const forward = axisOf(frame, 3);
  const casting = casters.filter((caster) => !shadesNothing(caster, position, false, casters));
  let [nearest, far] = [Number.POSITIVE_INFINITY, 0];
  for (const { corners } of casting) {
    nearest = Math.min(
      nearest,
      isPanel ? alongLeast(corners, position, forward) : distanceTo(corners, position),
    );
    for (const corner of corners) far = Math.max(far, corner.distanceTo(position));
  }
  far *= 1.001;
  nearest = Math.max(nearest, far * LEAST_RATIO);
  const near =
    Math.max(nearestOf(casting, position) * 0.99, far * LEAST_RATIO) / Math.sqrt(1 + 2 * reach * reach);
  const maps = faces.map((face): CentralMap | null => {
    const { forward: f, right: r, up: u } = FACES[face] as (typeof FACES)[number];
    const axes = [axisOf(frame, r), axisOf(frame, u), axisOf(frame, f)] as const;
    const found = windowOf(casting, position, axes, face === 0 ? reach : 1);
    if (found === null) return null;
    const { window, casters } = found;
    const edge = (value: number) => value * near;
    const [left, right] = window.u.map(edge) as [number, number];
    const [bottom, top] = window.v.map(edge) as [number, number];
    const view = new Matrix4().makeBasis(axes[0], axes[1], axes[2].clone().negate()).setPosition(position);
    const projection = new Matrix4().makePerspective(left, right, top, bottom, near, far, coordinateSystem);
    const camera = mapCamera(view, projection, coordinateSystem);
    return { placement: window, casters, camera };
  });
  return { nearest, maps };
}

type Axes = readonly [right: Vector3, up: Vector3, forward: Vector3];

/** The casters that a face sees, and the tangents between which it does; null if it sees none. */
function windowOf(
  casters: readonly Caster[],
  position: Vector3,
  [right, up, forward]: Axes,
  reach: number,
): { window: Placement; casters: readonly Caster[] } | null {
  let [left, most, bottom, top] = [reach, -reach, reach, -reach];
  const offset = new Vector3();
  const seen: Caster[] = [];
  for (const caster of casters) {
    const { corners } = caster;
    let [l, r, b, t] = [Infinity, -Infinity, Infinity, -Infinity];
    let behind = 0;
    for (const corner of corners) {
      offset.subVectors(corner, position);
      const z = offset.dot(forward);
      if (z <= 1e-4 * offset.length()) {
        behind++;
        continue;
      }
      const [u, v] = [offset.dot(right) / z, offset.dot(up) / z];
      [l, r, b, t] = [Math.min(l, u), Math.max(r, u), Math.min(b, v), Math.max(t, v)];
    }
    if (behind === corners.length) continue;
    // What reaches behind the camera may be anywhere.
    if (behind > 0) [l, r, b, t] = [-reach, reach, -reach, reach];
    if (l > reach || r < -reach || b > reach || t < -reach) continue;
    seen.push(caster);
    [left, most, bottom, top] = [Math.min(left, l), Math.max(most, r), Math.min(bottom, b), Math.max(top, t)];
  }
  if (left >= most || bottom >= top) return null;
  const border = BORDER * Math.max(most - left, top - bottom);
  const clamp = (value: number) => Math.min(Math.max(value, -reach), reach);
  const window: Placement = {
    u: [clamp(left - border), clamp(most + border)],
    v: [clamp(bottom - border), clamp(top + border)],
  };
  return { window, casters: seen };
}

function nearestOf(casters: readonly Caster[], position: Vector3): number {
  return casters.reduce((least, { corners }) => Math.min(least, distanceTo(corners, position)), Infinity);
}

/** The distance to the axis-parallel box about some points. */
function distanceTo(points: readonly Vector3[], position: Vector3): number {
  const outside = (['x', 'y', 'z'] as const).map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(Math.min(...values) - position[axis], position[axis] - Math.max(...values), 0);
  });
  return Math.hypot(...outside);
}

function alongLeast(points: readonly Vector3[], position: Vector3, forward: Vector3): number {
  return Math.min(...points.map((point) => point.dot(forward))) - position.dot(forward);
}
