import { ivec2, texture, vec4 } from 'three/tsl';
import {
  HalfFloatType,
  LinearFilter,
  NearestFilter,
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

export interface PassOptions {
  type?: TextureDataType;
  /** Whether it is looked at between its texels' middles; where it is not, that four are mixed costs for nothing. */
  isBlended?: boolean;
}

/** One full-screen draw into a target of its own. */
export class Pass {
  readonly target: RenderTarget;
  readonly #quad: QuadMesh;

  /** @param name for those who read timings and traces */
  constructor(name: string, fragment: Node, { type = HalfFloatType, isBlended = true }: PassOptions = {}) {
    const filter = isBlended ? LinearFilter : NearestFilter;
    this.target = new RenderTarget(1, 1, { type, depthBuffer: false, minFilter: filter, magFilter: filter });
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

/** The texel of a picture at a pixel, of those at its border for those beyond it. @param size of the picture, in pixels */
export function pixelOf(source: TextureNode<'vec4'>, pixel: Node<'vec2'>, size: Node<'vec2'>): Node<'vec4'> {
  return source.load(ivec2(pixel.clamp(0, size.sub(1)) as Node<'vec2'>)) as unknown as Node<'vec4'>;
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
