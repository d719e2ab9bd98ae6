/**
 * A board cut lengthwise, its fibres along v: growth rings whose light, soft earlywood passes slowly into dark, hard latewood
 * and ends sharply where the next spring begins; fibres; vessels cut open, as dark dashes. Rings distorted by noise are
 * Perlin's (1985), who cut his from a block; here they are drawn on the board, where they can repeat.
 */
import { number } from '../fields.ts';
import { count, deeper, kind, share } from './kind.ts';
import { clamp, fractal, gradientNoise, hash, modulo, random, smoothstep } from './noise.ts';

export const wood = kind({
  title: 'Wood',
  shape: {
    rings: count('Growth rings across the picture', 1, 64),
    figure: number('How far the rings wander, in rings: much makes flames', {
      range: [0, 12],
      slider: [0, 8],
      step: 0.05,
    }),
    latewood: share('The dark part of each ring'),
    contrast: number('How much darker the dark is', { range: [0, 3], slider: [0, 1.5], step: 0.01 }),
    fibre: share('How much the single fibres show'),
    pores: share('How many vessels show as dark dashes'),
  },
  defaults: { rings: 14, figure: 3, latewood: 0.4, contrast: 0.5, fibre: 0.5, pores: 0.25 },
  depth: () => 0.0015,
  sampler(settings) {
    const { rings, figure, latewood, contrast, fibre, pores } = settings;
    const { seed, color } = settings;
    const soft = 0.1;
    return (u, v, out) => {
      const wander = fractal(u, v, 2, 1, 3, seed);
      const widths = gradientNoise(u * rings, 0.5, rings, 1, seed + 11);
      const frayed = gradientNoise(u * 64, v * 8, 64, 8, seed + 12);
      const x = rings * u + figure * wander + 0.35 * widths + 0.05 * frayed;
      const ring = Math.floor(x);
      const age = x - ring;
      const dark = smoothstep(1 - soft - latewood, 1 - soft, age) * (1 - smoothstep(1 - soft, 1, age));
      const year = 0.55 + 0.45 * random(modulo(ring, rings), 0, seed + 13);
      const late = dark * year;
      const strand =
        0.6 * gradientNoise(u * 96, v * 4, 96, 4, seed + 14) +
        0.4 * gradientNoise(u * 192, v * 12, 192, 12, seed + 15);
      const broad = gradientNoise(u * 5, v, 5, 1, seed + 16);
      const open = pores > 0 ? vessel(u, v, pores * (1 - 0.8 * late), seed + 17) : 0;
      const tone = late + 0.22 * broad + fibre * 0.5 * strand;
      deeper(color, contrast * tone, 1 - 0.55 * open, out);
      out.height = clamp(0.55 + 0.15 * late + 0.25 * fibre * strand - 0.6 * open);
      out.roughness = 1 - 0.2 * late + 0.15 * fibre * strand + 0.4 * open;
    };
  },
});

const COLUMNS = 144;
const ROWS = 9;

/** 0..1 in a dash of its cell; a share of the cells has one. */
function vessel(u: number, v: number, share: number, seed: number): number {
  const x = u * COLUMNS;
  const column = Math.floor(x);
  // Columns are set off against each other, or the dashes would stand in rows.
  const shifted = v * ROWS + random(modulo(column, COLUMNS), 0, seed) * ROWS;
  const row = Math.floor(shifted);
  const bits = hash(modulo(column, COLUMNS), modulo(row, ROWS), seed + 1);
  if ((bits & 0xff) / 256 >= share) return 0;
  const middle = 0.35 + (0.3 * ((bits >>> 8) & 0xff)) / 255;
  const length = 0.2 + (0.28 * ((bits >>> 16) & 0xff)) / 255;
  const across = Math.abs(x - column - middle) / 0.3;
  const along = Math.abs(shifted - row - 0.5) / length;
  return clamp(1 - across * across - along * along);
}
