/**
 * Motion blur: what moves is spread over the way that it goes while the shutter is open. Pixels gather along the strongest
 * motion around them, so what moves blurs beyond its outline, too. M. McGuire, P. Hennessy, M. Bukowski and B. Osman,
 * 2012, "A Reconstruction Filter for Plausible Motion Blur", I3D.
 */
import {
  Fn,
  float,
  If,
  interleavedGradientNoise,
  Loop,
  screenCoordinate,
  texture,
  uniform,
  uv,
  vec2,
  vec4,
} from 'three/tsl';
import {
  NearestFilter,
  type Node,
  type RenderTarget,
  type TextureNode,
  Vector2,
  type WebGPURenderer,
} from 'three/webgpu';
import type { Effect, EffectDefinition, EffectSettings } from '../frame/effect.ts';
import type { FrameInputs } from '../frame/inputs.ts';
import { motionAt } from '../frame/motion.ts';
import { inputTexture, Pass } from '../frame/pass.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec4 = Node<'vec4'>;

/** The longest way to either side, as a part of the picture's height; that of a pixel is one of a tile. */
const LONGEST = 1 / 24;
/** Pixels: what goes a shorter way is sharp. */
const SHORTEST = 0.5;
/** Of the distance: nearer to one another than this, two surfaces are as good as at the same. */
const SOFTNESS = 0.02;

class MotionBlur implements Effect {
  readonly #inputs: FrameInputs;
  readonly #picture = inputTexture();
  /** The share of a frame's motion that is before or after its middle while the shutter is open. */
  readonly #share = uniform(0);
  readonly #samples = uniform(16, 'int');
  readonly #tile = uniform(16, 'int');
  readonly #tiles = uniform(new Vector2());
  #shutter = 0;
  readonly #passes: Readonly<Record<'motion' | 'rows' | 'tiles' | 'around' | 'result', Pass>>;

