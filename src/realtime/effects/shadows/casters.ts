/** What casts shadows: the meshes of a scene with their bounds, and whether any has changed since the last frame. */
import {
  Box3,
  type BufferGeometry,
  DoubleSide,
  FrontSide,
  type Material,
  type Matrix4,
  type Mesh,
  type NodeMaterial,
  type Object3D,
  type Scene,
  Vector3,
} from 'three/webgpu';

/** What of a material decides where its shadow falls. */
type CastingMaterial = Material & Partial<Pick<NodeMaterial, 'opacityNode'>> & { alphaMap?: unknown };

interface Known {
  readonly caster: Caster;
  readonly matrix: Matrix4;
  readonly geometry: BufferGeometry;
  readonly version: number;
  readonly state: readonly unknown[];
}

export interface Caster {
  readonly mesh: Mesh;
  /** The corners of its bounds in world space. */
  readonly corners: readonly Vector3[];
  /** Of what lies in a plane: the plane's normal, on its front; null of a body. */
  readonly normal: Vector3 | null;
  readonly hasFew: boolean;
}

/** Of a mesh's size: what is thinner lies in a plane. */
const FLAT = 1e-6;

export class Casters {
  /** Each the same object while its mesh is as it was. */
  list: readonly Caster[] = [];
  #known: ReadonlyMap<Mesh, Known> = new Map();

  /** Looks at the scene, whose world matrices are up to date. @returns whether anything has changed */
  update(scene: Scene): boolean {
    const meshes: Mesh[] = [];
    collect(scene, meshes);
    const before = this.#known;
    this.#known = new Map(
      meshes.map((mesh) => {
        const known = before.get(mesh);
        return [mesh, known && same(known, mesh) ? known : knownOf(mesh)];
      }),
    );
    this.list = [...this.#known.values()].map(({ caster }) => caster);
    return before.size !== meshes.length || meshes.some((mesh) => before.get(mesh) !== this.#known.get(mesh));
  }
}

/** Whether a caster that lies in a plane keeps the light of a lamp at `from` off any other: all may be before it. */
export function shadesNothing(
  caster: Caster,
  from: Vector3,
  isFar: boolean,
  list: readonly Caster[],
): boolean {
  const { normal, mesh, corners } = caster;
  if (normal === null) return false;
  const point = corners[0] as Vector3;
  const { side } = mesh.material as Material;
  const height = isFar ? from.dot(normal) : from.dot(normal) - point.dot(normal);
  // The front of what has one side keeps nothing off: see castingSide().
  if (side !== DoubleSide && (side === FrontSide ? height > 0 : height < 0)) return true;
  const sign = height > 0 ? 1 : -1;
  const offset = point.dot(normal);
  const least = -1e-5 * (corners[7] as Vector3).distanceTo(point);
  const isBefore = (place: Vector3) => sign * (place.dot(normal) - offset) >= least;
  return list.every(
    (other) =>
      other === caster ||
      other.corners.every(isBefore) ||
      (other.hasFew && everyVertex(other.mesh, isBefore)),
  );
}

/** Vertices that are looked at one by one where the bounds leave it open. */
const FEW = 100_000;

function everyVertex({ geometry, matrixWorld }: Mesh, test: (place: Vector3) => boolean): boolean {
  const positions = geometry.getAttribute('position');
  const place = new Vector3();
  for (let i = 0; i < positions.count; i++)
    if (!test(place.fromBufferAttribute(positions, i).applyMatrix4(matrixWorld))) return false;
  return true;
}

function collect(object: Object3D, meshes: Mesh[]): void {
  if (!object.visible) return;
  const mesh = object as Mesh;
  // A mesh that nothing has been loaded for yet has no geometry to speak of.
  if (mesh.isMesh && mesh.castShadow && mesh.geometry.hasAttribute('position')) meshes.push(mesh);
  for (const child of object.children) collect(child, meshes);
}

function knownOf(mesh: Mesh): Known {
  return {
    caster: casterOf(mesh),
    matrix: mesh.matrixWorld.clone(),
    geometry: mesh.geometry,
    version: versionOf(mesh.geometry),
    state: stateOf(mesh),
  };
}

function same(known: Known, mesh: Mesh): boolean {
  if (known.geometry !== mesh.geometry) return false;
  if (known.version !== versionOf(mesh.geometry) || !known.matrix.equals(mesh.matrixWorld)) return false;
  const state = stateOf(mesh);
  return known.state.every((value, i) => value === state[i]);
}

function versionOf(geometry: BufferGeometry): number {
  const positions = geometry.getAttribute('position');
  return 'version' in positions ? positions.version : 0;
}

function stateOf({ material }: Mesh): unknown[] {
  const { uuid, side, alphaTest, transparent, opacity, alphaMap, opacityNode } = material as CastingMaterial;
  return [uuid, side, alphaTest, transparent, opacity, alphaMap, opacityNode];
}

function casterOf(mesh: Mesh): Caster {
  const { geometry, matrixWorld } = mesh;
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox ?? new Box3();
  const corners = [min.x, max.x].flatMap((x) =>
    [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z).applyMatrix4(matrixWorld))),
  );
  const extent = max.clone().sub(min);
  const longest = Math.max(extent.x, extent.y, extent.z);
  const axis = [extent.x, extent.y, extent.z].findIndex((length) => length <= FLAT * longest);
  const hasFew = geometry.getAttribute('position').count <= FEW;
  return { mesh, corners, normal: axis < 0 ? null : normalOf(mesh, axis), hasFew };
}

/** Of a plane mesh that lies across an axis of its own, towards the front of its first triangle. */
function normalOf({ geometry, matrixWorld }: Mesh, axis: number): Vector3 {
  const positions = geometry.getAttribute('position');
  const corner = (i: number) =>
    new Vector3().fromBufferAttribute(positions, geometry.index?.getX(i) ?? i).applyMatrix4(matrixWorld);
  const [a, b, c] = [corner(0), corner(1), corner(2)];
  const front = b.sub(a).cross(c.sub(a));
  if (matrixWorld.determinant() < 0) front.negate();
  if (front.lengthSq() > 0) return front.normalize();
  return new Vector3().setFromMatrixColumn(matrixWorld, axis).normalize();
}
