/**
 * Draws what a scene of many meshes has often as few: those with a geometry and a material in common are instances of one mesh
 * while the picture is drawn. The scene itself stays as it is, a mesh for each object, and nothing is kept of it from one frame
 * to the next, so that whoever changes it need not tell.
 */
import {
  type BufferGeometry,
  Frustum,
  Group,
  type InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  type PerspectiveCamera,
  type Scene,
  Sphere,
  Vector3,
} from 'three/webgpu';
import { BrdfMaterial } from '../../material/brdf-material.ts';
import { Instances } from './instances.ts';

/** Fewer are drawn one by one: 10 to 15 µs of the page's thread each. */
const MANY = 256;
/** Of a kind: a shader for instances is worth its compilation. */
const OFTEN = 16;
/** Cosine between axes that are perpendicular: three.js turns normals of instances by a matrix that has no shear. */
const SHEAR = 1e-4;

/** Of the 8 vertex buffers that every GPU has, one is for the matrices, and one for tangents that may come. */
const MOST_ATTRIBUTES = 6;

interface Kind {
  readonly instances: Instances;
  readonly meshes: readonly Mesh[];
  readonly mesh: InstancedMesh;
}

/** What is to be drawn, each kind in the order of the first of it. */
interface Plan {
  readonly kinds: readonly Kind[];
  readonly single: readonly Mesh[];
}

interface Placed {
  readonly mesh: Mesh;
  readonly depth: number;
}

export class RepeatedMeshes {
  readonly #known = new Map<BufferGeometry, Map<Material, Instances>>();
  readonly #group = new Group();
  readonly #frustum = new Frustum();
  readonly #viewProjection = new Matrix4();
  readonly #forget = ({ target }: { target: unknown }) => this.#let(target as BufferGeometry | Material);

  constructor() {
    this.#group.name = 'repeated';
  }

  /** The meshes that three.js is given to draw a scene, visible or not. */
  drawn(scene: Scene): readonly Mesh[] {
    scene.updateMatrixWorld();
    const { kinds, single } = this.#plan(scene);
    return [...kinds.map(({ mesh }) => mesh), ...single];
  }

