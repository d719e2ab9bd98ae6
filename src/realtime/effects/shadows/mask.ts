/**
 * How much of each lamp the points that the camera sees get, once for every pixel before the scene is shaded: materials would
 * ask again for every triangle that touches a pixel, and for what is behind another.
 */
import {
  dot,
  exp2,
  float,
  fwidth,
  If,
  positionView,
  screenUV,
  select,
  uv,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node, WebGPURenderer } from 'three/webgpu';
import { type Assignable, keptVec3 } from '../../../material/statements.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { Pass } from '../../frame/pass.ts';
import { columnsOf, distanceOf, inline, NOTHING, positionAt, texelAt } from '../screen-space/guide.ts';
import { gradientNoise } from '../screen-space/noise.ts';
import { fromOctahedron } from '../screen-space/octahedron.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Lamps of a texture, whose alpha is the distance; and textures: materials may read 16 on any machine, with their own. */
export const GROUP = 3;
const GROUPS = 2;
export const MASKED_LAMPS = GROUP * GROUPS;

/** What a lamp does not get that the point turns its back on: it tells little about the points around it. */
const AWAY = -1;
const AWAY_WEIGHT = 0.1;
/** The weight of a neighbour, as a part of what the pixel's own texel lacks of its whole one. */
const BESIDE = 0.02;
/** Differences of distance within one surface, as a part of the distance, beside what its slope makes. */
const TOLERANCE = 0.005;
/** What a depth buffer's number may be off: four units in the last place of what is just below 1. */
const DEPTH_ERROR = 4 * 2 ** -24;
/** And of a pixel, by which GPUs move corners to where triangles are drawn; the least precise have 4 bits for its parts. */
const SNAPPED = 2 / 16;
/** By how much of its distance the jitter may move a point: beyond, its plane is seen edge on. */
const MOST_MOVED = 0.005;

/** A point that the camera sees. */
export interface SeenPoint {
  /** In view space. */
  readonly P: Vec3;
  readonly N: Vec3;
  /** In world space; the normal is the triangle's own. */
  readonly position: Vec3;
  readonly normal: Vec3;
  readonly noise: Float;
}

export interface MaskedLamp {
  /** Whether any of the lamp is above the plane of the triangle. */
  facing(point: SeenPoint): Node<'bool'>;
  /** The part of it that the point gets. */
  seen(point: SeenPoint): Float;
}

export class LampMask {
  readonly #inputs: FrameInputs;
  readonly #passes: readonly Pass[];

