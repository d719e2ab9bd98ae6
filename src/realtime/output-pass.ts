import { select, texture, uniform, uv } from 'three/tsl';
import {
  type Node,
  NodeMaterial,
  QuadMesh,
  type Texture,
  type TextureNode,
  type WebGPURenderer,
} from 'three/webgpu';
import type { View } from '../scene/schema.ts';
import { displayNode, showsLight } from './display.ts';

/** Linear radiance from elsewhere, such as a path traced picture, for the right part of the frame. */
export interface Companion {
  readonly radiance: Texture;
  /** The part of the width at which it begins: 0 shows it alone. */
  readonly from: number;
}

export interface Display {
  /** In EV: the radiance is multiplied by 2 to this power. */
  readonly exposure: number;
  readonly toneMapping: View['toneMapping'];
  readonly show?: View['show'];
  /** In metres, that is half grey where distances are shown. */
  readonly distance?: number;
  /** The picture has alpha, multiplied in. */
  readonly transparent?: boolean;
}

/** From linear radiance to the sRGB values of a screen: exposure, tone mapping, encoding. */
export class OutputPass {
  readonly #exposure = uniform(1);
  readonly #distance = uniform(1);
  readonly #from = uniform(0);
  readonly #quads = new Map<string, QuadMesh>();
  readonly #radiance: TextureNode<'vec4'>;
  #companion: TextureNode<'vec4'> | null = null;

  constructor(radiance: Texture) {
    this.#radiance = texture(radiance);
  }

  render(
    renderer: WebGPURenderer,
    radiance: Texture,
    { exposure, toneMapping, show = 'picture', distance = 1, transparent = false }: Display,
    companion: Companion | null = null,
  ): void {
    this.#radiance.value = radiance;
    this.#exposure.value = 2 ** exposure;
    this.#distance.value = distance;
    const hasCompanion = companion !== null && showsLight(show);
    if (hasCompanion) {
      this.#companion ??= texture(companion.radiance);
      this.#companion.value = companion.radiance;
      this.#from.value = companion.from;
    }
    this.#quad(show, toneMapping, transparent, hasCompanion ? this.#companion : null).render(renderer);
  }

  dispose(): void {
    for (const { material } of this.#quads.values()) (material as NodeMaterial).dispose();
  }

  /** One for each that was asked for, so that going back to one compiles nothing. */
  #quad(
    show: View['show'],
    toneMapping: View['toneMapping'],
    transparent: boolean,
    companion: TextureNode<'vec4'> | null,
  ): QuadMesh {
    const shown = show === 'picture' ? `${toneMapping}${transparent ? ' with alpha' : ''}` : show;
    const key = companion === null ? shown : `${shown} beside another`;
    let quad = this.#quads.get(key);
    if (!quad) {
      const material = new NodeMaterial();
      material.name = `output ${key}`;
      const own: Node<'vec4'> = this.#radiance;
      const pixel = companion === null ? own : select(uv().x.lessThan(this.#from), own, companion);
      material.fragmentNode = displayNode(show, toneMapping, pixel as Node<'vec4'>, {
        exposure: this.#exposure,
        distance: this.#distance,
        transparent,
      });
      quad = new QuadMesh(material);
      this.#quads.set(key, quad);
    }
    return quad;
  }
}
