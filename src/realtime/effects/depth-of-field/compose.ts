/** The picture with what is out of focus laid over what is in focus. */
import { Fn, float, If, mix, smoothstep, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { at, type Shared } from './prepare.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Radii in pixels of the picture between which its half takes over from it. */
const SHARP = 0.7;
const BLURRED = 2;

export function composed(
  { inputs, circle, halfSize }: Shared,
  picture: TextureNode<'vec4'>,
  half: TextureNode<'vec4'>,
  far: TextureNode<'vec4'>,
  near: TextureNode<'vec4'>,
): Node {
  return Fn(() => {
    const own = picture.rgb.toVar() as Vec3;
    const radius = circle.radius(inputs.depth.sample(uv()).r as Float).toVar() as Float;
    const color = own.toVar() as Vec3;
    If(radius.greaterThan(SHARP), () => {
      // Of the texels around, 3 x 3 against the noise, those with about the same circle: no light of what is sharp.
      const sum = vec3(0).toVar() as Vec3;
      const weights = float(0).toVar() as Float;
      for (let i = 0; i < 9; i++) {
        const [x, y] = [(i % 3) - 1, Math.floor(i / 3) - 1];
        const place = uv().add(vec2(x, y).div(halfSize)) as Vec2;
        const there = at(far, place);
        const circleThere = at(half, place).a.mul(2);
        const alike = circleThere.sub(radius).abs().div(radius.mul(0.25).max(1)).oneMinus().max(1e-4);
        const weight = alike.mul((2 - Math.abs(x)) * (2 - Math.abs(y)));
        sum.addAssign(there.rgb.mul(weight));
        weights.addAssign(weight);
      }
      color.assign(mix(own, sum.div(weights), smoothstep(SHARP, BLURRED, radius)) as Vec3);
    });
    const over = vec3(0).toVar() as Vec3;
    const cover = float(0).toVar() as Float;
    for (let i = 0; i < 9; i++) {
      const [x, y] = [(i % 3) - 1, Math.floor(i / 3) - 1];
      const there = at(near, uv().add(vec2(x, y).div(halfSize)) as Vec2).toVar();
      const weight = ((2 - Math.abs(x)) * (2 - Math.abs(y))) / 16;
      over.addAssign(there.rgb.mul(weight) as Vec3);
      cover.addAssign(there.a.mul(weight));
    }
    const laid = color.mul(cover.oneMinus()).add(over);
    // What is before the focus is nowhere seen sharp.
    const isNear = radius.negate().clamp(0, 1).mul(cover.greaterThan(1e-3).select(1, 0));
    return vec4(mix(laid, over.div(cover.max(1e-3)), isNear), picture.a);
  })();
}
