/** Depth, normal and motion of what the camera sees, before the scene is shaded. */
import { mrt, normalView, vec4, velocity } from 'three/tsl';
import {
  DepthTexture,
  FloatType,
  HalfFloatType,
  NearestFilter,
  type Node,
  NodeMaterial,
  type PerspectiveCamera,
  RenderTarget,
  type Scene,
  type Texture,
  type WebGPURenderer,
} from 'three/webgpu';

/**
 * The normals are the interpolated ones of the mesh: a normal map does not change where a surface is, which is what
 * those who read them ask. What is transparent is left out: what is behind it counts.
 */
export class SurfacesPass {
  readonly target: RenderTarget;
  readonly #material = new NodeMaterial();
  readonly #outputs = mrt({
    normal: vec4(normalView, 1),
    velocity: vec4(velocity as unknown as Node<'vec2'>, 0, 1),
  });

  constructor() {
    this.target = new RenderTarget(1, 1, {
      count: 2,
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    this.target.textures[0]!.name = 'normal';
    this.target.textures[1]!.name = 'velocity';
    this.target.depthTexture = new DepthTexture(1, 1, FloatType);
    this.#material.name = 'surfaces';
  }

  get depth(): DepthTexture {
    return this.target.depthTexture as DepthTexture;
  }

  get normal(): Texture {
    return this.target.textures[0]!;
  }

  get velocity(): Texture {
    return this.target.textures[1]!;
  }

  render(
    three: WebGPURenderer,
    scene: Scene,
    camera: PerspectiveCamera,
    width: number,
    height: number,
  ): void {
    this.target.setSize(width, height);
    const { overrideMaterial, background } = scene;
    scene.overrideMaterial = this.#material;
    scene.background = null;
    const { transparent } = three;
    const shadows = three.shadowMap.enabled;
    three.transparent = false;
    three.shadowMap.enabled = false;
    const draw = three.getRenderObjectFunction();
    three.setRenderObjectFunction((object, ofScene, ofCamera, geometry, material, ...rest) => {
      this.#material.side = material.side;
      three.renderObject(object, ofScene, ofCamera, geometry, material, ...rest);
    });
    three.setMRT(this.#outputs);
    three.setRenderTarget(this.target);
    three.render(scene, camera);
    three.setRenderTarget(null);
    three.setMRT(null);
    three.setRenderObjectFunction(draw);
    three.transparent = transparent;
    three.shadowMap.enabled = shadows;
    scene.overrideMaterial = overrideMaterial;
    scene.background = background;
  }

  dispose(): void {
    this.target.dispose();
    this.#material.dispose();
  }
}
