/**
 * Short shadows where things touch: from each point that is shaded a few centimetres towards the lamp through what the
 * picture shows. Shadow maps are too coarse for these, and need a distance from the surface that cuts them off.
 */
import { float, If, uniform, vec2 } from 'three/tsl';
import type { Node, WebGPURenderer } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import type { Effects } from '../../../scene/effects-schema.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { type Guide, inline, ndcOf, placeOf, releaseGuide, takeGuide } from '../screen-space/guide.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** How far above the plane of a surface that is in its way must be, as a part of the distance: the surface itself is not. */
const ABOVE = 2e-3;
/** The last part of the length, over which what is found counts less and less. */
const FADE = 0.3;

export class ContactShadows {
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #length = uniform(0.1);
  readonly #thickness = uniform(0.1);
  readonly #steps = uniform(12);

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
    this.#guide = takeGuide(inputs, 1);
  }

  update({ length, thickness, steps }: Effects['contactShadows']): void {
    this.#length.value = length;
    this.#thickness.value = thickness;
    this.#steps.value = steps;
  }

  render(renderer: WebGPURenderer): void {
    this.#guide.render(renderer);
  }

  dispose(): void {
    releaseGuide(this.#inputs, this.#guide);
  }

  /**
   * The part of a lamp's light that arrives.
   *
   * @param P the point that is shaded, N its normal, L the direction to the lamp; in view space
   * @param shift 0..1, by which the steps are moved
   */
  lit(P: Vec3, N: Vec3, L: Vec3, shift: Float): Float {
    const guide = this.#guide;
    return inline(() => {
      const least = P.z.mul(-ABOVE).toVar() as Float;
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
