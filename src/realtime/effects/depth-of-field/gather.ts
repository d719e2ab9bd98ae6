/** Gathering over the aperture: what of the light of the pixels around reaches this one. */
import {
  cos,
  Fn,
  float,
  If,
  interleavedGradientNoise,
  Loop,
  screenCoordinate,
  select,
  sin,
  uv,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { at, type Shared } from './prepare.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** 2 pi / phi^2: a spiral with this angle between its points covers a disk evenly (H. Vogel, 1979). */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

interface Look {
  /** A place in the aperture: x to the right, y up, within the unit polygon. */
  readonly lens: Vec2;
  /** 0 in the middle of the aperture, 1 at its edge. */
  readonly radius: Float;
  /** The part of the aperture that the place stands for, all of a disk's being 1. */
  readonly area: Float;
}

/** Calls for each place of the aperture, turned for every pixel: what is left of the pattern is fine noise. */
function eachPlace({ samples, circle }: Shared, look: (place: Look) => void): void {
  const noise = interleavedGradientNoise(screenCoordinate.xy).toVar() as Float;
  const count = samples.toFloat().toVar() as Float;
  const turn = noise.mul(2 * Math.PI).toVar() as Float;
  Loop({ start: 0, end: samples, type: 'int' }, ({ i }) => {
    const index = (i as Node<'int'>).toFloat().toVar() as Float;
    const radius = index.add(0.5).div(count).sqrt().toVar() as Float;
    const angle = index.mul(GOLDEN_ANGLE).add(turn).toVar() as Float;
    // How far the polygon's edge is from its middle at this angle; its first corner is at angle 0.
    const sector = float(2 * Math.PI).div(circle.corners.max(3)) as Float;
    const within = angle.div(sector).fract().mul(sector).sub(sector.mul(0.5));
    const polygon = cos(sector.mul(0.5)).div(cos(within)) as Float;
    const edge = select(circle.corners.lessThan(3), float(1), polygon).toVar() as Float;
    const lens = vec2(cos(angle), sin(angle)).mul(radius).mul(edge).toVar() as Vec2;
    look({ lens, radius, area: edge.mul(edge) as Float });
  });
}

/**
 * Behind the focus, within the pixel's own circle: light of those whose circles reach here, spread over their areas.
 * Alpha is the circle's radius.
 */
export function farGathered(shared: Shared, half: TextureNode<'vec4'>): Node {
  const { halfSize } = shared;
  return Fn(() => {
    const own = half.toVar() as Vec4;
    const result = own.toVar() as Vec4;
    If(own.a.greaterThan(0.5), () => {
      const sum = vec3(0).toVar() as Vec3;
      const weights = float(0).toVar() as Float;
      eachPlace(shared, ({ lens, radius, area }) => {
        // What is behind the focus shows the aperture upright, so its light comes from the other side.
        const place = uv().sub(lens.mul(vec2(1, -1)).mul(own.a).div(halfSize)) as Vec2;
        const there = at(half, place).toVar() as Vec4;
        const reaches = there.a.sub(radius.mul(own.a)).add(1).clamp(0, 1);
        // Of what is behind the pixel, no more than its own surface leaves uncovered.
        const spread = there.a.min(own.a).max(0.5);
        const weight = area.mul(reaches).div(spread.mul(spread)).toVar() as Float;
        sum.addAssign(there.rgb.mul(weight));
        weights.addAssign(weight);
      });
      If(weights.greaterThan(0), () => {
        result.assign(vec4(sum.div(weights), own.a));
      });
    });
    return result;
  })();
}

/**
 * Before the focus, within the widest circle that reaches here. Alpha is how much of what is behind is covered, and the
 * colour is multiplied by it, so that texels can be mixed. Where the pixel itself is before the focus, what shines through
 * comes from those around that are not.
 */
export function nearGathered(shared: Shared, half: TextureNode<'vec4'>, reach: TextureNode<'vec4'>): Node {
  const { halfSize } = shared;
  return Fn(() => {
    const result = vec4(0).toVar() as Vec4;
    const most = at(reach, uv() as Vec2).r.toVar() as Float;
    If(most.greaterThan(0.5), () => {
      const own = half.toVar() as Vec4;
      const near = vec4(0).toVar() as Vec4;
      const behind = vec4(0).toVar() as Vec4;
      const areas = float(0).toVar() as Float;
      eachPlace(shared, ({ lens, radius, area }) => {
        // What is before the focus shows the aperture upside down.
        const place = uv().add(lens.mul(vec2(1, -1)).mul(most).div(halfSize)) as Vec2;
        const there = at(half, place).toVar() as Vec4;
        const circle = there.a.negate().toVar() as Float;
        const reaches = circle.sub(radius.mul(most)).add(1).clamp(0, 1).mul(circle.clamp(0, 1));
        const spread = circle.max(0.5).min(most);
        const weight = area.mul(reaches).mul(most.mul(most)).div(spread.mul(spread)).toVar() as Float;
        near.addAssign(vec4(there.rgb, 1).mul(weight));
        // Behind this pixel by more than a pixel's circle.
        behind.addAssign(vec4(there.rgb, 1).mul(there.a.sub(own.a).sub(1).clamp(0, 1).mul(area)));
        areas.addAssign(area);
      });
      const covered = near.a.div(areas).min(1).toVar() as Float;
      const color = near.rgb.div(near.a.max(1e-6)).toVar() as Vec3;
      result.assign(vec4(color, covered));
      // The picture has the pixel itself here, sharp; it is to be covered all the same.
      const isNear = own.a.negate().clamp(0, 1).toVar() as Float;
      If(isNear.greaterThan(0), () => {
        const through = select(behind.a.greaterThan(0), behind.rgb.div(behind.a.max(1e-6)), color);
        const filled = select(
          near.a.greaterThan(0),
          color.mul(covered).add(through.mul(covered.oneMinus())),
          own.rgb,
        );
        const alpha = covered.max(isNear).toVar() as Float;
        result.assign(vec4(color.mul(isNear.oneMinus()).add((filled as Vec3).mul(isNear)), alpha));
      });
    });
    return vec4(result.rgb.mul(result.a), result.a);
  })();
}
