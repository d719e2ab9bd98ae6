import { describe, expect, test } from 'vitest';
import { MERL_SAMPLES, packMerl, readMerl } from '../../src/io/merl.ts';
import { directionsOf, writeMerl } from './merl-writer.ts';

const good = writeMerl((L, V) => [0.25, L[2] * V[2] + 0.1, 3]);
const size = good.length;

/** The good file with something else at one place. */
function changed(change: (view: DataView) => void): Uint8Array {
  const copy = good.slice();
  change(new DataView(copy.buffer));
  return copy;
}

const at = (h: number, d: number, p: number, c: number) => ((h * 90 + d) * 180 + p) * 3 + c;

describe('a MERL file', () => {
  const data = readMerl(good, 'good.binary');

  test('becomes triples in 1/sr, in its own order', () => {
    expect(data).toHaveLength(MERL_SAMPLES * 3);
    for (const [h, d, p] of [
      [0, 0, 0],
      [3, 40, 17],
      [50, 20, 179],
      [89, 0, 90],
    ] as const) {
      const { L, V } = directionsOf(h, d, p);
      const expected = [0.25, L[2] * V[2] + 0.1, 3];
      expected.forEach((x, c) => {
        expect(data[at(h, d, p, c)]).toBeCloseTo(x, 6);
      });
    }
  });

  test('has the value of the nearest theta_d where it has no data', () => {
    // At theta_h 80 degrees and phi_d 0 every large theta_d is below the horizon.
    const known = [...Array(90).keys()].filter((d) => {
      const { L, V } = directionsOf(85, d, 0);
      return L[2] > 0 && V[2] > 0;
    });
    const last = known.at(-1) as number;
    expect(last).toBeLessThan(80);
    expect(data[at(85, 89, 0, 1)]).toBe(data[at(85, last, 0, 1)]);
    expect(data.every((x) => x >= 0)).toBe(true);
    const hole = changed((view) => view.setFloat64(12, -1, true));
    expect(readMerl(hole, 'hole.binary')[0]).toBe(data[at(0, 1, 0, 0)]);
  });

  test('is packed to a quarter, within .03 %, and read from that too', () => {
    const packed = packMerl(data);
    expect(packed.length).toBeLessThan(size / 3.9);
    const back = readMerl(packed, 'packed');
    const errors = back.map((x, i) => Math.abs(x / (data[i] as number) - 1));
    expect(errors.reduce((a, b) => Math.max(a, b))).toBeLessThan(3e-4);
    const extremes = data
      .slice()
      .fill(0, 0, 1)
      .fill(2 ** 24, 1, 2)
      .fill(1e-7, 2, 3)
      .fill(1e-9, 3, 4);
    const [zero, large, small, gone] = readMerl(packMerl(extremes), 'packed');
    expect([zero, large, gone]).toEqual([0, 2 ** 24, 0]);
    expect((small as number) / 1e-7).toBeCloseTo(1, 3);
    // Packing what was packed changes nothing more.
    expect(Buffer.from(packMerl(back)).equals(Buffer.from(packed))).toBe(true);
  });
});

describe('a broken file is refused with its name, the place and the fault:', () => {
  const packed = packMerl(readMerl(good, 'good.binary'));
  const double = (value: number) =>
    changed((view) => view.setFloat64(12 + 8 * MERL_SAMPLES + 80, value, true));
  test.each<[string, () => Uint8Array, RegExp]>([
    ['empty', () => new Uint8Array(), /byte 0: the file ends here; expected 4 more bytes/],
    [
      'wrong dims',
      () => changed((view) => view.setInt32(8, 360, true)),
      /byte 0: .* 90 x 90 x 360 bins; expected 90 x 90 x 180/,
    ],
    ['negative dims', () => changed((view) => view.setInt32(0, -90, true)), /-90 x 90 x 180/],
    ['big-endian dims', () => changed((view) => view.setInt32(0, 90)), /expected 90 x 90 x 180/],
    ['text', () => new TextEncoder().encode('this is no BRDF at all'), /not a MERL BRDF/],
    ['NaN', () => double(Number.NaN), /byte 11664092: the green sample 10 is NaN; expected a finite/],
    ['infinite', () => double(Number.POSITIVE_INFINITY), /sample 10 is Infinity/],
    ['too large', () => double(1e300), /sample 10 is 1e\+300/],
    ['longer', () => Buffer.concat([good, Buffer.from('x')]), /byte 34992012: 1 bytes after the last sample/],
    [
      'without data',
      () =>
        changed((view) => {
          for (let i = 12; i < size; i += 8) view.setFloat64(i, -1, true);
        }),
      /no data/,
    ],
    ['packed and cut', () => packed.subarray(0, 5000), /byte 5000: the file ends here/],
    ['packed and longer', () => Buffer.concat([packed, packed]), /after the last sample/],
  ])('%s', (name, bytes, message) => {
    expect(() => readMerl(bytes(), `${name}.binary`)).toThrow(message);
    expect(() => readMerl(bytes(), `${name}.binary`)).toThrow(new RegExp(`^${name}\\.binary: `));
  });

  test('cut at any place', () => {
    for (let length = 0; length < size; length += length < 20 ? 1 : 1_234_567) {
      const cut = good.subarray(0, length);
      expect(() => readMerl(cut, 'cut.binary'), `${length}`).toThrow(
        /^cut\.binary: byte \d+: the file ends here/,
      );
    }
  });
});
