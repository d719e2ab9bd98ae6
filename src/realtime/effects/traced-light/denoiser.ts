/**
 * From what a few rays found in each pixel to what many would have: gathered over time, each point of a surface with itself
 * where it was, then over neighbours on the same surface; the more time has gathered, the less neighbours count.
 *
 * While something moves, what was gathered is held to what is found about the pixel now (M. Salvi, 2016, "An Excursion in
 * Temporal Supersampling", GDC), and surfaces that come into view begin anew, so that nothing leaves a ghost. The filter is
 * that of H. Dammertz et al., 2010, "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering", HPG.
 */
import { float, If, select, texture, uniform, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, Texture, WebGPURenderer } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { inputTexture, Pass } from '../../frame/pass.ts';
import { type Guide, inline, NOTHING } from '../screen-space/guide.ts';
import { type Pair, PairPass, pairOf } from './pair-pass.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;
type Input = ReturnType<typeof inputTexture>;

/** Frames that are gathered while nothing changes, and while something does. */
export const GATHERED = 64;
const GATHERED_IN_MOTION = 12;
/** Standard deviations about a pixel by which what was gathered may differ from what is found now. */
const SPREAD = 1.5;
/** By how much of its distance a point of the last frame may be off: another surface was there. */
const SAME = 0.03;
/** How far from the pixel's plane a neighbour may be, as a part of its distance. */
const PLANE = 0.01;
/** Radius in texels over which wide light is shared when nothing is gathered yet. */
const RADIUS = 12;
/** It shrinks as this power of the frames: what is found then is nearly free of noise, and sharp. */
const SHRINKING = 0.75;
/** The radius of highlights, as a part of it. */
const SHARP = 0.5;
/** Distances of the neighbours in each pass, in texels. */
const STRIDES = [1, 2, 4] as const;

interface PairInput {
  readonly wide: Input;
  readonly sharp: Input;
}

const pairInput = (): PairInput => ({ wide: inputTexture(), sharp: inputTexture() });

function give(input: PairInput, { wide, sharp }: Pair): void {
  input.wide.value = wide;
  input.sharp.value = sharp;
}

const at = (input: Input, place: Vec2): Vec4 => input.sample(place).level(float(0)) as unknown as Vec4;

export class Denoiser {
  readonly #inputs: FrameInputs;
  readonly #guide: Guide;
  readonly #raw = pairInput();
  readonly #past = pairInput();
  readonly #filtered = pairInput();
  readonly #limit = uniform(GATHERED);
  readonly #isMoving = uniform(0);
  readonly #isCut = uniform(1);
  readonly #isEmpty = uniform(1);
  readonly #gather: readonly PairPass[];
  readonly #filters: readonly PairPass[];
  readonly #sum: Pass;
  #last = 0;

