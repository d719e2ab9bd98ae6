/** What is gathered from: the picture at half its size with its circles, and how far those before the focus reach. */
import { Fn, float, If, Loop, uv, vec2, vec4 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { BRIGHTEST_HALF } from '../../../material/half-float.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { type CircleOfConfusion, MOST_RADIUS } from './circle.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

export interface Shared {
  readonly inputs: FrameInputs;
  readonly circle: CircleOfConfusion;
  /** Looks at the aperture. */
  readonly samples: Node<'int'>;
  readonly halfSize: Node<'vec2'>;
}

/** Of what is sharp beside what is not. */
const LEAST_WEIGHT = 1e-3;

/**
 * Colour and circle's radius, in pixels of the half, of four pixels: the mean of those before the focus if there are any,
 * else of those behind it, each the more the larger its circle is. What is sharp must not be spread.
 */
export function halved({ inputs, circle, halfSize }: Shared, picture: TextureNode<'vec4'>): Node {
  return Fn(() => {
    const corner = uv().mul(halfSize).floor().mul(2).toVar() as Vec2;
    const looks = [0, 1, 2, 3].map((i) => {
      const place = corner
        .add(vec2((i % 2) + 0.5, Math.floor(i / 2) + 0.5))
        .min(inputs.size.sub(0.5))
        .div(inputs.size)
        .toVar() as Vec2;
      const color = picture.sample(place).rgb.clamp(0, BRIGHTEST_HALF).toVar() as Vec3;
      const radius = circle.radius(inputs.depth.sample(place).r as Float).toVar() as Float;
      return { color, radius };
    });
    const radii = looks.map(({ radius }) => radius);
    const least = radii.reduce((a, b) => a.min(b) as Float).toVar() as Float;
    const most = radii.reduce((a, b) => a.max(b) as Float);
    const chosen = least.lessThan(-0.5).select(least, most).toVar() as Float;
    // Where all is sharp, all counts.
    const scale = chosen
      .abs()
      .max(1e-3)
      .mul(chosen.sign().add(chosen.equal(0).select(1, 0)));
    const sum = vec4(0).toVar();
    const weights = float(0).toVar();
    for (const { color, radius } of looks) {
      const weight = radius.div(scale).clamp(LEAST_WEIGHT, 1).toVar() as Float;
      sum.addAssign(vec4(color, radius).mul(weight));
      weights.addAssign(weight);
    }
    return sum.div(weights).mul(vec4(1, 1, 1, 0.5));
  })();
}

/** Pixels of the half along a side of a tile. */
export const TILE = 8;

/** The largest radius before the focus within a tile; as a number above 0. */
export function tileReach({ halfSize }: Shared, half: TextureNode<'vec4'>): Node {
  return Fn(() => {
    const corner = uv().mul(halfSize.div(TILE).ceil()).floor().mul(TILE).add(0.5).toVar() as Vec2;
    const reach = float(0).toVar();
    Loop({ start: 0, end: TILE * TILE, type: 'int' }, ({ i }) => {
      const index = (i as Node<'int'>).toFloat();
      const row = index.div(TILE).floor();
      const offset = vec2(index.sub(row.mul(TILE)), row);
      const place = corner.add(offset).min(halfSize.sub(0.5)).div(halfSize) as Vec2;
      reach.assign(reach.max(at(half, place).a.negate()));
    });
    return vec4(reach, 0, 0, 1);
  })();
}

/** How many tiles the largest circle reaches, of a picture of so many. */
const REACH = MOST_RADIUS;

/** The largest radius of those tiles along an axis whose circles reach this one. */
export function tileSpread(
  { inputs }: Shared,
  tileSize: Node<'vec2'>,
  tiles: TextureNode<'vec4'>,
  axis: 'x' | 'y',
): Node {
  return Fn(() => {
    const reach = float(0).toVar();
    // The circle is a part of the whole's height; tiles are square.
    const count = tileSize.y.mul(REACH).div(inputs.part.w).ceil().add(1).toVar() as Float;
    const step = (axis === 'x' ? vec2(1, 0) : vec2(0, 1)).div(tileSize).toVar() as unknown as Vec2;
    Loop({ start: count.negate().toInt(), end: count.toInt(), condition: '<=', type: 'int' }, ({ i }) => {
      const offset = (i as Node<'int'>).toFloat().toVar() as Float;
      const found = at(tiles, uv().add(step.mul(offset)) as Vec2).r.toVar() as Float;
      // From the nearest border of that tile to the nearest of this one.
      If(found.greaterThan(offset.abs().sub(1).mul(TILE)), () => {
        reach.assign(reach.max(found));
      });
    });
    return vec4(reach, 0, 0, 1);
  })();
}

/** Within loops and branches no derivatives are to be had: the only level there is. */
export function at(map: TextureNode<'vec4'>, place: Vec2): Vec4 {
  return map.sample(place).level(float(0)) as unknown as Vec4;
}
