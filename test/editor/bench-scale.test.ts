import { describe, expect, it } from 'vitest';
import { shortNumber, valueScale } from '../../src/editor/panels/bench/scale.ts';

describe('the axis of values', () => {
  it('has round ticks and room above the largest value', () => {
    const scale = valueScale([0, 0.09, 0.02], false, 0);
    expect(scale.ticks.map((tick) => tick.label)).toEqual(['0', '0.025', '0.05', '0.075']);
    expect(scale.position(0.09)).toBeLessThan(1);
    expect(scale.position(scale.top)).toBe(1);
  });

  it('ends where it is told to', () => {
    expect(valueScale([100], false, 2).top).toBe(2);
    expect(valueScale([100], true, 10).top).toBe(10);
  });

  it('has a decade a tick when logarithmic, six at most, and zero at its beginning', () => {
    const scale = valueScale([0, 0.02, 30], true, 0);
    expect(scale.ticks.map((tick) => tick.label)).toEqual(['0.01', '0.1', '1', '10', '100']);
    expect(scale.position(1)).toBeCloseTo(0.5, 12);
    expect(scale.position(0)).toBe(0);
    expect(valueScale([1e-12, 1], true, 0).ticks).toHaveLength(7);
  });

  it('holds out without values', () => {
    for (const log of [false, true]) {
      for (const values of [[], [0, 0], [Number.NaN, Number.POSITIVE_INFINITY]]) {
        const { top, ticks } = valueScale(values, log, 0);
        expect(top).toBeGreaterThan(0);
        expect(ticks.every(({ at }) => at >= 0 && at <= 1)).toBe(true);
      }
    }
  });

  it('writes numbers shortly', () => {
    expect([0, 0.31831, 12345.6, 1e-4, 2.5e7].map(shortNumber)).toEqual([
      '0',
      '0.3183',
      '12350',
      '1e-4',
      '2.5e7',
    ]);
  });
});