  constructor(inputs: FrameInputs, guide: Guide) {
    this.#inputs = inputs;
    this.#guide = guide;
    this.#gather = ['even', 'odd'].map(
      (name) => new PairPass(`traced light, gathered ${name}`, (write) => this.#gathered(write)),
    );
    this.#filters = STRIDES.map(
      (stride) => new PairPass(`traced light, filtered ${stride}`, (write) => this.#filter(write, stride)),
    );
    const place = uv() as Vec2;
    const own = at(this.#filtered.wide, place);
    this.#sum = new Pass('traced light', vec4(own.rgb.add(at(this.#filtered.sharp, place).rgb), own.a), {
      isBlended: false,
    });
  }

  /** Incident radiance of both kinds, and the distance along the view. */
  get result(): Texture {
    return this.#sum.target.texture;
  }

  /** @param isEmpty whether there was nothing to be found: it does not count */
  render(renderer: WebGPURenderer, found: Pair, denoises: boolean, isEmpty: boolean): void {
    const { x, y } = this.#guide.size.value;
    let pair = found;
    if (denoises) {
      const { steady, isCut } = this.#inputs;
      this.#isMoving.value = Number(steady === 0);
      this.#limit.value = steady === 0 ? GATHERED_IN_MOTION : GATHERED;
      this.#isCut.value = Number(isCut);
      this.#isEmpty.value = Number(isEmpty);
      give(this.#raw, found);
      const [past, next] = [this.#gather[this.#last]!, this.#gather[1 - this.#last]!];
      give(this.#past, pairOf(past.target));
      pair = next.render(renderer, x, y);
      this.#last = 1 - this.#last;
      for (const pass of this.#filters) {
        give(this.#filtered, pair);
        pair = pass.render(renderer, x, y);
      }
    }
    give(this.#filtered, pair);
    this.#sum.render(renderer, x, y);
  }

  dispose(): void {
    for (const pass of [...this.#gather, ...this.#filters]) pass.dispose();
    this.#sum.dispose();
  }

  /** Wide light and distance; highlights and the number of frames that were gathered. */
  #gathered(write: (wide: Node, sharp: Node) => void): Vec4 {
    const { velocity, viewInverse, previousViewProjection } = this.#inputs;
    const guide = this.#guide;
    return inline(() => {
      const place = uv() as Vec2;
      const own = guide.sample(place).toVar() as Vec4;
      const [wide, sharp] = [at(this.#raw.wide, place).toVar(), at(this.#raw.sharp, place).toVar()] as [
        Vec4,
        Vec4,
      ];
      const [pastWide, pastSharp] = [vec4(0).toVar(), vec4(0).toVar()] as [Vec4, Vec4];
      const weights = float(0).toVar() as Float;
      If(own.w.lessThan(NOTHING * 0.99).and((this.#isCut as unknown as Float).lessThan(0.5)), () => {
        const centre = guide.texel(place).toVar() as Vec2;
        const motion = texture(velocity.value).sample(place).level(float(0)).xy.mul(vec2(0.5, -0.5));
        const before = centre.sub(motion).mul(guide.size).sub(0.5).toVar() as Vec2;
        const point = viewInverse.mul(vec4(guide.position(centre, own.w as Float), 1)) as unknown as Vec4;
        const expected = (previousViewProjection.mul(point) as unknown as Vec4).w.toVar() as Float;
        const corner = before.floor().toVar() as Vec2;
        const part = before.sub(corner).toVar() as Vec2;
        for (const [x, y] of [
          [0, 0],
          [1, 0],
          [0, 1],
          [1, 1],
        ] as const) {
          const there = corner.add(vec2(x, y)).add(0.5).div(guide.size).toVar() as Vec2;
          const texel = at(this.#past.wide, there).toVar() as Vec4;
          const same = texel.w.sub(expected).abs().lessThan(expected.mul(SAME));
          const inside = there
            .greaterThan(vec2(0))
            .all()
            .and(there.lessThan(vec2(1)).all());
          const bilinear = (x ? part.x : part.x.oneMinus()).mul(y ? part.y : part.y.oneMinus());
          const weight = select(same.and(inside), bilinear, float(0)).toVar() as unknown as Float;
          pastWide.addAssign(texel.mul(weight));
          pastSharp.addAssign(at(this.#past.sharp, there).mul(weight));
          weights.addAssign(weight);
        }
      });
      const count = float(0).toVar() as Float;
      If(weights.greaterThan(0.01), () => {
        count.assign(pastSharp.w.div(weights));
        for (const [past, raw, input] of [
          [pastWide, wide, this.#raw.wide],
          [pastSharp, sharp, this.#raw.sharp],
        ] as const) {
          past.divAssign(weights);
          If((this.#isMoving as unknown as Float).greaterThan(0.5), () => {
            const [mean, square] = [vec3(0).toVar(), vec3(0).toVar()] as [Vec3, Vec3];
            repeat(9, (i) => {
              const offset = vec2(i.mod(3), i.div(3).floor()).sub(1);
              const near = at(input, place.add(offset.div(guide.size)) as Vec2).rgb.toVar() as Vec3;
              mean.addAssign(near.div(9));
              square.addAssign(near.mul(near).div(9));
            });
            const deviation = square.sub(mean.mul(mean)).max(0).sqrt().mul(SPREAD).toVar() as Vec3;
            past.assign(vec4(past.rgb.max(mean.sub(deviation)).min(mean.add(deviation)), past.w));
          });
          const share = count.add(1).min(this.#limit).reciprocal().toVar() as Float;
          raw.assign(vec4(past.rgb.add(raw.rgb.sub(past.rgb).mul(share)), raw.w));
        }
      });
      const gathered = count
        .add(1)
        .min(this.#limit)
        .mul((this.#isEmpty as unknown as Float).oneMinus());
      write(vec4(wide.rgb, own.w), vec4(sharp.rgb, gathered));
      return vec4(0) as unknown as Vec4;
    });
  }

  /** The mean over neighbours on the same plane: how many count depends on the lobe, and on how much was gathered. */
  #filter(write: (wide: Node, sharp: Node) => void, stride: number): Vec4 {
    const guide = this.#guide;
    return inline(() => {
      const place = uv() as Vec2;
      const own = guide.sample(place).toVar() as Vec4;
      const N = own.xyz.toVar() as Vec3;
      const P = guide.position(place, own.w as Float).toVar() as Vec3;
      const tolerance = own.w.mul(PLANE).toVar() as Float;
      const count = at(this.#filtered.sharp, place).w.toVar() as Float;
      const spread = at(this.#raw.sharp, place).w.toVar() as Float;
      const radius = count.max(1).pow(-SHRINKING).mul(RADIUS).toVar() as Float;
      const [wide, sharp] = [vec3(0).toVar(), vec3(0).toVar()] as [Vec3, Vec3];
      const [wideWeights, sharpWeights] = [float(0).toVar(), float(0).toVar()] as [Float, Float];
      repeat(9, (i) => {
        const offset = vec2(i.mod(3), i.div(3).floor()).sub(1).mul(stride).toVar() as unknown as Vec2;
        const there = place.add(offset.div(guide.size)).toVar() as Vec2;
        const other = guide.sample(there).toVar() as Vec4;
        const plane = guide
          .position(there, other.w as Float)
          .sub(P)
          .dot(N)
          .div(tolerance) as Float;
        const alike = N.dot(other.xyz).clamp(0, 1);
        const inside = there
          .greaterThan(vec2(0))
          .all()
          .and(there.lessThan(vec2(1)).all());
        const surface = plane.mul(plane).negate().exp2().mul(alike.pow(8)).mul(inside.select(1, 0));
        const far = offset.dot(offset) as unknown as Float;
        const within = (r: Float) => far.negate().div(r.mul(r).max(0.02)).exp() as Float;
        // Its own texel always counts.
        const isOwn = far.lessThan(0.5);
        const a = select(isOwn, float(1), surface.mul(within(radius))).toVar() as unknown as Float;
        const b = select(
          isOwn,
          float(1),
          surface.mul(within(radius.mul(SHARP).min(spread) as Float)),
        ).toVar() as unknown as Float;
        wide.addAssign(at(this.#filtered.wide, there).rgb.mul(a));
        sharp.addAssign(at(this.#filtered.sharp, there).rgb.mul(b));
        wideWeights.addAssign(a);
        sharpWeights.addAssign(b);
      });
      write(vec4(wide.div(wideWeights), own.w), vec4(sharp.div(sharpWeights), count));
      return vec4(0) as unknown as Vec4;
    });
  }
}
