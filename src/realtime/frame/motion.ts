/** From where what is seen has come since the last frame. */
import { If, vec2, vec4 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { FrameInputs } from './inputs.ts';

type Vec2 = Node<'vec2'>;
type Float = Node<'float'>;

/**
 * In texture coordinates, down being positive: surfaces by what the surfaces pass has of them; what is infinitely far away,
 * as the camera turns.
 *
 * @param place in the picture
 * @param depth there, as the depth buffer has it
 */
export function motionAt(inputs: FrameInputs, place: Vec2, depth: Float): Vec2 {
  const { velocity, projectionInverse, viewInverse, previousViewProjection } = inputs;
  const motion = velocity.sample(place).rg.toVar() as Vec2;
  If(depth.greaterThanEqual(1), () => {
    const ndc = place.mul(vec2(2, -2)).add(vec2(-1, 1)).toVar() as Vec2;
    const ray = projectionInverse.mul(vec4(ndc, 1, 1)) as unknown as Node<'vec4'>;
    const direction = viewInverse.mul(vec4(ray.xyz.normalize(), 0)) as unknown as Node<'vec4'>;
    const before = previousViewProjection.mul(vec4(direction.xyz, 0)) as unknown as Node<'vec4'>;
    motion.assign(ndc.sub(before.xy.div(before.w.max(1e-6))) as Vec2);
  });
  return motion.mul(vec2(0.5, -0.5)) as Vec2;
}
