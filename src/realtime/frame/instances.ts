/** Meshes that have a geometry and a material in common, drawn as one: three.js spends its time for each mesh that it draws. */
import {
  type BufferGeometry,
  DynamicDrawUsage,
  InstancedMesh,
  type Material,
  type Mesh,
  type Vector3,
} from 'three/webgpu';

/** Room is made for several times as many as there are, so that it is seldom made anew. */
const ROOM = 4;

export class Instances {
  readonly #geometry: BufferGeometry;
  readonly #material: Material;
  #mesh: InstancedMesh | null = null;
  /** What it was before there was more room: it shares what three.js has built for it until the next one is drawn. */
  readonly #outgrown: InstancedMesh[] = [];

  constructor(geometry: BufferGeometry, material: Material) {
    this.#geometry = geometry;
    this.#material = material;
  }

  /** What is drawn, with room for so many at least. */
  meshFor(count: number): InstancedMesh {
    const mesh = this.#mesh;
    if (mesh && mesh.instanceMatrix.count >= count) return mesh;
    if (mesh) this.#outgrown.push(mesh);
    this.#mesh = new InstancedMesh(this.#geometry, this.#material, 2 ** Math.ceil(Math.log2(ROOM * count)));
    // three.js then copies them to the GPU for each frame, without being told.
    this.#mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.#mesh.count = 0;
    // Its bounds are nobody's.
    this.#mesh.frustumCulled = false;
    this.#mesh.matrixAutoUpdate = false;
    this.#mesh.matrixWorldAutoUpdate = false;
    return this.#mesh;
  }

  /**
   * Puts the instances where meshes are, whose world matrices are up to date.
   *
   * @param origin that they are placed from, such as the camera: float32 is exact near it
   */
  place(meshes: readonly Mesh[], origin: Vector3): void {
    const mesh = this.meshFor(meshes.length);
    mesh.count = meshes.length;
    mesh.matrixWorld.makeTranslation(origin);
    const { array } = mesh.instanceMatrix;
    let at = 0;
    for (const { matrixWorld } of meshes) {
      const { elements } = matrixWorld;
      for (let i = 0; i < 16; i++)
        array[at++] = i < 12 || i === 15 ? elements[i]! : elements[i]! - origin.getComponent(i - 12);
    }
  }

  /** To be called when a frame has been drawn. */
  tidy(): void {
    for (const mesh of this.#outgrown.splice(0)) mesh.dispose();
  }

  dispose(): void {
    this.tidy();
    this.#mesh?.dispose();
    this.#mesh = null;
  }
}
