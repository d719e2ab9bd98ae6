/**
 * The ground that shows shadows and nothing of itself, in the interactive picture: a disc that is in the scene only while the
 * picture is drawn. Nothing else finds it, neither rays nor the passes before the picture.
 */
import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  type PerspectiveCamera,
  type Scene,
  type WebGPURenderer,
} from 'three/webgpu';
import { Casters } from '../effects/shadows/casters.ts';
import type { FrameSettings } from '../frame/effect.ts';
import { CatcherMaterial } from './catcher-material.ts';
import { boundsOf, lowestOf } from './place.ts';
import { SkyLight } from './sky-light.ts';
import { SkyShadow } from './sky-shadow.ts';

/** Rings of the disc, each half as wide as the next: triangles are small where the camera is near. */
const RINGS = 20;
const SECTORS = 32;

export class GroundCatcher {
  readonly #casters = new Casters();
  readonly #light = new SkyLight();
  readonly #shadow = new SkyShadow();
  readonly #material = new CatcherMaterial(this.#shadow, this.#light.irradiance);
  readonly #mesh = new Mesh(disc(), this.#material);
  #bounds = boundsOf([]);
  #lowest = 0;
  /** Of the last frame. */
  #height: number | null = null;

  constructor() {
    this.#mesh.name = 'ground';
    this.#mesh.frustumCulled = false;
    // Before all else: only the background is multiplied.
    this.#mesh.renderOrder = Number.NEGATIVE_INFINITY;
  }

  /** Further frames would have a smoother shadow of the sky. */
  get unsettled(): boolean {
    return this.#shadow.unsettled;
  }

  /** Brings all up to date, and draws what the ground's material reads. */
  prepare(three: WebGPURenderer, scene: Scene, camera: PerspectiveCamera, settings: FrameSettings): void {
    const { ground, environment } = settings;
    if (!ground) return;
    scene.updateMatrixWorld();
    const haveMoved = this.#casters.update(scene);
    const { list } = this.#casters;
    if (haveMoved) {
      this.#bounds = boundsOf(list);
      this.#lowest = lowestOf(list);
    }
    const bounds = this.#bounds;
    const height = ground.height ?? this.#lowest;
    const isOther = this.#light.update(scene, environment?.source.type === 'sky');
    if (haveMoved || isOther || height !== this.#height) this.#shadow.restart(list, bounds, height);
    this.#height = height;
    this.#shadow.draw(three, scene, this.#light);
    const [x, z] = [0, 2].map((i) => (bounds.low[i]! + bounds.high[i]!) / 2) as [number, number];
    this.#material.rim.value.set(x, z, ground.radius, ground.fade);
    this.#material.strength.value = ground.strength;
    const eye = camera.matrixWorld.elements;
    this.#mesh.position.set(eye[12]!, height, eye[14]!);
    this.#mesh.scale.set(camera.far, 1, camera.far);
    this.#mesh.updateMatrixWorld();
  }

  /** Draws with the ground in the scene. */
  within<T>(scene: Scene, draw: () => T): T {
    scene.add(this.#mesh);
    try {
      return draw();
    } finally {
      scene.remove(this.#mesh);
    }
  }

  dispose(): void {
    this.#shadow.dispose();
    this.#material.dispose();
    this.#mesh.geometry.dispose();
  }
}

/** Of radius 1 about the origin, facing up. */
function disc(): BufferGeometry {
  const places = [0, 0, 0];
  for (let ring = 0; ring < RINGS; ring++)
    for (let i = 0; i < SECTORS; i++) {
      const angle = (2 * Math.PI * i) / SECTORS;
      const radius = 2 ** (ring - RINGS + 1);
      places.push(radius * Math.cos(angle), 0, radius * Math.sin(angle));
    }
  const vertex = (ring: number, i: number) => (ring < 0 ? 0 : 1 + ring * SECTORS + (i % SECTORS));
  const indices: number[] = [];
  for (let ring = 0; ring < RINGS; ring++)
    for (let i = 0; i < SECTORS; i++) {
      const [a, b, c, d] = [
        vertex(ring - 1, i),
        vertex(ring, i),
        vertex(ring, i + 1),
        vertex(ring - 1, i + 1),
      ];
      indices.push(a, c, b);
      if (ring > 0) indices.push(a, d, c);
    }
  const up = places.map((_, i) => (i % 3 === 1 ? 1 : 0));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(up), 3));
  geometry.setIndex(indices);
  return geometry;
}
