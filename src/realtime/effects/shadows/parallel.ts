/** Maps of a light from far away: cascades about the camera, and one of all that casts shadows. */
import {
  Box3,
  type Camera,
  type CoordinateSystem,
  Matrix4,
  type PerspectiveCamera,
  Vector3,
} from 'three/webgpu';
import { type Caster, shadesNothing } from './casters.ts';
import { mapCamera } from './map-camera.ts';
import type { Placement } from './rows.ts';

export interface ParallelMap {
  readonly placement: Placement;
  /** What it may show. */
  readonly casters: readonly Caster[];
  readonly camera: Camera;
}

export interface ParallelFit {
  /** Along the frame's z: of the maps' cameras, and of the highest caster. */
  readonly height: number;
  readonly highest: number;
  /** The finest first. */
  readonly maps: readonly ParallelMap[];
}

export interface CascadeSettings {
  readonly cascades: number;
  readonly maxDistance: number;
  readonly coordinateSystem: CoordinateSystem;
  /** Texels along each side of a map. */
  readonly size: number;
  /** Of half the light's angle. */
  readonly tangent: number;
}

/** Of logarithmic and even splits: F. Zhang et al., 2006, "Parallel-Split Shadow Maps for Large-Scale Virtual Environments". */
const LOGARITHMIC = 0.75;
/** A map moves by so many texels at once: a camera that turns a little draws none anew. */
const STEP = 16;
/** A map of a part is worth it where its texels are so many times as small as those of the map of all. */
const WORTH = 1.4;

export function fitParallel(
  frame: Matrix4,
  casters: readonly Caster[],
  camera: PerspectiveCamera,
  settings: CascadeSettings,
): ParallelFit {
  const toFrame = frame.clone().invert();
  const towards = new Vector3().setFromMatrixColumn(frame, 2);
  const casting = casters.filter((caster) => !shadesNothing(caster, towards, true, casters));
  if (casting.length === 0) return { height: 0, highest: 0, maps: [] };
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const bounds = casting.map((caster) => ({
    caster,
    box: new Box3().setFromPoints(caster.corners.map((corner) => corner.clone().applyMatrix4(toFrame))),
  }));
  for (const { box } of bounds) {
    low.min(box.min);
    high.max(box.max);
  }
  const depth = high.z - low.z;
  // The cameras' planes are beyond the casters, by more than float32 may be off.
  const gap = 1e-3 * Math.max(depth, high.x - low.x, high.y - low.y, high.length());
  const height = high.z + gap;
  const range = depth + 2 * gap;
  const view = viewDistances(casting, camera, settings.maxDistance);
  const whole = wholeWindow(low, high, camera, toFrame, settings, view.far);
  const texel = Math.max(whole.u[1] - whole.u[0], whole.v[1] - whole.v[0]) / settings.size;
  const windows: Placement[] = [];
  for (let i = 1; i < settings.cascades; i++) {
    const share = i / settings.cascades;
    const even = view.near + (view.far - view.near) * share;
    const logarithmic = view.near * (view.far / view.near) ** share;
    const split = even + (logarithmic - even) * LOGARITHMIC;
    const window = sliceWindow(camera, split, toFrame, settings, depth);
    if (window.texel * WORTH <= texel) windows.push(window.placement);
  }
  windows.push(whole);
  const maps = windows.map((placement) => ({
    placement,
    casters: bounds.filter(({ box }) => overlaps(box, placement)).map(({ caster }) => caster),
    camera: parallelCamera(frame, placement, height, range, settings.coordinateSystem),
  }));
  return { height, highest: high.z, maps };
}

const overlaps = ({ min, max }: Box3, { u, v }: Placement): boolean =>
  max.x >= u[0] && min.x <= u[1] && max.y >= v[0] && min.y <= v[1];

/** Between which distances shadows are looked at: in steps, so that they hold while the camera moves. */
function viewDistances(
  casters: readonly Caster[],
  camera: PerspectiveCamera,
  maxDistance: number,
): { near: number; far: number } {
  const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  let [near, far] = [Infinity, 0];
  for (const { corners } of casters) {
    const distances = corners.map((corner) => corner.distanceTo(eye));
    far = Math.max(far, ...distances);
    // A ball about the corners holds the caster.
    const centre = corners.reduce(
      (sum, corner) => sum.addScaledVector(corner, 1 / corners.length),
      new Vector3(),
    );
    near = Math.min(near, centre.distanceTo(eye) - centre.distanceTo(corners[0] as Vector3));
  }
  const step = (value: number, round: (x: number) => number) => 2 ** round(Math.log2(value));
  const farther = Math.min(step(Math.max(far, camera.near), Math.ceil), maxDistance, camera.far);
  const nearest = Math.max(near, camera.near, farther * 0.01);
  return { near: Math.min(step(nearest, Math.floor), farther * 0.5), far: farther };
}

/** All casters; of casters that reach far beyond, those about the camera. */
function wholeWindow(
  low: Vector3,
  high: Vector3,
  camera: PerspectiveCamera,
  toFrame: Matrix4,
  { size, maxDistance }: CascadeSettings,
  far: number,
): Placement {
  const border = (2 * Math.max(high.x - low.x, high.y - low.y)) / size;
  const all: Placement = { u: [low.x - border, high.x + border], v: [low.y - border, high.y + border] };
  const radius = Math.min(far, maxDistance);
  if (Math.max(high.x - low.x, high.y - low.y) <= 2 * radius) return all;
  const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld).applyMatrix4(toFrame);
  return snapped(eye, radius, size).placement;
}

/** What the camera sees nearer than `far`, and what keeps light off it. */
function sliceWindow(
  camera: PerspectiveCamera,
  far: number,
  toFrame: Matrix4,
  { size, tangent }: CascadeSettings,
  depth: number,
): { placement: Placement; texel: number } {
  // The least ball about the camera's pyramid up to `far`: as large whichever way the camera turns, and for all parts of a view.
  const aspect = camera.view?.enabled ? camera.view.fullWidth / camera.view.fullHeight : camera.aspect;
  const half = Math.tan((camera.fov * Math.PI) / 360);
  const slope2 = half * half * (1 + aspect * aspect);
  const along = Math.min(far, (far * (1 + slope2)) / 2);
  const radius = Math.hypot(far - along, far * Math.sqrt(slope2));
  const centre = new Vector3(0, 0, -along).applyMatrix4(camera.matrixWorld).applyMatrix4(toFrame);
  return snapped(centre, Math.max(radius, along) + Math.min(depth * tangent, radius), size);
}

/** A square window about a place whose texels lie where those of the window for any other place do. */
function snapped({ x, y }: Vector3, radius: number, size: number): { placement: Placement; texel: number } {
  const texel = (2 * radius) / Math.max(size - STEP - 2, 8);
  const snap = (value: number) => Math.round(value / texel / STEP) * STEP * texel;
  const half = (size / 2) * texel;
  const [u, v] = [snap(x), snap(y)];
  return { placement: { u: [u - half, u + half], v: [v - half, v + half] }, texel };
}

function parallelCamera(
  frame: Matrix4,
  { u, v }: Placement,
  height: number,
  range: number,
  coordinateSystem: CoordinateSystem,
): Camera {
  const view = frame.clone().setPosition(new Vector3(0, 0, height).applyMatrix4(frame));
  const projection = new Matrix4().makeOrthographic(u[0], u[1], v[1], v[0], 0, range, coordinateSystem);
  return mapCamera(view, projection, coordinateSystem);
}
