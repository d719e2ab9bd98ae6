/** The last frame's radiance, which rays find: finite, with coarser levels, of surfaces alone. */
import { Fn, float, select, uv, vec4 } from 'three/tsl';
import {
  LinearFilter,
  LinearMipmapLinearFilter,
  type Node,
  type RenderTarget,
  type WebGPURenderer,
} from 'three/webgpu';
import type { FrameInputs } from '../../frame/inputs.ts';
import { inputTexture, Pass } from '../../frame/pass.ts';
import { texelAt } from '../screen-space/guide.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Half the largest half float: a mean of several is one, too. */
const MOST = 3e4;

export class RadianceHistory {
  readonly #source = inputTexture();
  readonly #pass: Pass;
  #kept = false;

  constructor({ depth }: FrameInputs) {
    const fragment = Fn(() => {
      const radiance = this.#source.rgb.toVar() as Vec3;
      // What is not a number is not at least 0, either.
      const finite = (x: Float) => select(x.greaterThanEqual(0), x.min(MOST), float(0)) as unknown as Float;
      const surface = select(depth.sample(uv()).r.lessThan(1), float(1), float(0)) as unknown as Float;
      const [r, g, b] = [radiance.x, radiance.y, radiance.z].map((x) => finite(x as Float).mul(surface));
      return vec4(r as Float, g as Float, b as Float, surface);
    })();
    this.#pass = new Pass('radiance history', fragment as unknown as Node);
    Object.assign(this.#pass.target.texture, {
      generateMipmaps: true,
      minFilter: LinearMipmapLinearFilter,
      magFilter: LinearFilter,
    });
  }

  /** Whether there is one, as large as a frame is now. */
  isOf(width: number, height: number): boolean {
    const { target } = this.#pass;
    return this.#kept && target.width === width && target.height === height;
  }

  keep(renderer: WebGPURenderer, input: RenderTarget): void {
    this.#source.value = input.texture;
    this.#pass.render(renderer, input.width, input.height);
    this.#kept = true;
  }

  /** Radiance about a place, and the part of it that surfaces fill. @param level of the texture's, 0 is the finest */
  sample(place: Vec2, level: Float): Vec4 {
    const texel = texelAt(this.#pass.target.texture, place, level).toVar() as Vec4;
    return vec4(texel.rgb.div(texel.a.max(1e-3)), texel.a) as unknown as Vec4;
  }

  dispose(): void {
    this.#pass.dispose();
  }
}
