/** The fog's light between the texels that it was computed for: smoothed among them, then brought to every pixel. */
import { Fn, float, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { keptFloat, keptVec2 } from '../../../material/statements.ts';
import { inputTexture, type Pass } from '../../frame/pass.ts';
import type { Guide } from '../screen-space/guide.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** By which part of the distance what is brought up may differ. */
const TOLERANCE = 0.05;

/** A texel by its offset, and its weight. */
type Tap = readonly [offset: Vec2, weight: Float];

const AROUND = [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((x) => [x, y] as const));
const CORNERS = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const;

/** The mean over 3 x 3 texels of a surface: among them the noise is even. */
export function smoothed(guide: Guide, light: Pass): Node {
  return Fn(() => {
    const distance = keptFloat(guide.sample(guide.texel(uv() as Vec2)).w as Float);
    const taps = AROUND.map((offset): Tap => [vec2(...offset) as unknown as Vec2, float(1) as Float]);
    return vec4(near(guide, light, distance, taps), 1);
  })();
}

/** The light at a pixel, between the texels around. @param distance of the pixel's surface, along the view */
export function brought(guide: Guide, light: Pass, distance: Float): Vec3 {
  const at = (uv() as Vec2).mul(guide.size).sub(0.5).toVar() as Vec2;
  const part = keptVec2(at.fract() as Vec2);
  // From the texel that the pixel is in to the corners of the square of texels' centres that it is in.
  const corner = keptVec2(at.floor().sub((uv() as Vec2).mul(guide.size).floor()) as Vec2);
  const taps = CORNERS.map(([x, y]): Tap => {
    const weight = (x ? part.x : part.x.oneMinus()).mul(y ? part.y : part.y.oneMinus());
    return [corner.add(vec2(x, y)) as Vec2, weight as Float];
  });
  return near(guide, light, distance, taps);
}

/** The weighted mean of texels, of which those at another distance hardly count. */
function near(guide: Guide, pass: Pass, distance: Float, taps: readonly Tap[]): Vec3 {
  const light = inputTexture();
  light.value = pass.target.texture;
  const centre = keptVec2((uv() as Vec2).mul(guide.size).floor().add(0.5) as Vec2);
  const sum = vec3(0).toVar();
  const weights = float(0).toVar();
  for (const [offset, share] of taps) {
    const place = centre.add(offset).div(guide.size).toVar() as Vec2;
    const apart = guide.sample(place).w.sub(distance).div(distance.mul(TOLERANCE)) as Float;
    // Never 0: what no texel belongs to takes the mean.
    const weight = share.add(1e-3).mul(apart.mul(apart).negate().exp2().add(1e-4)).toVar();
    sum.addAssign(light.sample(place).rgb.mul(weight));
    weights.addAssign(weight);
  }
  return sum.div(weights) as unknown as Vec3;
}
