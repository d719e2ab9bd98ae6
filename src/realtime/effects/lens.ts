/**
 * Faults of a real lens: colours that are thrown to different sizes (lateral chromatic aberration), and the light that a
 * simple lens loses towards the corners. Dirt on it is a part of bloom.
 */
import { dot, float, mix, uniform, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, RenderTarget, WebGPURenderer } from 'three/webgpu';
import type { Effect, EffectDefinition, EffectSettings } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { inputTexture, Pass } from '../frame/pass.ts';

type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Looks at the spectrum: enough that fringes are smooth up to some ten pixels. */
const COLORS = 9;

/** What each look gives, from red to blue: each channel a hat of its own third, in sum 1, so that white stays white. */
const WEIGHTS = Array.from({ length: COLORS }, (_, i) => {
  const at = i / (COLORS - 1);
  return [0, 0.5, 1].map((centre) => Math.max(0, 1 - 2 * Math.abs(at - centre)));
}).map((weights, _, all) => weights.map((w, c) => w / all.reduce((sum, other) => sum + other[c]!, 0)));

class Lens implements Effect {
  readonly #dispersion = uniform(0);
  readonly #vignette = uniform(0);
  readonly #source = inputTexture();
  readonly #pass: Pass;

  constructor({ projectionInverse, part }: FrameInputs) {
    // From the middle of the picture, of which the frame may be a part.
    const middle = uv().mul(part.zw).add(part.xy).sub(0.5) as Vec2;
    let color: Vec3 = vec3(0) as Vec3;
    for (const [i, weights] of WEIGHTS.entries()) {
      // Red is thrown larger than blue, by half of the dispersion each.
      const scale = this.#dispersion.mul(0.5 - i / (COLORS - 1)).oneMinus();
      const look = this.#source.sample(middle.mul(scale).add(0.5).sub(part.xy).div(part.zw)).rgb;
      color = color.add(look.mul(vec3(...(weights as [number, number, number])))) as Vec3;
    }
    const place = uv().mul(vec2(2, -2)).add(vec2(-1, 1));
    const ray = projectionInverse.mul(vec4(place, 1, 1)) as unknown as Node<'vec4'>;
    const tangent = ray.xy.div(ray.z) as Vec2;
    // cos^4 of the angle to the axis: inclined aperture, inclined sensor, and twice the longer way.
    const cosine2 = float(1).div(dot(tangent, tangent).add(1));
    const light = mix(float(1), cosine2.mul(cosine2), this.#vignette);
    this.#pass = new Pass('lens', vec4(color.mul(light), this.#source.a));
  }

  update({ effects: { lens } }: EffectSettings): void {
    this.#dispersion.value = lens.dispersion;
    this.#vignette.value = lens.vignette;
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    this.#source.value = input.texture;
    return this.#pass.render(renderer, input.width, input.height);
  }

  dispose(): void {
    this.#pass.dispose();
  }
}

export const lens: EffectDefinition = {
  name: 'lens',
  isOn: ({ effects }) => effects.lens.enabled && (effects.lens.dispersion > 0 || effects.lens.vignette > 0),
  needsSurfaces: false,
  build: (inputs) => new Lens(inputs),
};
