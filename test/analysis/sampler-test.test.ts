import { describe, expect, it } from 'vitest';
import { chiSquaredTest } from '../../src/analysis/chi-squared.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { type Sampler, testSampler } from '../../src/analysis/sampler-test.ts';
import { direction } from '../../src/analysis/vector.ts';

const cosine: Sampler = {
  sample: ([u1, u2]) => direction(Math.sqrt(1 - u1), 2 * Math.PI * u2),
  pdf: ([, , z]) => z / Math.PI,
};
const test = (sampler: Sampler) => testSampler(sampler, { samples: 20_000, random: createRandom(7) });

describe('testSampler', () => {
  it('accepts a sampler that keeps to its density', () => {
    const { pValue, mass } = test(cosine);
    expect(pValue).toBeGreaterThan(0.001);
    expect(mass).toBeCloseTo(1, 4);
  });

  it('refuses a density that is a little off, in height or in azimuth', () => {
    const uniform: Sampler = { ...cosine, pdf: ([, , z]) => 0.9 * (z / Math.PI) + 0.1 / (2 * Math.PI) };
    const skewed: Sampler = { ...cosine, pdf: ([x, , z]) => (z / Math.PI) * (1 + 0.2 * x) };
    expect(test(uniform).pValue).toBeLessThan(1e-3);
    expect(test(skewed).pValue).toBeLessThan(1e-6);
  });

  it('counts lost samples as what the density lacks to 1', () => {
    const lossy: Sampler = {
      sample: (u) => (u[0] < 0.25 ? null : cosine.sample([(u[0] - 0.25) / 0.75, u[1]])),
      pdf: (l) => 0.75 * cosine.pdf(l),
    };
    const { pValue, mass } = test(lossy);
    expect(pValue).toBeGreaterThan(0.001);
    expect(mass).toBeCloseTo(0.75, 4);
    expect(test({ ...lossy, pdf: cosine.pdf }).pValue).toBe(0);
  });

  it('refuses a direction below the surface', () => {
    expect(() => test({ ...cosine, sample: () => [0, 0, -1] })).toThrow('below the surface');
  });
});

describe('createRandom', () => {
  it('repeats itself for a seed and differs between seeds', () => {
    const [a, b, c] = [createRandom(5), createRandom(5), createRandom(6)];
    const first = Array.from({ length: 5 }, a);
    expect(Array.from({ length: 5 }, b)).toEqual(first);
    expect(Array.from({ length: 5 }, c)).not.toEqual(first);
  });

  it('fills the unit square evenly', () => {
    const random = createRandom(11);
    const counts = new Array<number>(256).fill(0);
    for (let i = 0; i < 25_600; i++) counts[Math.floor(random() * 16) * 16 + Math.floor(random() * 16)]!++;
    expect(
      chiSquaredTest(
        counts,
        counts.map(() => 100),
      ).pValue,
    ).toBeGreaterThan(0.001);
  });
});
