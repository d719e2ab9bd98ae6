/**
 * Anti-aliasing over time: every frame looks at another place inside its pixels, and is mixed with those before it, each
 * point of a surface with itself where it was. B. Karis, 2014, "High-Quality Temporal Supersampling", SIGGRAPH course.
 *
 * While nothing changes, all frames have the same weight: the picture becomes that of as many samples a pixel, and is
 * then kept. While something moves, what was there before is held to the colours that are around it now (M. Salvi, 2016,
 * "An Excursion in Temporal Supersampling", GDC), so that it leaves no ghost.
 */
import { Fn, float, If, mix, uniform, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, RenderTarget, TextureNode, WebGPURenderer } from 'three/webgpu';
import { BRIGHTEST_HALF } from '../../material/half-float.ts';
import type { Effect, EffectDefinition } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { motionAt } from '../frame/motion.ts';
import { inputTexture, Pass, pixelOf } from '../frame/pass.ts';
import { radicalInverse } from '../radical-inverse.ts';

type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Float = Node<'float'>;

/** Samples a pixel after which a picture that stands still is complete. */
export const TEMPORAL_SAMPLES = 32;
/** The weight of a frame where something moves: that of ten in the past is a third of it, so steps are hidden and changes are not. */
const MOVING_WEIGHT = 0.1;
/** How many frames' worth what was gathered in motion counts when the motion ends: it is smooth, but blurred. */
const MOVING_COUNT = 2;
/** Standard deviations of the colours around a pixel by which its past may differ; 1 flickers, 2 leaves ghosts. */
const SPREAD = 1.25;