  /** Draws a scene that a camera sees, whose world matrix and projection are up to date. */
  within<T>(scene: Scene, camera: PerspectiveCamera, draw: () => T): T {
    scene.updateMatrixWorld();
    const { kinds } = this.#plan(scene);
    if (kinds.length === 0) return draw();
    this.#place(kinds, camera);
    const hidden = kinds.flatMap(({ meshes }) => meshes);
    const masks = hidden.map(({ layers }) => layers.mask);
    for (const { layers } of hidden) layers.mask = 0;
    this.#group.add(...kinds.map(({ mesh }) => mesh));
    scene.add(this.#group);
    try {
      return draw();
    } finally {
      scene.remove(this.#group);
      this.#group.clear();
      for (const [i, { layers }] of hidden.entries()) layers.mask = masks[i]!;
    }
  }

  /** To be called when a frame has been drawn. */
  tidy(): void {
    for (const [, ofMaterial] of this.#known) for (const [, instances] of ofMaterial) instances.tidy();
  }

  dispose(): void {
    for (const geometry of [...this.#known.keys()]) this.#let(geometry);
  }

  #plan(scene: Scene): Plan {
    const meshes: Mesh[] = [];
    scene.traverseVisible((object) => {
      if (object instanceof Mesh) meshes.push(object);
    });
    if (meshes.length < MANY) return { kinds: [], single: meshes };
    const single: Mesh[] = [];
    const alike = new Map<BufferGeometry, Map<Material, Mesh[]>>();
    // As three.js draws them where they are at the same depth.
    meshes.sort((a, b) => a.id - b.id);
    for (const mesh of meshes) {
      if (!isPlain(mesh)) {
        single.push(mesh);
        continue;
      }
      const ofGeometry = entryOf(alike, mesh.geometry, () => new Map<Material, Mesh[]>());
      entryOf(ofGeometry, mesh.material, () => []).push(mesh);
    }
    const often: [BufferGeometry, Material, readonly Mesh[]][] = [];
    for (const [geometry, ofGeometry] of alike)
      for (const [material, same] of ofGeometry) {
        if (same.length < OFTEN) single.push(...same);
        else often.push([geometry, material, same]);
      }
    const taken = new Set(single.map(placeOf));
    const kinds: Kind[] = [];
    for (const [geometry, material, same] of often) {
      const isAlone = (mesh: Mesh) => taken.has(placeOf(mesh));
      if (taken.size > 0) single.push(...same.filter(isAlone));
      const meshes = taken.size > 0 ? same.filter((mesh) => !isAlone(mesh)) : same;
      if (meshes.length === 0) continue;
      const instances = this.#instancesOf(geometry, material);
      kinds.push({ instances, meshes, mesh: instances.meshFor(meshes.length) });
    }
    return { kinds, single };
  }

  #instancesOf(geometry: BufferGeometry, material: Material): Instances {
    const ofGeometry = entryOf(this.#known, geometry, () => {
      geometry.addEventListener('dispose', this.#forget);
      return new Map<Material, Instances>();
    });
    return entryOf(ofGeometry, material, () => {
      material.addEventListener('dispose', this.#forget);
      return new Instances(geometry, material);
    });
  }

  #place(kinds: readonly Kind[], camera: PerspectiveCamera): void {
    this.#viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.#frustum.setFromProjectionMatrix(
      this.#viewProjection,
      camera.coordinateSystem,
      camera.reversedDepth,
    );
    const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
    for (const [i, { instances, meshes, mesh }] of kinds.entries()) {
      instances.place(this.#seen(meshes, camera), eye);
      // Kinds have no depth: in the order of what was made first, and before what is drawn one by one.
      mesh.renderOrder = i - kinds.length;
    }
  }

  /** Those that are in view, in the order in which three.js draws what is opaque: the nearest first. */
  #seen(meshes: readonly Mesh[], { layers }: PerspectiveCamera): readonly Mesh[] {
    const { elements: e } = this.#viewProjection;
    const placed: Placed[] = [];
    for (const mesh of meshes) {
      if (!mesh.layers.test(layers)) continue;
      const { geometry, matrixWorld } = mesh;
      if (!geometry.boundingSphere) geometry.computeBoundingSphere();
      const { center } = sphere.copy(geometry.boundingSphere!).applyMatrix4(matrixWorld);
      if (mesh.frustumCulled && !this.#frustum.intersectsSphere(sphere)) continue;
      placed.push({ mesh, depth: e[2] * center.x + e[6] * center.y + e[10] * center.z + e[14] });
    }
    placed.sort((a, b) => a.depth - b.depth || a.mesh.id - b.mesh.id);
    return placed.map(({ mesh }) => mesh);
  }

  /** Lets go of what was drawn with what is gone. */
  #let(gone: BufferGeometry | Material): void {
    for (const [geometry, ofGeometry] of this.#known) {
      for (const [material, instances] of ofGeometry) {
        if (geometry !== gone && material !== gone) continue;
        instances.dispose();
        ofGeometry.delete(material);
        this.#unlisten(material);
      }
      if (ofGeometry.size > 0) continue;
      geometry.removeEventListener('dispose', this.#forget);
      this.#known.delete(geometry);
    }
  }

  #unlisten(material: Material): void {
    const isUsed = [...this.#known.values()].some((ofGeometry) => ofGeometry.has(material));
    if (!isUsed) material.removeEventListener('dispose', this.#forget);
  }
}

const sphere = new Sphere();

/**
 * Says that meshes are not at the same place, where it is another. A copy in the place of its original has the same depth only
 * if both are drawn the same way: rounding would have them show through each other.
 */
const placeOf = ({ matrixWorld: { elements } }: Mesh): number =>
  elements[12] + Math.SQRT2 * elements[13] + Math.PI * elements[14];

function entryOf<K, V>(map: Map<K, V>, key: K, make: () => V): V {
  const found = map.get(key);
  if (found !== undefined) return found;
  const made = make();
  map.set(key, made);
  return made;
}

type PlainMesh = Mesh<BufferGeometry, BrdfMaterial>;

/** Whether a mesh is drawn as an instance of it would be. */
function isPlain(mesh: Mesh): mesh is PlainMesh {
  const { material, geometry, receiveShadow, renderOrder } = mesh;
  return (
    mesh.constructor === Mesh &&
    material instanceof BrdfMaterial &&
    // Those are sorted with all others.
    !material.transparent &&
    !receiveShadow &&
    renderOrder === 0 &&
    geometry.hasAttribute('position') &&
    Object.keys(geometry.attributes).length <= MOST_ATTRIBUTES &&
    Object.keys(geometry.morphAttributes).length === 0 &&
    isRigid(mesh.matrixWorld)
  );
}

const axes = [new Vector3(), new Vector3(), new Vector3()] as const;

/** Whether it only turns, moves and scales: a mirror image has its faces the other way round. */
function isRigid(matrix: Matrix4): boolean {
  const [x, y, z] = axes;
  for (const [i, axis] of axes.entries()) axis.setFromMatrixColumn(matrix, i);
  const [a, b, c] = [x.length(), y.length(), z.length()];
  const isStraight =
    Math.abs(x.dot(y)) <= SHEAR * a * b &&
    Math.abs(y.dot(z)) <= SHEAR * b * c &&
    Math.abs(z.dot(x)) <= SHEAR * c * a;
  return isStraight && x.cross(y).dot(z) > 0;
}
