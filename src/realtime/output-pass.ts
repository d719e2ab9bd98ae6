import { renderOutput, texture, uniform, vec4 } from 'three/tsl';
import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  NeutralToneMapping,
  NodeMaterial,
  NoToneMapping,
  QuadMesh,
  SRGBColorSpace,
  type Texture,
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

/** From linear radiance to the sRGB values of a screen: exposure, tone mapping, encoding. */
export class OutputPass {
  readonly #exposure = uniform(1);
  readonly #quads = new Map<View['toneMapping'], QuadMesh>();

  constructor(readonly radiance: Texture) {}

  render(renderer: WebGPURenderer, { exposure, toneMapping }: Pick<View, 'exposure' | 'toneMapping'>): void {
    this.#exposure.value = 2 ** exposure;
    this.#quad(toneMapping).render(renderer);
  }

  dispose(): void {
    for (const { material } of this.#quads.values()) (material as NodeMaterial).dispose();
  }

  /** One for each tone mapping that was asked for, so that going back to one compiles nothing. */
  #quad(toneMapping: View['toneMapping']): QuadMesh {
    let quad = this.#quads.get(toneMapping);
    if (!quad) {
      const material = new NodeMaterial();
      material.name = `output ${toneMapping}`;
      const exposed = texture(this.radiance).rgb.mul(this.#exposure);
      material.fragmentNode = renderOutput(vec4(exposed, 1), TONE_MAPPINGS[toneMapping], SRGBColorSpace);
      quad = new QuadMesh(material);
      this.#quads.set(toneMapping, quad);
    }
    return quad;
  }
}
