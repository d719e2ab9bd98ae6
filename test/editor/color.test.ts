import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromHex, fromHsv, type Rgb, toHex, toHsv, toLinear, toSrgb } from '../../src/editor/ui/color.ts';

const channel = fc.double({ min: 0, max: 1, noNaN: true });
const rgb = fc.tuple(channel, channel, channel);

function expectClose(a: Rgb, b: Rgb, tolerance: number): void {
  for (const i of [0, 1, 2] as const) expect(Math.abs(a[i] - b[i])).toBeLessThan(tolerance);
}

describe('colours of the picker', () => {
  it('go from linear to sRGB and back', () => {
    fc.assert(fc.property(rgb, (color) => expectClose(toLinear(toSrgb(color)), color, 1e-6)));
  });

  it('go to hue, saturation, value and back', () => {
    fc.assert(fc.property(rgb, (color) => expectClose(fromHsv(toHsv(color)), color, 1e-9)));
  });

  it('keep every hex code', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 0xffffff }), (code) => {
        const hex = `#${code.toString(16).padStart(6, '0')}`;
        const color = fromHex(hex);
        expect(color && toHex(color)).toBe(hex);
      }),
    );
  });

  it('know sRGB mid grey', () => {
    expectClose(fromHex('#808080') ?? [0, 0, 0], [0.215861, 0.215861, 0.215861], 1e-5);
    expect(fromHex('f00')).toEqual([1, 0, 0]);
    expect(fromHex('#12345')).toBeNull();
    expect(fromHex('red')).toBeNull();
  });
});
