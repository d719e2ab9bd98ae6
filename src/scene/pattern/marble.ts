/** Clouds and veins: waves across the stone, bent by turbulence (K. Perlin, 1985, "An Image Synthesizer"). */
import { color, number } from '../fields.ts';
import { count, kind, share } from './kind.ts';
import { clamp, fractal, gradientNoise, modulo, smoothstep, turbulence } from './noise.ts';

export const marble = kind({
  title: 'Marble',
  shape: {
    veins: count('Veins from one side to the other', 1, 12),
    turbulence: number('How far the veins wander', { range: [0, 6], slider: [0, 3], step: 0.01 }),
    width: share('How broad the veins are'),
    strength: share('How much the veins show'),
    clouds: share('How much the ground varies'),
    veinColor: color('Colour of the veins, linear Rec. 709'),
  },
  defaults: {
    veins: 2,
    turbulence: 1.4,
    width: 0.25,
    strength: 0.7,
    clouds: 0.3,
    veinColor: [0.2, 0.2, 0.22],
  },
  depth: () => 0.0004,
  sampler(settings) {
    const { veins, turbulence: strength, width, clouds, veinColor } = settings;
    const { seed, color: ground } = settings;
    /** @param a with b whole numbers, or the waves would not meet at the seam */
    const vein = (u: number, v: number, a: number, b: number, thin: number, of: number): number => {
      const bent = strength * (2.4 * turbulence(u, v, 2, 5, of) + 0.6 * fractal(u, v, 1, 1, 2, of + 31));
      const far = Math.abs(modulo(a * u + b * v + bent, 1) - 0.5) / (0.004 + 0.12 * width * thin);
      // They come and go along their way.
      const there = smoothstep(-0.35, 0.45, gradientNoise(u * 3, v * 3, 3, 3, of + 37));
      return there / (1 + far * far);
    };
    return (u, v, out) => {
      const main = vein(u, v, veins, veins, 1, seed);
      const cross = vein(u, v, -veins, 2 * veins, 0.35, seed + 101);
      const fine = vein(u, v, 3 * veins, veins + 1, 0.18, seed + 211);
      const veined = clamp(settings.strength * (main + 0.6 * cross + 0.4 * fine));
      const cloud = 1 - clouds * (0.35 + 0.5 * fractal(u, v, 2, 2, 5, seed + 307));
      out.red = cloud * (ground[0] + (veinColor[0] - ground[0]) * veined);
      out.green = cloud * (ground[1] + (veinColor[1] - ground[1]) * veined);
      out.blue = cloud * (ground[2] + (veinColor[2] - ground[2]) * veined);
      out.height = 1 - 0.5 * veined;
      out.roughness = 1 + 0.5 * veined;
    };
  },
});
