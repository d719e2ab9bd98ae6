/** The grain of a hide: cushions between creases, at two scales. Cells: S. Worley, 1996. */
import { number } from '../fields.ts';
import { count, deeper, kind, share } from './kind.ts';
import { cellNoise, clamp, fractal, gradientNoise, type Near, random, smoothstep } from './noise.ts';

export const leather = kind({
  title: 'Leather',
  shape: {
    cushions: count('Cushions from one side to the other', 6, 96),
    creases: share('How broad the creases are'),
    contrast: number('How dark the creases are', { range: [0, 2], slider: [0, 1], step: 0.01 }),
    irregularity: share('How unequal the cushions are'),
  },
  defaults: { cushions: 32, creases: 0.5, contrast: 0.35, irregularity: 0.7 },
  depth: ({ cushions }) => 0.28 / cushions,
  sampler({ seed, color, cushions, creases, contrast, irregularity }) {
    const near: Near = { first: 0, second: 0, id: 0 };
    return (u, v, out) => {
      const n = 2 * cushions;
      const bend = 0.25 * irregularity;
      const x = u * cushions + bend * gradientNoise(u * n, v * n, n, n, seed + 1);
      const y = v * cushions + bend * gradientNoise(u * n, v * n, n, n, seed + 2);
      cellNoise(x, y, cushions, cushions, seed + 3, 0.4 + 0.6 * irregularity, near);
      const edge = near.second - near.first;
      const cushion = smoothstep(0, 0.12 + 0.6 * creases, edge);
      const own = random(near.id, 0, seed) - 0.5;
      const fine = gradientNoise(u * 4 * cushions, v * 4 * cushions, 4 * cushions, 4 * cushions, seed + 4);
      const broad = fractal(u, v, 2, 2, 3, seed + 5);
      deeper(color, contrast * (0.5 * (1 - cushion) + 0.2 * broad + 0.08 * own + 0.06 * fine), 1, out);
      out.height = clamp(Math.sqrt(cushion) * (0.8 + 0.25 * own) + 0.05 * fine + 0.1 * broad);
      out.roughness = 1 + 0.3 * (1 - cushion) + 0.1 * fine;
    };
  },
});
