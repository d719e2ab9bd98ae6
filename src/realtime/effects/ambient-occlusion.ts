/**
 * How much light from far away reaches a surface, and from where, from what the picture shows about it: visibility() averaged over
 * neighbours, for materials to read.
 */
import { float, select, uniform, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, WebGPURenderer } from 'three/webgpu';
import type { FrameContext } from '../../material/frame-context.ts';
import { repeat } from '../../material/statements.ts';
import type { Effect, EffectDefinition, EffectSettings } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { type Guide, inline, releaseGuide, takeGuide, texelAt } from './screen-space/guide.ts';
import { fromOctahedron, toOctahedron } from './screen-space/octahedron.ts';
import { atFragment } from './screen-space/upsample.ts';
import { visibility, type Write } from './screen-space/visibility.ts';
import { PairPass, pairOf } from './traced-light/pair-pass.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Pixels each way that are averaged. */
const FILTER = 2;
/** How far from the pixel's plane a neighbour may be, as a part of its distance. */
const PLANE = 0.01;

class AmbientOcclusion implements Effect {
  readonly context: FrameContext;
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #numbers = {
    radius: uniform(1),
    thickness: uniform(1),
    directions: uniform(3),
    steps: uniform(6),
    bounces: uniform(1),
  };
  readonly #raw: PairPass;
  readonly #filtered: PairPass;

  constructor(inputs: FrameInputs, scale: number) {
    this.#inputs = inputs;
    this.#guide = takeGuide(inputs, scale);
    this.#raw = new PairPass('ambient occlusion', (write) => visibility(this.#guide, this.#numbers, write));
    this.#filtered = new PairPass('ambient occlusion, filtered', (write) =>
      filtered(this.#guide, this.#raw, write),
    );
    this.context = {
      openSky: () => {
        const { wide, sharp } = pairOf(this.#filtered.target);
        const found = atFragment(this.#guide, wide, (texel) =>
          vec4(texel.x, fromOctahedron(texel.yz as Vec2)),
        );
        return {
          visibility: found.x as Float,
          direction: found.yzw.normalize() as Vec3,
          mirrored: () => atFragment(this.#guide, sharp, (texel) => texel).xyz as Vec3,
          bounces: this.#numbers.bounces,
        };
      },
    };
  }

  update({ effects: { ambientOcclusion } }: EffectSettings): void {
    const { radius, thickness, directions, steps, bounces } = this.#numbers;
    radius.value = ambientOcclusion.radius;
    thickness.value = ambientOcclusion.thickness;
    directions.value = ambientOcclusion.directions;
    steps.value = ambientOcclusion.steps;
    bounces.value = Number(ambientOcclusion.bounces);
  }

  beforeScene(renderer: WebGPURenderer): void {
    this.#guide.render(renderer);
    const { x, y } = this.#guide.size.value;
    this.#raw.render(renderer, x, y);
    this.#filtered.render(renderer, x, y);
  }

  dispose(): void {
    releaseGuide(this.#inputs, this.#guide);
    this.#raw.dispose();
    this.#filtered.dispose();
  }
}

/** The mean over neighbours on the same plane. */
function filtered(guide: Guide, raw: PairPass, write: Write): Vec4 {
  const { wide, sharp } = pairOf(raw.target);
  return inline(() => {
    const place = uv() as Vec2;
    const own = guide.sample(place).toVar() as Vec4;
    const P = guide.position(place, own.w as Float).toVar() as Vec3;
    const N = own.xyz.toVar() as Vec3;
    const tolerance = own.w.mul(PLANE).toVar() as Float;
    const sum = vec4(0).toVar() as Vec4;
    const mirrored = vec3(0).toVar() as Vec3;
    const weights = float(0).toVar() as Float;
    const span = 2 * FILTER + 1;
    repeat(span * span, (i) => {
      const offset = vec2(i.mod(span), i.div(span).floor()).sub(FILTER).toVar() as unknown as Vec2;
      const at = place.add(offset.div(guide.size)).toVar() as Vec2;
      const other = guide.sample(at).toVar() as Vec4;
      const texel = texelAt(wide, at).toVar() as Vec4;
      const plane = guide
        .position(at, other.w as Float)
        .sub(P)
        .dot(N)
        .div(tolerance) as Float;
      const alike = N.dot(other.xyz).clamp(0, 1);
      const weight = offset
        .dot(offset)
        .mul(-0.5 / FILTER)
        .exp()
        .mul(plane.mul(plane).negate().exp2())
        .mul(alike.mul(alike).mul(alike).mul(alike))
        .toVar() as unknown as Float;
      sum.addAssign(vec4(texel.x, fromOctahedron(texel.yz as Vec2)).mul(weight));
      mirrored.addAssign(texelAt(sharp, at).xyz.mul(weight));
      weights.addAssign(weight);
    });
    const seen = weights.greaterThan(1e-6);
    const mean = sum.div(weights.max(1e-6)).toVar() as Vec4;
    const result = select(
      seen,
      vec4(mean.x, toOctahedron(mean.yzw as Vec3), own.w),
      texelAt(wide, place),
    ) as unknown as Vec4;
    write(
      result,
      select(seen, vec4(mirrored.div(weights.max(1e-6)), own.w), texelAt(sharp, place)) as unknown as Vec4,
    );
    return result;
  });
}

export const ambientOcclusion: EffectDefinition = {
  name: 'ambientOcclusion',
  isOn: ({ effects }) => effects.ambientOcclusion.enabled,
  variant: ({ effects }) => (effects.ambientOcclusion.halfResolution ? 'half' : 'full'),
  needsSurfaces: true,
  build: (inputs, { effects }) =>
    new AmbientOcclusion(inputs, effects.ambientOcclusion.halfResolution ? 0.5 : 1),
};
