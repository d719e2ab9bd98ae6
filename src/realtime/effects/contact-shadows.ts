/**
 * Short shadows where things touch: from each point that is shaded a few centimetres towards the lamp through what the
 * picture shows. Shadow maps are too coarse for these, and need a distance from the surface that cuts them off.
 */
import { float, If, normalViewGeometry, positionView, screenUV, uniform, vec2 } from 'three/tsl';
import type { Node, WebGPURenderer } from 'three/webgpu';
import type { FrameContext } from '../../material/frame-context.ts';
import { repeat } from '../../material/statements.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { type Guide, inline, ndcOf, placeOf, releaseGuide, takeGuide } from './screen-space/guide.ts';
import { gradientNoise } from './screen-space/noise.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** How far above the plane of a surface that is in its way must be, as a part of the distance: the surface itself is not. */
const ABOVE = 2e-3;
/** The last part of the length, over which what is found counts less and less. */
const FADE = 0.3;

class ContactShadows implements Effect {
  readonly context: FrameContext;
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #length = uniform(0.1);
  readonly #thickness = uniform(0.1);
  readonly #steps = uniform(12);

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
    this.#guide = takeGuide(inputs, 1);
    this.context = { contactShadow: (L) => this.#lit(L) };
  }

  update({ effects: { contactShadows } }: EffectSettings): void {
    this.#length.value = contactShadows.length;
    this.#thickness.value = contactShadows.thickness;
    this.#steps.value = contactShadows.steps;
  }

  beforeScene(renderer: WebGPURenderer): void {
    this.#guide.render(renderer);
  }

  dispose(): void {
    releaseGuide(this.#inputs, this.#guide);
  }

  /** The part of a lamp's light that arrives. */
  #lit(L: Vec3): Float {
    const guide = this.#guide;
    return inline(() => {
      const P = (positionView as Vec3).toVar() as Vec3;
      const N = (normalViewGeometry as unknown as Vec3).toVar() as Vec3;
      const least = P.z.mul(-ABOVE).toVar() as Float;
      const shift = gradientNoise(
        (screenUV as unknown as Vec2).mul(guide.size).floor() as Vec2,
      ).toVar() as Float;
      const blocked = float(0).toVar() as Float;
      repeat(this.#steps as unknown as Float, (i) => {
        const t = i.add(shift).add(0.5).div(this.#steps).min(1).toVar() as Float;
        const S = P.add(L.mul(t.mul(this.#length))).toVar() as Vec3;
        const at = placeOf(ndcOf(this.#inputs, S)).toVar() as Vec2;
        const inside = at
          .greaterThan(vec2(0))
          .all()
          .and(at.lessThan(vec2(1)).all());
        If(inside.and(S.z.lessThan(0)), () => {
          const distance = (guide.sample(at) as Vec4).w.toVar() as Float;
          const behind = S.z.negate().sub(distance).toVar() as Float;
          const above = guide.position(at, distance).sub(P).dot(N) as Float;
          If(
            behind.greaterThan(0).and(behind.lessThan(this.#thickness)).and(above.greaterThan(least)),
            () => {
              blocked.assign(blocked.max(t.oneMinus().div(FADE).min(1)));
            },
          );
        });
      });
      return blocked.oneMinus() as Float;
    });
  }
}

export const contactShadows: EffectDefinition = {
  name: 'contactShadows',
  isOn: ({ effects }) => effects.contactShadows.enabled,
  needsSurfaces: true,
  build: (inputs) => new ContactShadows(inputs),
};
