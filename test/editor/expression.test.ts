import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { evaluateExpression, formatNumber, roundTo } from '../../src/editor/ui/expression.ts';

describe('evaluateExpression', () => {
  it.each([
    ['1', 1],
    [' -2.5 ', -2.5],
    ['.5', 0.5],
    ['0,25', 0.25],
    ['1e-3', 0.001],
    ['2E3', 2000],
    ['1/4', 0.25],
    ['2*(3+4)', 14],
    ['10-4-3', 3],
    ['-(1+1)*-3', 6],
    ['8/2/2', 2],
  ])('%s is %d', (text, value) => {
    expect(evaluateExpression(text)).toBeCloseTo(value, 12);
  });

  it.each(['', 'abc', '1+', '(1', '1)', '1/0', '0/0', '1 2', 'alert(1)', '--', '1..2', '('.repeat(100)])(
    'refuses %s',
    (text) => {
      expect(evaluateExpression(text)).toBeNull();
    },
  );

  it('reads back every number that a field shows', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, min: -1e12, max: 1e12 }), (value) => {
        const read = evaluateExpression(formatNumber(value));
        expect(read).not.toBeNull();
        expect(Math.abs((read ?? 0) - value)).toBeLessThanOrEqual(Math.max(1e-3 * Math.abs(value), 5e-6));
      }),
      { examples: [[0.1005], [0.11411411411411412], [1.0005]] },
    );
  });

  it('never throws and never gives anything but a finite number or null', () => {
    fc.assert(
      fc.property(fc.string(), (text) => {
        const value = evaluateExpression(text);
        expect(value === null || Number.isFinite(value)).toBe(true);
      }),
    );
  });
});

describe('roundTo', () => {
  it('leaves no binary noise', () => {
    expect(roundTo(0.1 + 0.2, 0.001)).toBe(0.3);
    expect(roundTo(0.7000000000000001, 0.01)).toBe(0.7);
    expect(roundTo(1234.56, 10)).toBe(1230);
  });
});
