import { describe, expect, it } from 'vitest';
import {
  chiSquaredSurvival,
  chiSquaredTest,
  gammaQ,
  logGamma,
  sidakLevel,
} from '../../src/analysis/chi-squared.ts';
import { createRandom } from '../../src/analysis/random.ts';

describe('chi-squared distribution', () => {
  it('has the values of the tables', () => {
    // The 5 % and 1 % points (NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4), to 3 decimals.
    for (const [x, dof, p] of [
      [3.841, 1, 0.05],
      [6.635, 1, 0.01],
      [11.07, 5, 0.05],
      [18.307, 10, 0.05],
      [23.209, 10, 0.01],
      [124.342, 100, 0.05],
      [61.754, 90, 0.99],
    ] as const) {
      expect(chiSquaredSurvival(x, dof)).toBeCloseTo(p, 4);
    }
  });

  it('is exp(-x/2) with two degrees of freedom', () => {
    for (const x of [0, 0.1, 1, 3, 10, 50, 200]) {
      expect(chiSquaredSurvival(x, 2) / Math.exp(-x / 2)).toBeCloseTo(1, 12);
    }
  });

  it('stands on a gamma function that is right for whole and half arguments', () => {
    expect(logGamma(0.5)).toBeCloseTo(Math.log(Math.PI) / 2, 13);
    expect(logGamma(1)).toBeCloseTo(0, 13);
    expect(logGamma(11)).toBeCloseTo(Math.log(3628800), 12);
    expect(gammaQ(3, 2.5)).toBeCloseTo(Math.exp(-2.5) * (1 + 2.5 + 2.5 ** 2 / 2), 13);
    expect(gammaQ(3, 9)).toBeCloseTo(Math.exp(-9) * (1 + 9 + 81 / 2), 13);
  });
});

describe('chiSquaredTest', () => {
  it('accepts the counts of a fair die and refuses those of a loaded one', () => {
    const random = createRandom(1);
    const throwDie = (load: number) => {
      const counts = [0, 0, 0, 0, 0, 0];
      for (let i = 0; i < 6000; i++) counts[random() < load ? 5 : Math.floor(random() * 6)]!++;
      return counts;
    };
    const fair = new Array<number>(6).fill(1000);
    expect(chiSquaredTest(throwDie(0), fair).pValue).toBeGreaterThan(0.001);
    expect(chiSquaredTest(throwDie(0.05), fair).pValue).toBeLessThan(1e-6);
  });

  it('gives p values that are themselves spread evenly', () => {
    const random = createRandom(2);
    const tenths = new Array<number>(10).fill(0);
    for (let run = 0; run < 1000; run++) {
      const counts = new Array<number>(20).fill(0);
      for (let i = 0; i < 2000; i++) counts[Math.floor(random() * 20)]!++;
      const { pValue } = chiSquaredTest(counts, new Array<number>(20).fill(100));
      tenths[Math.min(9, Math.floor(pValue * 10))]!++;
    }
    expect(chiSquaredTest(tenths, new Array<number>(10).fill(100)).pValue).toBeGreaterThan(0.001);
  });

  it('pools cells that expect too few', () => {
    expect(chiSquaredTest([50, 1, 2, 3, 44], [46, 2, 2, 2, 48]).degreesOfFreedom).toBe(2);
    expect(chiSquaredTest([50, 50, 0], [50, 50, 0])).toMatchObject({ statistic: 0, degreesOfFreedom: 1 });
  });

  it('refuses counts where none can be', () => {
    expect(chiSquaredTest([99, 1], [100, 0], 0).pValue).toBe(0);
  });

  it('refuses expectations that make no sense', () => {
    expect(() => chiSquaredTest([1], [1, 2])).toThrow(RangeError);
    expect(() => chiSquaredTest([1, 1], [1, Number.NaN])).toThrow('expectation 1 is NaN');
  });
});

it('Sidak: so many tests at the lower level are wrong together as often as one at the level', () => {
  expect(1 - (1 - sidakLevel(0.01, 50)) ** 50).toBeCloseTo(0.01, 12);
  expect(sidakLevel(0.01, 1)).toBeCloseTo(0.01, 15);
});
