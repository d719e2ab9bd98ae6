import { renderOutput, select, texture, uniform, uv, vec4 } from 'three/tsl';
import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  NeutralToneMapping,
  NodeMaterial,
  NoToneMapping,
  QuadMesh,
  SRGBColorSpace,
  type Texture,
  type TextureNode,
  type ToneMapping,
  type WebGPURenderer,
} from 'three/webgpu';
import type { View } from '../scene/schema.ts';

const TONE_MAPPINGS: Readonly<Record<View['toneMapping'], ToneMapping>> = {
  none: NoToneMapping,
  aces: ACESFilmicToneMapping,
  agx: AgXToneMapping,
  neutral: NeutralToneMapping,
};

/** Linear radiance from elsewhere, such as a path traced picture, for the right part of the frame. */
export interface Companion {
  readonly radiance: Texture;
  /** The part of the width at which it begins: 0 shows it alone. */
  readonly from: number;
}

/** From linear radiance to the sRGB values of a screen: exposure, tone mapping, encoding. */
export class OutputPass {
  readonly #exposure = uniform(1);
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
    { exposure, toneMapping }: Pick<View, 'exposure' | 'toneMapping'>,
    companion: Companion | null = null,
  ): void {
    this.#radiance.value = radiance;
    this.#exposure.value = 2 ** exposure;
    if (companion !== null) {
      this.#companion ??= texture(companion.radiance);
      this.#companion.value = companion.radiance;
      this.#from.value = companion.from;
    }
    this.#quad(toneMapping, companion === null ? null : this.#companion).render(renderer);
  }

  dispose(): void {
    for (const { material } of this.#quads.values()) (material as NodeMaterial).dispose();
  }

  /** One for each tone mapping that was asked for, so that going back to one compiles nothing. */
  #quad(toneMapping: View['toneMapping'], companion: TextureNode<'vec4'> | null): QuadMesh {
    const key = companion === null ? toneMapping : `${toneMapping} beside another`;
    let quad = this.#quads.get(key);
    if (!quad) {
      const material = new NodeMaterial();
      material.name = `output ${key}`;
      const own = this.#radiance.rgb;
      const shown = companion === null ? own : select(uv().x.lessThan(this.#from), own, companion.rgb);
      const exposed = shown.mul(this.#exposure);
      material.fragmentNode = renderOutput(vec4(exposed, 1), TONE_MAPPINGS[toneMapping], SRGBColorSpace);
      quad = new QuadMesh(material);
      this.#quads.set(key, quad);
    }
    return quad;
  }
}
