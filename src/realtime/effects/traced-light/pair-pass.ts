import { outputStruct, property } from 'three/tsl';
import {
  HalfFloatType,
  NearestFilter,
  type Node,
  NodeMaterial,
  QuadMesh,
  RenderTarget,
  type Texture,
  type WebGPURenderer,
} from 'three/webgpu';

type Vec4 = Node<'vec4'>;

/** Two textures of one size: of wide lobes, and of highlights. */
export interface Pair {
  readonly wide: Texture;
  readonly sharp: Texture;
}

export function pairTarget(name: string, depthBuffer = false): RenderTarget {
  const target = new RenderTarget(1, 1, {
    count: 2,
    type: HalfFloatType,
    depthBuffer,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  target.textures[0]!.name = `${name} wide`;
  target.textures[1]!.name = `${name} sharp`;
  return target;
}

export const pairOf = ({ textures }: RenderTarget): Pair => ({ wide: textures[0]!, sharp: textures[1]! });

/** One full-screen draw into a pair of textures. */
export class PairPass {
  readonly target: RenderTarget;
  readonly #material = new NodeMaterial();
  readonly #quad: QuadMesh;

  /** @param body runs in the shader; what it returns is written */
  constructor(name: string, body: (write: (wide: Node, sharp: Node) => void) => Vec4) {
    this.target = pairTarget(name);
    const [wide, sharp] = [property('vec4', 'pairWide'), property('vec4', 'pairSharp')];
    this.#material.name = name;
    this.#material.colorNode = body((first, second) => {
      (wide as unknown as Vec4 & { assign(value: Node): void }).assign(first);
      (sharp as unknown as Vec4 & { assign(value: Node): void }).assign(second);
    });
    this.#material.outputNode = outputStruct(wide as unknown as Node, sharp as unknown as Node);
    this.#quad = new QuadMesh(this.#material);
    this.#quad.name = name;
  }

  render(renderer: WebGPURenderer, width: number, height: number): Pair {
    this.target.setSize(width, height);
    const previous = renderer.getRenderTarget();
    renderer.setRenderTarget(this.target);
    this.#quad.render(renderer);
    renderer.setRenderTarget(previous);
    return pairOf(this.target);
  }

  dispose(): void {
    this.target.dispose();
    this.#material.dispose();
  }
}
