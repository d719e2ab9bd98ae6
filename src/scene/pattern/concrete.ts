/** Cast or sedimentary stone: stains, layers, sand, and pits left by bubbles (cells: S. Worley, 1996). */
import { number } from '../fields.ts';
import { count, deeper, kind, share } from './kind.ts';
import { cellNoise, clamp, fractal, gradientNoise, type Near, random, smoothstep } from './noise.ts';

export const concrete = kind({
  title: 'Concrete',
  shape: {
    stains: count('Stains from one side to the other', 1, 16),
    contrast: number('How dark the stains are', { range: [0, 2], slider: [0, 1], step: 0.01 }),
    layers: share('How much the stains lie in level layers'),
    grit: share('How much single grains of sand show'),
    pits: share('How many pits there are'),
    pitSize: share('How large the pits are'),
  },
  defaults: { stains: 3, contrast: 0.35, layers: 0, grit: 0.4, pits: 0.3, pitSize: 0.4 },
  depth: () => 0.006,
  sampler({ seed, color, stains, contrast, layers, grit, pits, pitSize }) {
    const near: Near = { first: 0, second: 0, id: 0 };
    const cells = 24;
    return (u, v, out) => {
      const stain = fractal(u, v, stains, stains, 5, seed);
      const bent = v + 0.05 * fractal(u, v, 2, 2, 3, seed + 21);
      const bed = fractal(u, bent, 1, 6 * stains, 4, seed + 22);
      const broad = stain + (bed - stain) * layers;
      const sand =
        0.5 * gradientNoise(u * 110, v * 110, 110, 110, seed + 23) +
        0.5 * gradientNoise(u * 210, v * 210, 210, 210, seed + 24);
      cellNoise(u * cells, v * cells, cells, cells, seed + 25, 0.8, near);
      const isPit = random(near.id, 0, seed) < pits;
      // Few are large.
      const radius = 0.05 + 0.4 * pitSize * random(near.id, 1, seed) ** 3;
      const pit = isPit ? 1 - smoothstep(0.6 * radius, radius, near.first) : 0;
      deeper(color, contrast * (0.7 * broad + 0.35 * grit * sand), 1 - 0.5 * pit, out);
      out.height = clamp(0.75 + 0.12 * broad + 0.14 * grit * sand - 0.55 * pit);
      out.roughness = 1 + 0.12 * broad + 0.1 * grit * sand;
    };
  },
});