class Temporal implements Effect {
  readonly #inputs: FrameInputs;
  readonly #current = inputTexture();
  readonly #history = inputTexture();
  /** Of the present frame. */
  readonly #weight = uniform(1);
  readonly #isMoving = uniform(0);
  readonly #passes: readonly Pass[];
  #last: Pass;
  /** Frames' worth of samples that the history holds. */
  #count = 0;

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
    const fragment = this.#resolve();
    this.#passes = ['even', 'odd'].map((name) => new Pass(`temporal ${name}`, fragment));
    this.#last = this.#passes[0]!;
  }

  get unsettled(): boolean {
    return this.#count < TEMPORAL_SAMPLES;
  }

  jitter(): readonly [x: number, y: number] {
    // The first point of the sequence is a corner: it begins with the second.
    const index = (this.#inputs.frameIndex.value % TEMPORAL_SAMPLES) + 1;
    return [radicalInverse(index, 2) - 0.5, radicalInverse(index, 3) - 0.5];
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    const { isCut, steady } = this.#inputs;
    if (isCut) this.#count = 0;
    const isMoving = steady === 0 && this.#count > 0;
    if (!isMoving && this.#count >= TEMPORAL_SAMPLES) return this.#last.target;
    this.#current.value = input.texture;
    this.#history.value = this.#last.target.texture;
    this.#weight.value = isMoving ? MOVING_WEIGHT : 1 / (this.#count + 1);
    this.#isMoving.value = Number(isMoving);
    this.#count = isMoving ? Math.min(this.#count + 1, MOVING_COUNT) : this.#count + 1;
    this.#last = this.#passes.find((pass) => pass !== this.#last) as Pass;
    return this.#last.render(renderer, input.width, input.height);
  }

  dispose(): void {
    for (const pass of this.#passes) pass.dispose();
  }

  #resolve(): Node {
    const texel = vec2(1).div(this.#inputs.size) as Vec2;
    return Fn(() => {
      const own = bounded(this.#colorAt(0, 0)).toVar() as Vec3;
      const result = own.toVar();
      If(this.#isMoving.lessThan(0.5), () => {
        // Where nothing is kept yet, what the texture holds may be anything.
        If(this.#weight.lessThan(1), () => {
          result.assign(mix(this.#history.rgb, own, this.#weight) as Vec3);
        });
      }).Else(() => {
        const past = uv().sub(this.#motion(texel)).toVar() as Vec2;
        const isInside = past
          .greaterThanEqual(vec2(0))
          .all()
          .and(past.lessThanEqual(vec2(1)).all());
        If(isInside, () => {
          const clipped = this.#clipped(catmullRom(this.#history, past, this.#inputs.size));
          // Bright specks count less, so that they do not flicker (Karis).
          const was = float(this.#weight.oneMinus()).div(luma(clipped).add(1)) as Float;
          const is = float(this.#weight).div(luma(own).add(1)) as Float;
          result.assign(clipped.mul(was).add(own.mul(is)).div(was.add(is)) as Vec3);
        });
      });
      return vec4(result, this.#current.a);
    })();
  }

  /** From where what is seen here has come since the last frame, in texture coordinates. */
  #motion(texel: Vec2): Vec2 {
    const { depth } = this.#inputs;
    // The nearest surface around: the edge of what moves moves with it.
    const nearest = depth.sample(uv()).r.toVar() as Float;
    const place = uv().toVar() as Vec2;
    for (const [x, y] of AROUND) {
      const there = uv().add(texel.mul(vec2(x, y))) as Vec2;
      const found = depth.sample(there).r as Float;
      If(found.lessThan(nearest), () => {
        nearest.assign(found);
        place.assign(there);
      });
    }
    return motionAt(this.#inputs, place, nearest);
  }

  /** Of the present frame, so many pixels beside. */
  #colorAt(x: number, y: number): Node {
    const { size } = this.#inputs;
    const pixel = uv().mul(size).floor().add(vec2(x, y)) as Vec2;
    return pixelOf(this.#current, pixel, size as unknown as Vec2).rgb;
  }

  /** A colour of the past, moved towards the mean of those around until it is one of them. */
  #clipped(past: Vec3): Vec3 {
    let sum: Vec3 = toYCoCg(bounded(this.#colorAt(0, 0)));
    let squares: Vec3 = sum.mul(sum) as Vec3;
    for (const [x, y] of AROUND) {
      const there = toYCoCg(bounded(this.#colorAt(x, y))).toVar();
      sum = sum.add(there) as Vec3;
      squares = squares.add(there.mul(there)) as Vec3;
    }
    const mean = sum.div(9).toVar() as Vec3;
    const deviation = squares.div(9).sub(mean.mul(mean)).max(0).sqrt() as Vec3;
    const offset = toYCoCg(past).sub(mean).toVar() as Vec3;
    const ratio = offset.abs().div(deviation.mul(SPREAD).max(1e-6)) as Vec3;
    const most = ratio.x.max(ratio.y).max(ratio.z).max(1) as Float;
    return fromYCoCg(mean.add(offset.div(most)) as Vec3).max(0) as Vec3;
  }
}

const AROUND = [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((x) => [x, y] as const)).filter(([x, y]) => x || y);

const bounded = (color: Node): Vec3 => (color as Vec3).clamp(0, BRIGHTEST_HALF) as Vec3;
const luma = (color: Vec3): Float => color.x.mul(0.25).add(color.y.mul(0.5)).add(color.z.mul(0.25)) as Float;

/** Luma and two differences of colours, along which colours of a picture vary independently. */
function toYCoCg(c: Vec3): Vec3 {
  const co = c.x.sub(c.z).mul(0.5);
  const cg = c.y.mul(0.5).sub(c.x.add(c.z).mul(0.25));
  return vec3(luma(c), co, cg) as Vec3;
}

function fromYCoCg(c: Vec3): Vec3 {
  const t = c.x.sub(c.z);
  return vec3(t.add(c.y), c.x.add(c.z), t.sub(c.y)) as Vec3;
}

/**
 * A texture between its texels by Catmull-Rom cubics, which do not blur what is resampled again and again: nine of the
 * sixteen texels' weights as five bilinear looks, the corners left out (Karis; J. Jimenez, 2016, "Filmic SMAA").
 */
function catmullRom(source: TextureNode<'vec4'>, at: Vec2, size: Node<'vec2'>): Vec3 {
  const place = at.mul(size).toVar() as Vec2;
  const centre = place.sub(0.5).floor().add(0.5).toVar() as Vec2;
  const f = place.sub(centre).toVar() as Vec2;
  const w0 = f.mul(f.mul(f.mul(-0.5).add(1)).sub(0.5));
  const w1 = f.mul(f).mul(f.mul(1.5).sub(2.5)).add(1);
  const w2 = f.mul(f.mul(f.mul(-1.5).add(2)).add(0.5));
  const w3 = f.mul(f).mul(f.mul(0.5).sub(0.5));
  const w12 = w1.add(w2).toVar() as Vec2;
  const before = centre.sub(1).div(size).toVar() as Vec2;
  const middle = centre.add(w2.div(w12)).div(size).toVar() as Vec2;
  const after = centre.add(2).div(size).toVar() as Vec2;
  const looks: [Node, Float][] = [
    [vec2(middle.x, before.y), w12.x.mul(w0.y) as Float],
    [vec2(before.x, middle.y), w0.x.mul(w12.y) as Float],
    [middle, w12.x.mul(w12.y) as Float],
    [vec2(after.x, middle.y), w3.x.mul(w12.y) as Float],
    [vec2(middle.x, after.y), w12.x.mul(w3.y) as Float],
  ];
  let sum: Vec3 = vec3(0) as Vec3;
  let weights: Float = float(0) as Float;
  for (const [where, weight] of looks) {
    sum = sum.add(source.sample(where as Vec2).rgb.mul(weight)) as Vec3;
    weights = weights.add(weight) as Float;
  }
  return sum.div(weights).max(0) as Vec3;
}

export const temporal: EffectDefinition = {
  name: 'antialiasing',
  isOn: ({ effects }) => effects.antialiasing.method === 'temporal',
  variant: () => 'temporal',
  needsSurfaces: true,
  build: (inputs) => new Temporal(inputs),
};
