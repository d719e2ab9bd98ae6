/**
 * Which meshes a frame would have to build shaders, bindings and buffers for. three.js does that while it draws, however many there
 * are; what is found here is compiled first, in pieces between which the page stays alive.
 */
import {
  type BufferGeometry,
  InstancedMesh,
  Light,
  type Material,
  type Mesh,
  type Scene,
} from 'three/webgpu';

/** What a mesh was drawn with. */
interface Drawn {
  readonly material: Material;
  readonly version: number;
  readonly geometry: BufferGeometry;
  /** What shaders sum over: which lights there were, and which environment. */
  readonly lighting: string;
}

/** So many with materials that others have been drawn with are drawn at once: a quarter of a millisecond each. */
const FEW = 40;

export class UnreadyMeshes {
  #drawn = new WeakMap<Mesh, Drawn>();
  /** Materials that have a shader, and for which lighting: one for meshes, one for instances. */
  readonly #shaders = [new WeakMap<Material, string>(), new WeakMap<Material, string>()] as const;
  #environment = 0;

  /** Another environment has come, which may be at any time: all meshes need other shaders. */
  hasOtherEnvironment(scene: Scene): boolean {
    return environmentOf(scene) !== this.#environment;
  }

  /**
   * Those that are worth compiling ahead of the next frame; all count as drawn from then on.
   *
   * @param meshes that the scene is drawn with
   */
  take(scene: Scene, meshes: readonly Mesh[]): readonly Mesh[] {
    const lightIds: number[] = [];
    scene.traverseVisible((object) => {
      if (object instanceof Light) lightIds.push(object.id);
    });
    this.#environment = environmentOf(scene);
    const lighting = `${lightIds} ${this.#environment}`;
    const unready = meshes.filter((mesh) => {
      const drawn = this.#drawn.get(mesh);
      const { material, geometry } = mesh as Mesh<BufferGeometry, Material>;
      return (
        drawn?.material !== material ||
        drawn.version !== material.version ||
        drawn.geometry !== geometry ||
        drawn.lighting !== lighting
      );
    });
    const shaderOf = (material: Material) => `${material.version} ${lighting}`;
    const shadersOf = (mesh: Mesh) => this.#shaders[mesh instanceof InstancedMesh ? 1 : 0];
    const isNew = unready.some((mesh) => {
      const material = mesh.material as Material;
      return shadersOf(mesh).get(material) !== shaderOf(material);
    });
    for (const mesh of unready) {
      const { material, geometry } = mesh as Mesh<BufferGeometry, Material>;
      this.#drawn.set(mesh, { material, version: material.version, geometry, lighting });
      shadersOf(mesh).set(material, shaderOf(material));
    }
    return isNew || unready.length > FEW ? unready : [];
  }
}

const environmentOf = ({ environment }: Scene): number => environment?.id ?? 0;