  /**
   * @param groups make the lamps of a texture, all of them full but the last; asked for each shader that is built
   * @param turn 0..1, by which the noise is moved in this frame
   */
  constructor(inputs: FrameInputs, groups: readonly (() => readonly MaskedLamp[])[], turn: Float) {
    this.#inputs = inputs;
    this.#passes = groups.map((group) => {
      return new Pass('lamps seen', masked(inputs, group, turn), { isBlended: false });
    });
  }

  render(renderer: WebGPURenderer): void {
    const { x, y } = this.#inputs.size.value;
    for (const pass of this.#passes) pass.render(renderer, x, y);
  }

  /** What the fragment gets of each lamp; to be called at the top level of its code. */
  atFragment(): Float[] {
    return this.#passes.flatMap(({ target }) => {
      // Kept here: three.js would move it to where it is needed first, into branches too.
      const kept = keptVec3(gathered(this.#inputs, (place) => texelAt(target.texture, place)));
      return [kept.x, kept.y, kept.z] as Float[];
    });
  }

  dispose(): void {
    for (const pass of this.#passes) pass.dispose();
  }
}

/** Three lamps, and the distance along the view. */
function masked(inputs: FrameInputs, lamps: () => readonly MaskedLamp[], turn: Float): Vec4 {
  const { near, jitter, size, viewInverse } = inputs;
  return inline(() => {
    const place = uv() as Vec2;
    const depth = inputs.depth.sample(place).r.toVar() as Float;
    const N = fromOctahedron(inputs.velocity.sample(place).zw as Vec2).toVar() as Vec3;
    const result = vec4(AWAY, AWAY, AWAY, NOTHING).toVar() as Vec4;
    If(depth.lessThan(1), () => {
      const distance = distanceOf(inputs, depth).toVar() as Float;
      const rayAt = (at: Vec2) => positionAt(inputs, at.mul(2).sub(1).mul(vec2(1, -1)) as Vec2, float(1));
      // Where the scene is looked at this time, on the plane of the triangle.
      const ray = rayAt(place.add(jitter) as Vec2).toVar() as Vec3;
      const onPlane = dot(N, rayAt(place).mul(distance) as Vec3)
        .div(dot(N, ray).min(-1e-6))
        .toVar() as Float;
      const isNear = onPlane.sub(distance).abs().lessThan(distance.mul(MOST_MOVED));
      const along = select(isNear, onPlane, distance).toVar() as unknown as Float;
      // dz/dd = z^2 (1/near - 1/far) of the depth d; a pixel is 2 z / (P11 height) high.
      const ofDepth = distance.mul(DEPTH_ERROR).div(near);
      const ofPixel = float(2 * SNAPPED).div(columnsOf(inputs)(1).y.mul(size.y));
      const lift = distance.mul(ofDepth.add(ofPixel));
      const P = ray.mul(along).add(N.mul(lift)).toVar() as Vec3;
      const noise = gradientNoise(place.mul(size) as Vec2)
        .add(turn)
        .fract();
      const point: SeenPoint = {
        P,
        N,
        position: viewInverse.mul(vec4(P, 1)).xyz.toVar() as unknown as Vec3,
        normal: viewInverse.mul(vec4(N, 0)).xyz.toVar() as unknown as Vec3,
        noise: noise.toVar() as unknown as Float,
      };
      const channels = [result.x, result.y, result.z] as unknown as Assignable[];
      lamps().forEach((lamp, i) => {
        If(lamp.facing(point), () => {
          channels[i]!.assign(lamp.seen(point));
        });
      });
      (result.w as unknown as Assignable).assign(along);
    });
    return result;
  });
}

/** The fragment's own texel; what is beside it where that is of another surface, as along a silhouette. */
function gathered({ size }: FrameInputs, texel: (place: Vec2) => Vec4): Vec3 {
  return inline(() => {
    const pixel = (screenUV as unknown as Vec2).mul(size).floor().add(0.5).toVar() as Vec2;
    const distance = (positionView as Vec3).z.negate().toVar() as Float;
    const tolerance = fwidth(distance as never)
      .mul(2)
      .add(distance.mul(TOLERANCE))
      .toVar() as unknown as Float;
    const weighed = (x: number, y: number) => {
      const found = texel(pixel.add(vec2(x, y)).div(size) as Vec2).toVar() as Vec4;
      const off = found.w.sub(distance).div(tolerance).toVar() as Float;
      // Never 0: a fragment that no texel belongs to takes the mean.
      const alike = exp2(off.mul(off).negate()).max(1e-5) as Float;
      const isAway = found.xyz.lessThan(vec3(0));
      const weight = select(isAway as never, vec3(AWAY_WEIGHT), vec3(1)).mul(alike as never);
      return { light: found.xyz.max(0) as Vec3, weight: (weight as unknown as Vec3).toVar() as Vec3 };
    };
    const own = weighed(0, 0);
    const sum = own.light.mul(own.weight).toVar();
    const weights = own.weight.toVar();
    // What is known of the point itself is all that counts: neighbours may be of another surface as far away.
    const lack = own.weight.oneMinus().mul(BESIDE).toVar() as Vec3;
    for (const [x, y] of [
      [-1, 0],
      [1, 0],
      [0, -1],
      [0, 1],
    ] as const) {
      const { light, weight } = weighed(x, y);
      const part = weight.mul(lack).toVar() as Vec3;
      sum.addAssign(light.mul(part));
      weights.addAssign(part);
    }
    return sum.div(weights) as unknown as Vec3;
  });
}
