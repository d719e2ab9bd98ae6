/**
 * Views of what is behind a picture, as numbers: readRadiance() gives them as they are, the output pass as colours.
 * Directions are in world space, distances in metres along the view, motion in pixels a frame; alpha is 1 where there
 * is a surface.
 */
import { float, normalView, uv, vec2, vec3, vec4 } from 'three/tsl';
import {
  AddEquation,
  CustomBlending,
  FloatType,
  type Node,
  type NodeBuilder,
  NodeMaterial,
  OneFactor,
  type PerspectiveCamera,
  type RenderTarget,
  type Scene,
  type WebGPURenderer,
} from 'three/webgpu';
import { BrdfMaterial } from '../material/brdf-material.ts';
import { fragmentData } from '../material/fragment-data.ts';
import { frameContext } from '../material/frame-context.ts';
import type { View } from '../scene/schema.ts';
import type { FrameInputs } from './frame/inputs.ts';
import { Pass } from './frame/pass.ts';

type Show = View['show'];
type Vec3 = Node<'vec3'>;

/** Those that the surfaces pass has already. */
const OF_SURFACES: readonly Show[] = ['depth', 'meshNormals', 'motion'];
/** Those that materials say themselves. */
const OF_MATERIALS: readonly Show[] = [
  'shadingNormals',
  'tangents',
  'textureCoordinates',
  'lights',
  'cascades',
  'ambientOcclusion',
];

export class DataViews {
  readonly #inputs: FrameInputs;
  readonly #passes = new Map<Show, Pass>();
  readonly #contexts = new Map<Show, Readonly<Record<string, unknown>>>();
  readonly #layer = layerMaterial();

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
  }

  needsSurfaces(show: Show): boolean {
    return OF_SURFACES.includes(show);
  }

  /** What all materials are told. */
  context(show: Show): Readonly<Record<string, unknown>> {
    if (!OF_MATERIALS.includes(show)) return {};
    let context = this.#contexts.get(show);
    if (!context) {
      context = {
        fragmentData: true,
        // three.js has shaded already, into its variable `output`: what the material has set on the way is there.
        getOutput: (own: Node, builder: NodeBuilder) =>
          builder.material instanceof BrdfMaterial ? vec4(this.#ofMaterial(show, builder), 1) : own,
      };
      this.#contexts.set(show, context);
    }
    return context;
  }

  draw(
    three: WebGPURenderer,
    show: Show,
    scene: Scene,
    camera: PerspectiveCamera,
    target: RenderTarget,
  ): RenderTarget {
    if (OF_SURFACES.includes(show)) {
      let pass = this.#passes.get(show);
      if (!pass) {
        pass = new Pass(show, this.#ofSurfaces(show), { type: FloatType });
        this.#passes.set(show, pass);
      }
      return pass.render(three, target.width, target.height);
    }
    const { background, overrideMaterial } = scene;
    const draw = three.getRenderObjectFunction();
    scene.background = null;
    if (show === 'overdraw') {
      scene.overrideMaterial = this.#layer;
      three.setRenderObjectFunction((object, ofScene, ofCamera, geometry, material, ...rest) => {
        this.#layer.side = material.side;
        three.renderObject(object, ofScene, ofCamera, geometry, material, ...rest);
      });
    }
    three.setRenderTarget(target);
    three.render(scene, camera);
    three.setRenderTarget(null);
    three.setRenderObjectFunction(draw);
    scene.background = background;
    scene.overrideMaterial = overrideMaterial;
    return target;
  }

  dispose(): void {
    for (const pass of this.#passes.values()) pass.dispose();
    this.#layer.dispose();
  }

  #ofSurfaces(show: Show): Node {
    const { depth, normal, velocity, near, far, size } = this.#inputs;
    const isSurface = float(depth.r.lessThan(1)) as unknown as Node<'float'>;
    if (show === 'meshNormals') return vec4(this.#toWorld(normal.rgb), 1).mul(isSurface);
    // Rows count from the top.
    if (show === 'motion') return vec4(velocity.rg.mul(size).mul(vec2(0.5, -0.5)), 0, 1).mul(isSurface);
    // 1/z is linear in the depth, on both back ends.
    const distance = depth.r.oneMinus().div(near).add(depth.r.div(far)).reciprocal();
    return vec4(vec3(distance), 1).mul(isSurface);
  }

  #ofMaterial(show: Show, builder: NodeBuilder): Vec3 {
    if (show === 'lights') return vec3(fragmentData.lamps) as Vec3;
    if (show === 'cascades') return vec3(fragmentData.cascade) as Vec3;
    // All is open where nothing is known of what is around.
    if (show === 'ambientOcclusion')
      return vec3(frameContext(builder).openSky?.().visibility ?? float(1)) as Vec3;
    if (show === 'tangents') return this.#toWorld(fragmentData.tangent);
    if (show === 'shadingNormals') return this.#toWorld(normalView as Vec3);
    const has = (builder as unknown as { geometry: { hasAttribute(name: string): boolean } }).geometry;
    return has.hasAttribute('uv') ? (vec3(uv(), 0) as Vec3) : (vec3(0) as Vec3);
  }

  #toWorld(direction: Vec3): Vec3 {
    const { viewInverse } = this.#inputs;
    return (viewInverse.mul(vec4(direction, 0)) as unknown as Node<'vec4'>).xyz as Vec3;
  }
}

/** Adds 1 wherever it is drawn. */
function layerMaterial(): NodeMaterial {
  const material = new NodeMaterial();
  material.name = 'overdraw';
  material.fragmentNode = vec4(1);
  material.blending = CustomBlending;
  material.blendEquation = AddEquation;
  material.blendSrc = OneFactor;
  material.blendDst = OneFactor;
  return material;
}