  constructor(inputs: FrameInputs) {
    this.#inputs = inputs;
    const map = (pass: Pass) => {
      Object.assign(pass.target.texture, { minFilter: NearestFilter, magFilter: NearestFilter });
      return texture(pass.target.texture) as TextureNode<'vec4'>;
    };
    const motion = new Pass('motion', this.#motion());
    const motionMap = map(motion);
    const rows = new Pass('motion of rows', this.#strongestOf(motionMap, vec2(1, 0) as Vec2));
    const tiles = new Pass('motion of tiles', this.#strongestOf(map(rows), vec2(0, 1) as Vec2));
    const around = new Pass('motion around', this.#strongestAround(map(tiles)));
    const result = new Pass('motion blur', this.#gather(motionMap, map(around)));
    this.#passes = { motion, rows, tiles, around, result };
  }

  /** The last picture of a motion is blurred; one more is that of what stands still. */
  get unsettled(): boolean {
    return this.#inputs.steady === 0;
  }

  update({ effects, camera }: EffectSettings): void {
    this.#samples.value = effects.motionBlur.samples;
    this.#shutter = camera?.shutter ?? 0;
  }

  afterScene(renderer: WebGPURenderer, input: RenderTarget): RenderTarget | undefined {
    const { isCut, steady, seconds } = this.#inputs;
    if (isCut || steady > 0) return undefined;
    const { width, height } = input;
    const tile = Math.max(8, Math.round(height * LONGEST));
    const tiles = [Math.ceil(width / tile), Math.ceil(height / tile)] as const;
    // The shutter cannot be open longer than from frame to frame.
    this.#share.value = Math.min(1, this.#shutter / seconds.value) / 2;
    this.#tile.value = tile;
    this.#tiles.value.set(...tiles);
    this.#picture.value = input.texture;
    const { motion, rows, tiles: columns, around, result } = this.#passes;
    motion.render(renderer, width, height);
    rows.render(renderer, tiles[0], height);
    columns.render(renderer, ...tiles);
    around.render(renderer, ...tiles);
    return result.render(renderer, width, height);
  }

  dispose(): void {
    for (const pass of Object.values(this.#passes)) pass.dispose();
  }

  /** Half the way in pixels, and the distance's reciprocal. */
  #motion(): Node {
    const { depth, size, near, far } = this.#inputs;
    return Fn(() => {
      const own = depth.r.toVar() as Float;
      const way = motionAt(this.#inputs, uv() as Vec2, own)
        .mul(size)
        .mul(this.#share)
        .toVar() as Vec2;
      const length = way.length();
      const most = this.#tile.toFloat() as Float;
      way.mulAssign(most.div(length.max(most)));
      const nearness = own.oneMinus().div(near).add(own.div(far)).mul(own.lessThan(1).select(1, 0));
      return vec4(way, nearness, 1);
    })();
  }

  /** The strongest motion of a tile's pixels along an axis. */
  #strongestOf(source: TextureNode<'vec4'>, axis: Vec2): Node {
    const { size } = this.#inputs;
    return Fn(() => {
      const strongest = vec2(0).toVar() as Vec2;
      const tile = this.#tile.toFloat();
      // The first pixel of the tile along this axis; the same pixel along the other.
      const corner = uv().mul(this.#tiles).floor().mul(tile).add(0.5).div(size);
      const first = corner.mul(axis).add(uv().mul(axis.oneMinus())).toVar() as Vec2;
      Loop({ start: 0, end: this.#tile, type: 'int' }, ({ i }) => {
        const offset = axis.mul((i as Node<'int'>).toFloat()).div(size);
        const found = at(source, first.add(offset).min(vec2(1)) as Vec2).xy.toVar() as Vec2;
        If(found.dot(found).greaterThan(strongest.dot(strongest)), () => {
          strongest.assign(found);
        });
      });
      return vec4(strongest, 0, 1);
    })();
  }

  #strongestAround(tiles: TextureNode<'vec4'>): Node {
    return Fn(() => {
      const strongest = vec2(0).toVar() as Vec2;
      for (let k = 0; k < 9; k++) {
        const offset = vec2((k % 3) - 1, Math.floor(k / 3) - 1).div(this.#tiles);
        const found = at(tiles, uv().add(offset).clamp(0, 1) as Vec2).xy.toVar() as Vec2;
        If(found.dot(found).greaterThan(strongest.dot(strongest)), () => {
          strongest.assign(found);
        });
      }
      return vec4(strongest, 0, 1);
    })();
  }

  #gather(motion: TextureNode<'vec4'>, around: TextureNode<'vec4'>): Node {
    const { size } = this.#inputs;
    return Fn(() => {
      const own = this.#picture.toVar() as Vec4;
      const result = own.toVar() as Vec4;
      const strongest = at(around, uv() as Vec2).xy.toVar() as Vec2;
      If(strongest.length().greaterThan(SHORTEST), () => {
        const here = at(motion, uv() as Vec2).toVar() as Vec4;
        const ownLength = here.xy.length().max(SHORTEST).toVar() as Float;
        const weights = float(1).div(ownLength).toVar() as Float;
        const sum = own.rgb.mul(weights).toVar();
        const noise = interleavedGradientNoise(screenCoordinate.xy);
        Loop({ start: 0, end: this.#samples, type: 'int' }, ({ i }) => {
          const t = (i as Node<'int'>)
            .toFloat()
            .add(noise)
            .div(this.#samples.toFloat())
            .mul(2)
            .sub(1) as Float;
          const place = uv().add(strongest.mul(t).div(size)).toVar() as Vec2;
          const there = at(motion, place).toVar() as Vec4;
          const length = there.xy.length().max(SHORTEST).toVar() as Float;
          const distance = strongest.length().mul(t.abs()).toVar() as Float;
          // 1 where the other is nearer, or as far away.
          const soft = here.z.max(there.z).mul(SOFTNESS).max(1e-6);
          const isBefore = there.z.sub(here.z).div(soft).add(1).clamp(0, 1);
          const isBehind = here.z.sub(there.z).div(soft).add(1).clamp(0, 1);
          const reach = (way: Float) => distance.div(way).oneMinus().clamp(0, 1) as Float;
          const within = (way: Float) =>
            distance.smoothstep(way.mul(0.95), way.mul(1.05)).oneMinus() as unknown as Float;
          const weight = isBefore
            .mul(reach(length))
            .add(isBehind.mul(reach(ownLength)))
            .add(within(length).mul(within(ownLength)).mul(2))
            .toVar() as Float;
          sum.addAssign(at(this.#picture, place).rgb.mul(weight));
          weights.addAssign(weight);
        });
        result.assign(vec4(sum.div(weights), own.a));
      });
      return result;
    })();
  }
}

/** Within loops and branches no derivatives are to be had: the only level there is. */
function at(map: TextureNode<'vec4'>, place: Vec2): Vec4 {
  return map.sample(place).level(float(0)) as unknown as Vec4;
}

export const motionBlur: EffectDefinition = {
  name: 'motionBlur',
  isOn: ({ effects }) => effects.motionBlur.enabled,
  needsSurfaces: true,
  build: (inputs) => new MotionBlur(inputs),
};
