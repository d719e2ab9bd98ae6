/**
 * Anti-aliasing of the finished picture, the careful one: edges are found, followed to their ends, and drawn anew as the
 * slanted lines of which they are the steps. J. Jimenez, J. I. Echevarria, T. Sousa and D. Gutierrez, 2012, "SMAA:
 * Enhanced Subpixel Morphological Antialiasing", Computer Graphics Forum 31(2), there SMAA 1x with its medium preset:
 * without diagonals and corners. How much of a pixel a line covers is computed, not looked up.
 */
import {
  Fn,
  float,
  If,
  Loop,
  select,
  sRGBTransferEOTF,
  sRGBTransferOETF,
  uniform,
  uv,
  vec2,
  vec4,
} from 'three/tsl';
import { type Node, type RenderTarget, UnsignedByteType, Vector2, type WebGPURenderer } from 'three/webgpu';
import type { Effect, EffectDefinition } from '../frame/effect.ts';
import { inputTexture, Pass } from '../frame/pass.ts';

type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;
type Float = Node<'float'>;

/** Of a channel in sRGB: smaller steps are not edges. */
const THRESHOLD = 0.1;
/** An edge beside one so many times as strong is not seen. */
const CONTRAST = 2;
/** Pixels that an edge is followed to either side. */
const REACH = 16;

const BYTES = { type: UnsignedByteType, isBlended: false };

class Smaa implements Effect {
  readonly #texel = uniform(new Vector2());
  readonly #picture = inputTexture();
  readonly #edges = inputTexture();
  readonly #weights = inputTexture();
  readonly #passes: readonly Pass[];

