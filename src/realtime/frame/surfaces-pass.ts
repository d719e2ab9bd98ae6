/** Depth, normals and motion of what the camera sees, before the scene is shaded. */
import {
  cameraProjectionMatrix,
  cross,
  dFdx,
  dFdy,
  dot,
  modelViewMatrix,
  mrt,
  normalView,
  positionLocal,
  positionView,
  uniform,
  vec4,
} from 'three/tsl';
import {
  DepthTexture,
  FloatType,
  HalfFloatType,
  Matrix4,
  NearestFilter,
  type Node,
  NodeMaterial,
  type Object3D,
  type PerspectiveCamera,
  RenderTarget,
  type Scene,
  type Texture,
  type WebGPURenderer,
} from 'three/webgpu';
import { toOctahedron } from '../effects/screen-space/octahedron.ts';

/**
 * The normals are the interpolated ones of the mesh: a normal map does not change where a surface is, which is what
 * those who read them ask. What is transparent is left out: what is behind it counts.
 */
export class SurfacesPass {
  readonly target: RenderTarget;
  readonly #material = new NodeMaterial();
  /**
   * World to clip space when this pass was last drawn. three.js' own velocity takes its camera over once for each frame of
   * the browser, whatever is drawn in it: a file's frames are drawn one after the other.
   */
  readonly #viewProjection = uniform(new Matrix4());
  /** Where the objects were that the last frame saw: what was hidden then, or not there, comes without motion. */
  #world = new Map<Object3D, Matrix4>();
  readonly #seen = new Set<Object3D>();
  #drawn = Number.NEGATIVE_INFINITY;
  readonly #outputs = mrt({
    normal: vec4(normalView, 1),
    velocity: vec4(this.#velocity(), toOctahedron(facing())),
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

  /** @param frame its number: motion is from the frame before, and none if that was not drawn */
  render(
    three: WebGPURenderer,
    scene: Scene,
    camera: PerspectiveCamera,
    width: number,
    height: number,
    frame: number,
  ): void {
    this.target.setSize(width, height);
    const isFirst = frame !== this.#drawn + 1;
    const now = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    if (isFirst) {
      this.#viewProjection.value.copy(now);
      this.#world.clear();
    }
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
      // What is cut out is: three.js hands on the rest that it takes.
      this.#material.opacity = material.opacity;
      this.#seen.add(object);
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
    this.#viewProjection.value.copy(now);
    const world = new Map<Object3D, Matrix4>();
    for (const object of this.#seen)
      world.set(object, (this.#world.get(object) ?? new Matrix4()).copy(object.matrixWorld));
    this.#world = world;
    this.#seen.clear();
    this.#drawn = frame;
  }

  /** In normalised device coordinates. */
  #velocity(): Node<'vec2'> {
    const world = uniform(new Matrix4()).onObjectUpdate(({ object }, self) => {
      const { value } = self as unknown as { value: Matrix4 };
      return value.copy(this.#world.get(object as Object3D) ?? (object as Object3D).matrixWorld);
    }) as unknown as Node<'mat4'>;
    const place = vec4(positionLocal, 1);
    const now = (cameraProjectionMatrix as Node<'mat4'>).mul(modelViewMatrix as Node<'mat4'>).mul(place);
    const before = (this.#viewProjection as unknown as Node<'mat4'>).mul(world).mul(place);
    const ndc = (clip: Node) => (clip as Node<'vec4'>).xy.div((clip as Node<'vec4'>).w);
    return ndc(now as unknown as Node).sub(ndc(before as unknown as Node)) as Node<'vec2'>;
  }

  dispose(): void {
    this.target.dispose();
    this.#material.dispose();
  }
}

/** The normal of the triangle, towards the camera, in view space. */
function facing(): Node<'vec3'> {
  const P = positionView as Node<'vec3'>;
  const plane = cross(dFdx(P) as Node<'vec3'>, dFdy(P) as Node<'vec3'>) as unknown as Node<'vec3'>;
  const unit = plane.mul(dot(plane, plane).max(1e-36).inverseSqrt());
  return unit.mul(dot(unit, P).greaterThan(0).select(-1, 1)) as Node<'vec3'>;
}
