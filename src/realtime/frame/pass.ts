import { texture, vec4 } from 'three/tsl';
import {
  HalfFloatType,
  type Node,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  Texture,
  type TextureDataType,
  type TextureNode,
  type WebGPURenderer,
} from 'three/webgpu';
import { BRIGHTEST_HALF } from '../../material/half-float.ts';

/** One full-screen draw into a target of its own. */
export class Pass {
  readonly target: RenderTarget;
  readonly #quad: QuadMesh;

  /** @param name for those who read timings and traces */
  constructor(name: string, fragment: Node, { type = HalfFloatType }: { type?: TextureDataType } = {}) {
    this.target = new RenderTarget(1, 1, { type, depthBuffer: false });
    this.target.texture.name = name;
    const material = new NodeMaterial();
    material.name = name;
    material.fragmentNode = type === HalfFloatType ? withinHalf(fragment) : fragment;
    this.#quad = new QuadMesh(material);
    this.#quad.name = name;
  }

  render(renderer: WebGPURenderer, width: number, height: number): RenderTarget {
    this.target.setSize(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
    const previous = renderer.getRenderTarget();
    renderer.setRenderTarget(this.target);
    this.#quad.render(renderer);
    renderer.setRenderTarget(previous);
    return this.target;
  }

  dispose(): void {
    this.target.dispose();
    (this.#quad.material as NodeMaterial).dispose();
  }
}

/** What half floats can hold: of what is brighter GPUs make infinities, and of those the next pass NaN, which filters spread. */
function withinHalf(value: Node): Node {
  return vec4(value as Node<'vec4'>).clamp(-BRIGHTEST_HALF, BRIGHTEST_HALF);
}

/** A texture that a pass reads and that is given to it in every frame: set its value before it is drawn. */
export function inputTexture(): TextureNode<'vec4'> {
  return texture(new Texture());
}

/** Copies a picture as it is, to a target or, for null, to the canvas. */
export class CopyPass {
  readonly #source = inputTexture();
  readonly #quad = new QuadMesh(new NodeMaterial());

  constructor() {
    (this.#quad.material as NodeMaterial).fragmentNode = this.#source;
  }

  render(renderer: WebGPURenderer, source: RenderTarget, target: RenderTarget | null): void {
    this.#source.value = source.texture;
    const previous = renderer.getRenderTarget();
    renderer.setRenderTarget(target);
    this.#quad.render(renderer);
    renderer.setRenderTarget(previous);
  }

  dispose(): void {
    (this.#quad.material as NodeMaterial).dispose();
  }
}