  constructor() {
    this.#passes = [
      new Pass('SMAA edges', this.#findEdges(), BYTES),
      new Pass('SMAA weights', this.#weigh(), BYTES),
      new Pass('SMAA', this.#blend(), BYTES),
    ];
  }

  afterOutput(renderer: WebGPURenderer, input: RenderTarget): RenderTarget {
    const { width, height } = input;
    this.#texel.value.set(1 / width, 1 / height);
    this.#picture.value = input.texture;
    const [edges, weights, blended] = this.#passes as [Pass, Pass, Pass];
    this.#edges.value = edges.render(renderer, width, height).texture;
    this.#weights.value = weights.render(renderer, width, height).texture;
    return blended.render(renderer, width, height);
  }

  dispose(): void {
    for (const pass of this.#passes) pass.dispose();
  }

  #place(x: number | Float, y: number | Float): Vec2 {
    return uv().add(vec2(x as number, y as number).mul(this.#texel)) as Vec2;
  }

  /** Red: an edge to the left neighbour; green: to the upper one. */
  #findEdges(): Node {
    const own = this.#picture.rgb;
    const step = (x: number, y: number, from: Vec3 = own as Vec3): Float => {
      const d = this.#picture.sample(this.#place(x, y)).rgb.sub(from).abs();
      return d.r.max(d.g).max(d.b) as Float;
    };
    const [left, top] = [step(-1, 0), step(0, -1)];
    const left2 = step(-2, 0, this.#picture.sample(this.#place(-1, 0)).rgb as Vec3);
    const top2 = step(0, -2, this.#picture.sample(this.#place(0, -1)).rgb as Vec3);
    const strongest = left.max(top).max(step(1, 0)).max(step(0, 1)).max(left2).max(top2);
    const isEdge = (delta: Float) =>
      select(delta.greaterThan(THRESHOLD).and(delta.mul(CONTRAST).greaterThanEqual(strongest)), 1, 0);
    return vec4(isEdge(left), isEdge(top), 0, 1);
  }

  /**
   * Red and green: how much of this pixel is its upper neighbour's colour, and how much of that one is this one's; blue
   * and alpha: the same of the left neighbour.
   */
  #weigh(): Node {
    return Fn(() => {
      const edges = this.#edges.rg.toVar() as Vec2;
      const weights = vec4(0).toVar();
      If(edges.g.greaterThan(0.5), () => {
        weights.xy.assign(this.#areas(vec2(1, 0) as Vec2, vec2(0, 1) as Vec2));
      });
      If(edges.r.greaterThan(0.5), () => {
        weights.zw.assign(this.#areas(vec2(0, 1) as Vec2, vec2(1, 0) as Vec2));
      });
      return weights;
    })();
  }

  /** @param along the edge, and @param across it: one pixel to the right and down, or down and to the right */
  #areas(along: Vec2, across: Vec2): Vec2 {
    // An edge to be followed is in one channel, those that cross it are in the other.
    const at = (steps: Float, side: number): Vec2 =>
      this.#edges.sample(uv().add(along.mul(steps).sub(across.mul(side)).mul(this.#texel)) as Vec2)
        .rg as Vec2;
    const follows = (steps: Float): Float => at(steps, 0).dot(across) as Float;
    /** An edge that crosses before this pixel: on this side of the line, less one on the other. */
    const crossing = (steps: Float): Vec2 => vec2(at(steps, 0).dot(along), at(steps, 1).dot(along)) as Vec2;
    const search = (direction: 1 | -1) => {
      const length = float(0).toVar();
      const ends = vec2(0).toVar();
      const isOn = float(1).toVar();
      Loop(REACH, () => {
        If(isOn.greaterThan(0.5), () => {
          // The border beyond the last pixel: before it to the left, before the next one to the right.
          const border = (direction === 1 ? length.add(1) : length.negate()) as Float;
          ends.assign(crossing(border));
          const next = follows(length.add(1).mul(direction) as Float);
          If(ends.x.add(ends.y).greaterThan(0.5).or(next.lessThan(0.5)), () => {
            isOn.assign(0);
          }).Else(() => {
            length.addAssign(1);
          });
        });
      });
      // A line that is longer than it is followed ends straight.
      const height = select(isOn.greaterThan(0.5), 0, ends.x.sub(ends.y).mul(0.5));
      return { length, height: float(height).toVar() as Float };
    };
    const before = search(-1);
    const after = search(1);
    const d = before.length.add(after.length).add(1).toVar() as Float;
    const [from, to] = [before.length, before.length.add(1)];
    const middle = d.mul(0.5);
    // Heights go linearly from the ends to 0 in the middle: their integrals over the pixel.
    const rising = (t: Float) => t.sub(t.mul(t).div(d)) as Float;
    const first = rising(to.min(middle) as Float)
      .sub(rising(from.min(middle) as Float))
      .mul(before.height);
    const second = rising(from.max(middle) as Float)
      .sub(rising(to.max(middle) as Float))
      .mul(after.height);
    return vec2(first.max(0).add(second.max(0)), first.min(0).add(second.min(0)).negate()) as Vec2;
  }

  #blend(): Node {
    return Fn(() => {
      const here = this.#weights.toVar() as Vec4;
      const below = this.#weights.sample(this.#place(0, 1)).g.toVar() as Float;
      const right = this.#weights.sample(this.#place(1, 0)).a.toVar() as Float;
      const result = this.#picture.toVar();
      If(here.r.max(here.b).max(below).max(right).greaterThan(0), () => {
        const linear = (x: number, y: number) =>
          sRGBTransferEOTF(this.#picture.sample(this.#place(x, y)).rgb) as unknown as Vec3;
        const own = linear(0, 0);
        const mixed = own.toVar() as Vec3;
        // The stronger of the two directions.
        If(here.b.max(right).greaterThan(here.r.max(below)), () => {
          mixed.addAssign(linear(-1, 0).sub(own).mul(here.b).add(linear(1, 0).sub(own).mul(right)));
        }).Else(() => {
          mixed.addAssign(linear(0, -1).sub(own).mul(here.r).add(linear(0, 1).sub(own).mul(below)));
        });
        result.assign(vec4(sRGBTransferOETF(mixed) as unknown as Vec3, result.a));
      });
      return result;
    })();
  }
}

export const smaa: EffectDefinition = {
  name: 'antialiasing',
  isOn: ({ effects }) => effects.antialiasing.method === 'smaa',
  variant: () => 'smaa',
  needsSurfaces: false,
  build: () => new Smaa(),
};
