/** Dust, smears and fingerprints on a lens, made of noise: how much of the light that meets the glass they scatter. */
import { float, mx_fractal_noise_float, mx_worley_noise_float, uv, vec2, vec3 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { FrameInputs } from '../frame/inputs.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;

/** 0..1, over the picture of which the frame may be a part. */
export function lensDirt({ size, part }: FrameInputs): Float {
  const whole = size.div(part.zw);
  const place = uv()
    .mul(part.zw)
    .add(part.xy)
    .mul(vec2(whole.x.div(whole.y), 1)) as Vec2;
  /** Round specks: near the points of a grid that is shaken; of every second cell, and of different sizes. */
  const dust = (density: number, seed: number): Float => {
    const cell = place.mul(density) as Vec2;
    const size = mx_fractal_noise_float(vec3(cell.mul(0.7), seed), 2)
      .mul(0.3)
      .add(0.02)
      .clamp(0.02, 0.35);
    const distance = mx_worley_noise_float(vec3(cell, seed)) as unknown as Float;
    // Flat inside, a brighter rim: out of focus, as dust on a lens is.
    const rim = distance.div(size).smoothstep(0.5, 0.95).mul(0.5).add(0.5);
    return distance.div(size).smoothstep(0.95, 1.1).oneMinus().mul(rim) as unknown as Float;
  };
  const smear = mx_fractal_noise_float(vec3(place.mul(vec2(3, 9)), 5), 4)
    .mul(0.5)
    .add(0.35)
    .clamp(0, 1);
  const specks = dust(7, 1).mul(0.9).add(dust(17, 2).mul(0.6)).add(dust(41, 3).mul(0.4));
  return specks.add(float(smear).pow(3).mul(0.5)).min(1) as Float;
}
