import {
  cameraWorldMatrix,
  cubeTexture,
  float,
  materialEnvIntensity,
  materialEnvRotation,
  uniform,
  vec4,
} from 'three/tsl';
import {
  CubeRenderTarget,
  type CubeTexture,
  HalfFloatType,
  LightingNode,
  LinearMipmapLinearFilter,
  type Node,
  type NodeBuilder,
  type NodeFrame,
  NodeUpdateType,
  type Renderer,
  type Scene,
  type Texture,
} from 'three/webgpu';

type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** Faces of the cube that an environment is resampled to; 4 pi / (6 * 256^2) is about (0.3 degrees)^2. */
const FACE_SIZE = 256;

const cubes = new WeakMap<Renderer, WeakMap<Texture, { version: number; target: CubeRenderTarget }>>();

/**
 * The scene's environment, or the material's own, as a cube of radiance with mip levels: what filtered importance sampling reads
 * (J. Krivanek and M. Colbert, 2008, "Real-time Shading with Filtered Importance Sampling", CGF 27(4)).
 */
export class EnvironmentLightNode extends LightingNode {
  static get type(): string {
    return 'EnvironmentLightNode';
  }

  private readonly cube = cubeTexture();
  private readonly faceSize = uniform(FACE_SIZE);

  constructor() {
    super();
    this.updateBeforeType = NodeUpdateType.OBJECT;
  }

  override updateBefore(frame: NodeFrame): undefined {
    const { renderer, scene, material } = frame as unknown as {
      renderer: Renderer;
      scene: Scene | null;
      material: { envMap?: Texture | null } | null;
    };
    const environment = material?.envMap ?? scene?.environment;
    if (!environment) return;
    const cube = radianceCube(renderer, environment);
    (this.cube as unknown as { value: Texture }).value = cube.texture;
    this.faceSize.value = cube.size;
  }

  override setup(builder: NodeBuilder): null {
    this.updateBefore(builder as unknown as NodeFrame);
    return null;
  }

  /**
   * Radiance from a direction in view space, averaged over the solid angle 1/density about it.
   *
   * @param density in 1/sr: the number of samples times their pdf
   */
  radiance(direction: Vec3, density: Float): Vec3 {
    const world = (cameraWorldMatrix as unknown as Node<'mat4'>).mul(vec4(direction, 0)).xyz as Vec3;
    const rotated = (materialEnvRotation as unknown as Node<'mat4'>).mul(vec4(world, 0)).xyz as Vec3;
    // A texel's mean solid angle is 4 pi / (6 size^2); half the binary logarithm of the ratio is the level
    // whose texels are as large as the sample (Krivanek and Colbert, 2008, equation 12).
    const texels = float(6 / (4 * Math.PI))
      .mul(this.faceSize)
      .mul(this.faceSize);
    const level = texels.div(density).max(1).log2().mul(0.5);
    const texel = (this.cube as unknown as { sample(uv: Node): { level(level: Node): Node<'vec4'> } })
      .sample(rotated)
      .level(level);
    return texel.rgb.mul(materialEnvIntensity as unknown as Float) as Vec3;
  }
}

function radianceCube(renderer: Renderer, environment: Texture): { texture: Texture; size: number } {
  if ((environment as CubeTexture).isCubeTexture) {
    const image = (environment as CubeTexture).image as { width?: number }[] | undefined;
    return { texture: environment, size: image?.[0]?.width ?? FACE_SIZE };
  }
  const known = cubes.get(renderer) ?? new WeakMap<Texture, { version: number; target: CubeRenderTarget }>();
  cubes.set(renderer, known);
  let cube = known.get(environment);
  if (!cube) {
    environment.addEventListener('dispose', () => {
      known.get(environment)?.target.dispose();
      known.delete(environment);
    });
  }
  if (cube?.version !== environment.version) {
    cube?.target.dispose();
    cube = { version: environment.version, target: resample(renderer, environment) };
    known.set(environment, cube);
  }
  return { texture: cube.target.texture, size: FACE_SIZE };
}

function resample(renderer: Renderer, environment: Texture): CubeRenderTarget {
  const target = new CubeRenderTarget(FACE_SIZE, { type: HalfFloatType, generateMipmaps: true });
  // The target takes its filters from its source, which itself needs no mip levels.
  const { minFilter, generateMipmaps } = environment;
  environment.minFilter = LinearMipmapLinearFilter;
  target.fromEquirectangularTexture(renderer as never, environment);
  environment.minFilter = minFilter;
  environment.generateMipmaps = generateMipmaps;
  return target;
}
