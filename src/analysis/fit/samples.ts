/** The pairs of directions at which a fit compares two BRDFs. */
import { directionsFrom } from '../plots/half-difference.ts';
import { createRandom } from '../random.ts';
import type { Vec3 } from '../vector.ts';

export interface Pair {
  readonly l: Vec3;
  readonly v: Vec3;
}

/**
 * Powers of 1/phi_4, phi_4 the real root of x^5 = x + 1: their multiples, modulo 1, fill four dimensions
 * evenly (M. Roberts, 2018, "The Unreasonable Effectiveness of Quasirandom Sequences").
 */
const STEPS = [1, 2, 3, 4].map((power) => 1.1673039782614187 ** -power);

/**
 * Pairs as the bins of the MERL database have them: evenly spread over sqrt(theta_h), theta_d and phi_d, so
 * that a twentieth of them is within a quarter of a degree of the peak (W. Matusik et al., 2003, "A
 * Data-Driven Reflectance Model", section 3); and over phi_h, for what depends on the tangent.
 *
 * @param lowest the least cosine of l and v with the normal
 */
export function samplePairs(count: number, seed: number, lowest: number): Pair[] {
  const random = createRandom(seed);
  const start = STEPS.map(() => random());
  const pairs: Pair[] = [];
  for (let i = 0; pairs.length < count; i++) {
    const [t, d, p, h] = STEPS.map((step, k) => ((start[k] as number) + i * step) % 1) as [
      number,
      number,
      number,
      number,
    ];
    const pair = directionsFrom({
      thetaH: (Math.PI / 2) * t * t,
      thetaD: (Math.PI / 2) * d,
      phiD: 2 * Math.PI * p,
      phiH: 2 * Math.PI * h,
    });
    if (pair.l[2] >= lowest && pair.v[2] >= lowest) pairs.push(pair);
  }
  return pairs;
}
