import { expect, test } from 'vitest';
import { devicePreset } from '../../src/realtime/device-preset.ts';
import { DynamicResolution } from '../../src/realtime/dynamic-resolution.ts';

/** Frames of a GPU that takes `fixed` ms and `perPixel` ms for all pixels; returns the factors. */
function frames(control: DynamicResolution, count: number, time: (factor: number) => number, target: number) {
  return Array.from({ length: count }, () => {
    control.add(time(control.factor), target);
    return control.factor;
  });
}

test('what is fast enough is drawn in full', () => {
  const factors = frames(new DynamicResolution(), 100, () => 10, 16);
  expect(new Set(factors)).toEqual(new Set([1]));
});

test('the target is held where it can be, by the most pixels that hold it, without going to and fro', () => {
  for (const fixed of [0, 3, 6]) {
    for (const pixels of [12, 20, 30, 50]) {
      const control = new DynamicResolution();
      const time = (factor: number) => fixed + pixels * factor ** 2;
      const factors = frames(control, 300, time, 16);
      const last = control.factor;
      expect(last).toBeGreaterThanOrEqual(0.5);
      if (last > 0.5) expect(time(last)).toBeLessThanOrEqual(16 * 1.05);
      // Not a step too low: the next one would miss the target, or come too near to it.
      if (last < 1) expect(time(last) * ((last + 0.1) / last) ** 2).toBeGreaterThan(16 * 0.85);
      expect(new Set(factors.slice(100))).toEqual(new Set([last]));
    }
  }
});

test('one slow frame changes nothing; less to draw brings the pixels back; no target, all of them', () => {
  const control = new DynamicResolution();
  let n = 0;
  const factors = frames(control, 60, () => (n++ % 10 === 0 ? 100 : 10), 16);
  expect(new Set(factors)).toEqual(new Set([1]));
  frames(control, 60, (factor) => 60 * factor ** 2, 16);
  expect(control.factor).toBe(0.5);
  frames(control, 60, (factor) => 10 * factor ** 2, 16);
  expect(control.factor).toBe(1);
  frames(control, 60, (factor) => 60 * factor ** 2, 16);
  control.add(60, 0);
  expect(control.factor).toBe(1);
});

test('a fast device gets more than a slow one', () => {
  expect([0.2, 1, 2, 30].map(devicePreset)).toEqual(['ultra', 'high', 'medium', 'low']);
});
