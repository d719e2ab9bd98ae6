/** The objects of the document as meshes. */
import * as THREE from 'three/webgpu';
import { BrdfMaterial } from '../../material/brdf-material.ts';
import { dependsOnTangent } from '../../material/tangent-dependence.ts';
import { ensureTangents } from '../../material/tangents.ts';
import type { Document, SceneObject } from '../schema.ts';
import { diff } from './diff.ts';
import type { GeometryCache, GeometryUse } from './geometry.ts';

interface Entry {
  mesh: THREE.Mesh;
  object: SceneObject;
  geometry: GeometryUse | null;
}

type MaterialOf = (id: string) => THREE.Material | undefined;

/** Until its material is known, and when it has gone. */
const NOTHING = new THREE.MeshBasicMaterial();
/** More than anybody deletes and wants back. */
const MOST_GONE = 2048;

export class ObjectsMirror {
  readonly group = new THREE.Group();
  readonly #entries = new Map<string, Entry>();
  readonly #ids = new WeakMap<THREE.Object3D, string>();
  readonly #geometries: GeometryCache;
  readonly #materialOf: MaterialOf;
  /**
   * What has gone and may come back by undo. Of things at the same depth, such as a copy in the place of its original, that is
   * seen whose mesh was made first: another mesh in its place would be another picture.
   */
  readonly #gone = new Map<string, THREE.Mesh>();

  constructor(geometries: GeometryCache, materialOf: MaterialOf) {
    this.#geometries = geometries;
    this.#materialOf = materialOf;
    this.group.name = 'objects';
  }

  /** What has gone does not come back. */
  forget(): void {
    this.#gone.clear();
  }

  apply(document: Document, before: Document | null): void {
    diff(before?.objects ?? {}, document.objects, {
      removed: (id) => this.#remove(id),
      added: (id, object) => this.#add(id, object, document),
      changed: (id, object) => this.#update(id, object, document),
    });
    // An object can stay the same while its glTF file became another one.
    if (before !== null && before.assets !== document.assets)
      for (const entry of this.#entries.values()) this.#setGeometry(entry, document);
  }

  /** An object can stay the same while its material became another one. */
  refreshMaterials(): void {
    for (const { mesh, object } of this.#entries.values()) this.#setMaterial(mesh, object);
  }

  get(id: string): THREE.Mesh | undefined {
    return this.#entries.get(id)?.mesh;
  }

  /** The id of the object that `three` is or belongs to. */
  idOf(three: THREE.Object3D): string | null {
    for (let at: THREE.Object3D | null = three; at !== null; at = at.parent) {
      const id = this.#ids.get(at);
      if (id !== undefined) return id;
    }
    return null;
  }

  dispose(): void {
    for (const id of [...this.#entries.keys()]) this.#remove(id);
  }

  #add(id: string, object: SceneObject, document: Document): void {
    const mesh = this.#gone.get(id) ?? new THREE.Mesh(new THREE.BufferGeometry(), NOTHING);
    this.#gone.delete(id);
    mesh.castShadow = true;
    // Shown when its geometry has come; see #setGeometry.
    mesh.visible = false;
    const entry: Entry = { mesh, object, geometry: null };
    this.#entries.set(id, entry);
    this.#ids.set(mesh, id);
    this.#set(entry, document);
    this.group.add(mesh);
  }

  #update(id: string, object: SceneObject, document: Document): void {
    const entry = this.#entries.get(id);
    if (entry === undefined) return;
    const moved = entry.object.geometry !== object.geometry;
    entry.object = object;
    this.#set(entry, document, moved);
  }

  #set(entry: Entry, document: Document, geometry = true): void {
    const { mesh, object } = entry;
    mesh.name = object.name;
    mesh.position.fromArray(object.position);
    const [x, y, z] = object.rotation.map(THREE.MathUtils.degToRad) as [number, number, number];
    mesh.rotation.set(x, y, z, 'XYZ');
    mesh.scale.fromArray(object.scale);
    mesh.visible = object.visible && mesh.geometry.hasAttribute('position');
    this.#setMaterial(mesh, object);
    if (geometry) this.#setGeometry(entry, document);
  }

  #setMaterial(mesh: THREE.Mesh, { material: id }: SceneObject): void {
    const material = this.#materialOf(id);
    if (material !== undefined) materialFrom(mesh, material);
    else giveTangents(mesh);
  }

  #setGeometry(entry: Entry, document: Document): void {
    const { geometry } = entry.object;
    const old = entry.geometry;
    if (old !== null && old.key === this.#geometries.keyOf(geometry, document)) return;
    // The new one first: it may be the same that the old one would let go.
    entry.geometry = this.#geometries.acquire(geometry, document, (loaded) => {
      entry.mesh.geometry = loaded;
      entry.mesh.visible = entry.object.visible;
      giveTangents(entry.mesh);
    });
    old?.release();
  }

  #remove(id: string): void {
    const entry = this.#entries.get(id);
    if (entry === undefined) return;
    this.#entries.delete(id);
    const { mesh, geometry } = entry;
    geometry?.release();
    mesh.removeFromParent();
    // It keeps its place in the order, and nothing else.
    mesh.geometry = new THREE.BufferGeometry();
    mesh.material = NOTHING;
    this.#gone.set(id, mesh);
    const [oldest] = this.#gone.keys();
    if (oldest !== undefined && this.#gone.size > MOST_GONE) this.#gone.delete(oldest);
  }
}

/** Gives a mesh a material, and the tangents that it may need. */
export function materialFrom(mesh: THREE.Mesh, material: THREE.Material): void {
  mesh.material = material;
  giveTangents(mesh);
}

/** Beyond this many vertices tangents wait until they are needed: they would hold up the first picture. */
const MAX_EAGER_VERTICES = 100_000;

/** Tangents ahead of need: an anisotropy slider then compiles nothing. */
function giveTangents({ geometry, material }: THREE.Mesh): void {
  const vertices = geometry.getAttribute('position')?.count ?? 0;
  if (vertices > MAX_EAGER_VERTICES || !(material instanceof BrdfMaterial)) return;
  if (dependsOnTangent(material.model)) ensureTangents(geometry);
}
