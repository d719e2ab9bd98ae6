import { describe, expect, test } from 'vitest';
import {
  adapted,
  ev100,
  ev100OfExposure,
  exposureFor,
  exposureOfEv100,
  METER_CELLS,
  meter,
  meterPicture,
} from '../../src/color/exposure.ts';
import { ZONE_COLORS, zoneBound, zoneIndex } from '../../src/color/false-color.ts';

describe('a camera', () => {
  test('sunny 16: f/16 and 1/100 s at ISO 100 are EV 15, minus the third that 1/125 would give', () => {
    expect(ev100({ fStop: 16, shutter: 1 / 125, iso: 100 })).toBeCloseTo(14.97, 2);
    expect(ev100({ fStop: 1, shutter: 1, iso: 100 })).toBe(0);
    expect(ev100({ fStop: 2, shutter: 1 / 4, iso: 200 })).toBe(3);
  });

  test('at EV100 0, 1.2 nits are white', () => {
    expect(1.2 * 2 ** exposureOfEv100(0)).toBeCloseTo(1, 12);
    expect(ev100OfExposure(exposureOfEv100(7.5))).toBeCloseTo(7.5, 12);
  });

  test('each stop of aperture, time or sensitivity is one EV, and compensation adds', () => {
    const at = (change: object, exposure = 0) =>
      exposureFor({ exposureMode: 'camera', exposure }, { fStop: 4, shutter: 0.01, iso: 100, ...change }, 99);
    expect(at({ fStop: 4 * Math.SQRT2 }) - at({})).toBeCloseTo(-1);
    expect(at({ shutter: 0.02 }) - at({})).toBeCloseTo(1);
    expect(at({ iso: 400 }) - at({})).toBeCloseTo(2);
    expect(at({}, 0.5) - at({})).toBeCloseTo(0.5);
  });

  test('a pinhole is exposed as f/16; by hand, nothing counts but the hand', () => {
    const rest = { shutter: 0.01, iso: 100 };
    const settings = { exposureMode: 'camera', exposure: 0 } as const;
    expect(exposureFor(settings, { fStop: 0, ...rest }, 0)).toBe(
      exposureFor(settings, { fStop: 16, ...rest }, 0),
    );
    expect(exposureFor({ exposure: 1.5 }, { fStop: 0, ...rest }, 3)).toBe(1.5);
  });
});

describe('the meter', () => {
  test('shows an even picture as middle grey', () => {
    expect(2 ** meter(new Float32Array(100).fill(40), 10) * 40).toBeCloseTo(0.18, 6);
  });

  test('looks between its percentiles: neither shade nor a lamp counts, and black does not', () => {
    // One row: all cells of a column weigh the same, and columns come in pairs.
    const picture = Float32Array.from({ length: 200 }, (_, i) => (i % 2 ? 10 : 0.01));
    picture[100] = picture[99] = 1e5;
    const exposure = meter(picture, 200);
    expect(2 ** exposure * 10).toBeCloseTo(0.18, 2);
    const withBlack = Float32Array.from({ length: 400 }, (_, i) => (i < 200 ? picture[i]! : 0));
    expect(meter(withBlack, 200)).toBeCloseTo(exposure, 6);
    expect(meter(new Float32Array(10), 5)).toBe(0);
    expect(meter(new Float32Array([Number.NaN, 1]), 2)).toBeCloseTo(Math.log2(0.18));
  });

  test('the middle of the picture counts more than its borders', () => {
    const side = 30;
    const object = Float32Array.from({ length: side * side }, (_, i) => {
      const [x, y] = [(i % side) - 14.5, Math.floor(i / side) - 14.5];
      return Math.hypot(x, y) < 8 ? 100 : 0.1;
    });
    // A fifth of the picture, but most of what is metered.
    expect(2 ** meter(object, side) * 100).toBeGreaterThan(0.15);
    expect(2 ** meter(object, side) * 100).toBeLessThan(1.5);
  });

  test('averages cells', () => {
    const [width, height] = [2 * METER_CELLS, METER_CELLS];
    const radiance = new Float32Array(3 * width * height).map((_, i) => (Math.floor(i / 3) % 2 ? 3 : 1));
    expect(2 ** meterPicture(radiance, width, height) * 2).toBeCloseTo(0.18, 5);
    expect(2 ** meterPicture(radiance.slice(0, 30).fill(5), 5, 2) * 5).toBeCloseTo(0.18, 5);
  });

  test('is followed over time, faster towards the bright, and arrives', () => {
    const [down, up] = [adapted(0, -4, 0.1), adapted(0, 4, 0.1)];
    expect(down).toBeLessThan(0);
    expect(-down).toBeGreaterThan(up);
    let exposure = 0;
    for (let i = 0; i < 60; i++) exposure = adapted(exposure, 4, 0.1);
    expect(exposure).toBe(4);
  });
});

test('zones of false colour: middle grey in the middle, a stop each', () => {
  expect(ZONE_COLORS[zoneIndex(0.18, 0)]).toEqual([128, 128, 128]);
  expect(zoneIndex(0.18 * 4, 0) - zoneIndex(0.18, 0)).toBe(2);
  expect(zoneIndex(0.18 * 4, -2)).toBe(zoneIndex(0.18, 0));
  expect([zoneIndex(0, 0), zoneIndex(1e9, 0)]).toEqual([0, 12]);
  expect(zoneIndex(zoneBound(3, 1.5) * 1.001, 1.5)).toBe(9);
  expect(zoneIndex(zoneBound(3, 1.5) * 0.999, 1.5)).toBe(8);
});
