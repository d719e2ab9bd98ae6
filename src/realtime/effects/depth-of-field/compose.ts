/** The picture with what is out of focus laid over what is in focus. */
import { Fn, float, mix, smoothstep, uv, vec2, vec3, vec4 } from 'three/tsl';
import type { Node, TextureNode } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import { at, type Shared } from './prepare.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;

/** Radii in pixels of the picture between which its half takes over from it. */
const SHARP = 0.7;
const BLURRED = 2;

export interface Layers {
  /** The picture at half its size, with its circles. */
  readonly half: TextureNode<'vec4'>;
  readonly far: TextureNode<'vec4'>;
  readonly near: TextureNode<'vec4'>;
  /** How far what is before the focus reaches, by tiles. */
  readonly reach: TextureNode<'vec4'>;
}

export function composed(
  { inputs, circle, halfSize }: Shared,
  picture: TextureNode<'vec4'>,
  { half, far, near, reach }: Layers,
): Node {
  /** For the 3 x 3 texels around, against the noise; a loop, which software GPUs leave where there is nothing to do. */
  const around = (isNeeded: Node<'bool'>, look: (place: Vec2, weight: Float) => void) =>
    repeat(isNeeded.select(float(9), float(0)) as unknown as Float, (i) => {
      const offset = vec2(i.mod(3), i.div(3).floor()).sub(1).toVar() as unknown as Vec2;
      const shares = offset.abs().sub(2).toVar() as Vec2;
      look(uv().add(offset.div(halfSize)).toVar() as Vec2, shares.x.mul(shares.y) as Float);
    });
  return Fn(() => {
    const own = picture.rgb.toVar() as Vec3;
    const radius = circle.radius(inputs.depth.sample(uv()).r as Float).toVar() as Float;
    // Of those with about the same circle: no light of what is sharp.
    const sum = vec3(0).toVar() as Vec3;
    const weights = float(0).toVar() as Float;
    around(radius.greaterThan(SHARP), (place, share) => {
      const circleThere = at(half, place).a.mul(2);
      const alike = circleThere.sub(radius).abs().div(radius.mul(0.25).max(1)).oneMinus().max(1e-4);
      const weight = alike.mul(share).toVar() as Float;
      sum.addAssign(at(far, place).rgb.mul(weight));
      weights.addAssign(weight);
    });
    const blurred = sum.div(weights.max(1e-6)) as Vec3;
    const color = mix(own, blurred, smoothstep(SHARP, BLURRED, radius)) as Vec3;
    const [over, cover] = [vec3(0).toVar() as Vec3, float(0).toVar() as Float];
    around(at(reach, uv() as Vec2).r.greaterThan(0), (place, share) => {
      const there = at(near, place).div(16).toVar() as Node<'vec4'>;
      over.addAssign(there.rgb.mul(share) as Vec3);
      cover.addAssign(there.a.mul(share));
    });
    const laid = color.mul(cover.oneMinus()).add(over);
    // What is before the focus is nowhere seen sharp.
    const isNear = radius.negate().clamp(0, 1).mul(cover.greaterThan(1e-3).select(1, 0));
    return vec4(mix(laid, over.div(cover.max(1e-3)), isNear), picture.a);
  })();
}
