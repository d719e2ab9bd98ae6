/**
 * The three.js counterpart of a document. It follows the document by comparing references with
 * the last one: what an edit did not touch is the same object, and is not looked at. So a
 * slider of a material sets one uniform, a light's field sets that field, and only what a
 * change replaces (a geometry's parameters, a material's model) is made anew.
 *
 * The parts, one per kind of entity, are in mirror/.
 */
import * as THREE from 'three/webgpu';
import type { BrdfMaterial } from '../material/brdf-material.ts';
import type { AssetLoader } from './assets.ts';
import { EnvironmentMirror } from './mirror/environment.ts';
import { GeometryCache } from './mirror/geometry.ts';
import { LightsMirror, type MirroredLight } from './mirror/lights.ts';
import { MaterialsMirror } from './mirror/materials.ts';
import { ObjectsMirror } from './mirror/objects.ts';
import { Pending } from './mirror/pending.ts';
import { TextureCache } from './mirror/textures.ts';
import type { Camera, Document } from './schema.ts';

export interface SceneMirrorOptions {
  assets: AssetLoader;
  /** An asset did not come: what is missing and why, for a person to read. */
  onError(message: string): void;
}

export class SceneMirror {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera();
  #document: Document | null = null;
  readonly #pending: Pending;
  readonly #materials: MaterialsMirror;
  readonly #objects: ObjectsMirror;
  readonly #lights = new LightsMirror();
  readonly #environment: EnvironmentMirror;

  constructor({ assets, onError }: SceneMirrorOptions) {
    this.#pending = new Pending(onError);
    this.#materials = new MaterialsMirror(new TextureCache(assets), this.#pending);
    this.#objects = new ObjectsMirror(new GeometryCache(assets, this.#pending), (id) =>
      this.#materials.get(id),
    );
    this.#environment = new EnvironmentMirror(this.scene, assets, this.#pending);
    this.scene.add(this.#objects.group, this.#lights.group);
  }

  /** Makes the scene show `document`. What has to be loaded appears when it has come. */
  apply(document: Document): void {
    const before = this.#document;
    if (before === document) return;
    this.#document = document;
    this.scene.name = document.name;
    const { made } = this.#materials;
    this.#materials.apply(document, before);
    this.#objects.apply(document, before);
    if (made !== this.#materials.made) this.#objects.refreshMaterials();
    this.#lights.apply(document, before);
    this.#environment.apply(document, before);
    if (before?.camera !== document.camera) setCamera(this.camera, document.camera);
  }

  /** Shows another document, from which no undo leads back: what has gone is not kept for its return. */
  open(document: Document): void {
    // Nor does it return for an id that this document happens to have, too.
    this.#forget();
    this.apply(document);
    this.#forget();
  }

  #forget(): void {
    this.#objects.forget();
    this.#lights.forget();
  }

  /** Every asset asked for so far has come or failed. */
  settled(): Promise<void> {
    return this.#pending.settled();
  }

  objectFor(id: string): THREE.Mesh | undefined {
    return this.#objects.get(id);
  }

  lightFor(id: string): MirroredLight | undefined {
    return this.#lights.get(id);
  }

  materialFor(id: string): BrdfMaterial | undefined {
    return this.#materials.get(id);
  }

  /** The id of the document's object that a three.js object stands for or is part of. */
  idFor(object: THREE.Object3D): string | null {
    return this.#objects.idOf(object);
  }

  /** The loader of assets was given, and stays with its owner. */
  dispose(): void {
    this.#objects.dispose();
    this.#materials.dispose();
    this.#lights.dispose();
    this.#environment.dispose();
    this.#document = null;
  }
}

function setCamera(camera: THREE.PerspectiveCamera, { fov, near, far, position, target }: Camera): void {
  camera.fov = fov;
  camera.near = near;
  camera.far = far;
  camera.position.fromArray(position);
  camera.lookAt(...target);
  camera.updateProjectionMatrix();
}
