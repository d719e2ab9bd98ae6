/** Grains of up to three minerals, which have grown against each other: cells (S. Worley, 1996) with crooked borders. */
import { color } from '../fields.ts';
import { count, kind, paint, share } from './kind.ts';
import { cellNoise, gradientNoise, type Near, random } from './noise.ts';

export const granite = kind({
  title: 'Granite',
  shape: {
    grains: count('Grains from one side to the other', 4, 128),
    secondShare: share('How many grains are of the second mineral'),
    secondColor: color('Colour of the second mineral, linear Rec. 709'),
    thirdShare: share('How many grains are of the third mineral'),
    thirdColor: color('Colour of the third mineral, linear Rec. 709'),
    variation: share('How much grains of one mineral differ'),
  },
  defaults: {
    grains: 40,
    secondShare: 0.35,
    secondColor: [0.35, 0.22, 0.17],
    thirdShare: 0.22,
    thirdColor: [0.012, 0.012, 0.013],
    variation: 0.4,
  },
  depth: ({ grains }) => 0.15 / grains,
  sampler(settings) {
    const { grains, secondShare, secondColor, thirdShare, thirdColor, variation } = settings;
    const { seed, color: first } = settings;
    const near: Near = { first: 0, second: 0, id: 0 };
    const small = 2 * grains;
    const flakes = Math.ceil(grains / 2);
    return (u, v, out) => {
      const n = 3 * grains;
      const dx = 0.3 * gradientNoise(u * n, v * n, n, n, seed + 1);
      const dy = 0.3 * gradientNoise(u * n, v * n, n, n, seed + 2);
      // Of the small and dark ones a few lie together, as flakes of mica do.
      cellNoise(u * small + 2 * dx, v * small + 2 * dy, small, small, seed + 3, 1, near);
      const gathered = 0.5 + 0.9 * gradientNoise(u * flakes, v * flakes, flakes, flakes, seed + 4);
      const isThird = random(near.id, 0, seed) < 2 * thirdShare * gathered;
      if (!isThird) cellNoise(u * grains + dx, v * grains + dy, grains, grains, seed + 5, 1, near);
      const isSecond = random(near.id, 1, seed) < secondShare;
      const mineral = isThird ? thirdColor : isSecond ? secondColor : first;
      const differs = 1 + variation * (random(near.id, 2, seed) - 0.5);
      const cloudy = 1 + 0.3 * variation * gradientNoise(u * n, v * n, n, n, seed + 6);
      paint(mineral, differs * cloudy, out);
      const border = Math.min(1, 6 * (near.second - near.first));
      out.height = 0.7 + 0.3 * border - (isThird ? 0.25 : 0);
      out.roughness = (isThird ? 1.5 : 1) * (1.2 - 0.2 * border);
    };
  },
});
