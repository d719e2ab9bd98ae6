import { describe, expect, test } from 'vitest';
import { createRandom } from '../../src/analysis/random.ts';
import { ByteError } from '../../src/io/bytes.ts';
import { packCsail, readCsail } from '../../src/io/csail.ts';
import { writeCsail } from './csail-writer.ts';

const bins: [number, number, number, number] = [4, 5, 6, 8];
const count = 4 * 5 * 6 * 8;
const good = writeCsail((L, V) => [0.25, 0.1 + L[2] * V[2], 3], { bins });

function changed(change: (view: DataView) => void, bytes = good): Uint8Array {
  const copy = bytes.slice();
  change(new DataView(copy.buffer));
  return copy;
}

describe('a CSAIL file', () => {
  const data = readCsail(good, 'good.dat');

  test('becomes the sizes and triples in 1/sr, in its own order', () => {
    expect(data).toHaveLength(3 * (2 + count));
    expect([...data.subarray(0, 6)]).toEqual([4, 5, 6, 8, 0, 0]);
    const at = (a: number, b: number, c: number, d: number) => 3 * (2 + ((a * 5 + b) * 6 + c) * 8 + d);
    const cosine = (i: number, n: number) => Math.cos((((i + 0.5) / n) * Math.PI) / 2);
    for (const [a, b, c, d] of [
      [0, 0, 0, 0],
      [3, 1, 5, 7],
      [2, 4, 3, 2],
    ] as const) {
      expect(data[at(a, b, c, d)]).toBeCloseTo(0.25, 6);
      expect(data[at(a, b, c, d) + 1]).toBeCloseTo(0.1 + cosine(a, 4) * cosine(b, 5), 6);
      expect(data[at(a, b, c, d) + 2]).toBeCloseTo(3, 6);
    }
  });

  test('has the nearest bin’s value where it has no data', () => {
    const holes = writeCsail((L, V) => (L[2] > 0.9 ? null : V[2] < 0.4 ? null : [V[2], 1, 1]), { bins });
    const filled = readCsail(holes, 'holes.dat').subarray(6);
    expect(filled.every((value) => value >= 0)).toBe(true);
    // theta_out 4 of 5 takes theta_out 3; theta_in 0 of 4 takes theta_in 1.
    const line = 6 * 8 * 3;
    expect(filled[(1 * 5 + 4) * line]).toBe(filled[(1 * 5 + 3) * line]);
    expect(filled[(0 * 5 + 2) * line]).toBe(filled[(1 * 5 + 2) * line]);
  });

  test('is packed to half its size, within .03 %, and read from that too', () => {
    const packed = packCsail(data);
    expect(packed.length).toBeLessThan(good.length * 0.52);
    const back = readCsail(packed, 'packed');
    for (const [i, value] of data.entries()) {
      expect(Math.abs((back[i] as number) - value)).toBeLessThanOrEqual(3e-4 * value);
    }
    expect(Buffer.from(packCsail(back)).equals(Buffer.from(packed))).toBe(true);
  });

  test('of too many bins is averaged over neighbours in azimuth', () => {
    const large: [number, number, number, number] = [30, 30, 100, 100];
    const size = 30 * 30 * 100 * 100;
    const bytes = new Uint8Array(64 + 12 * size);
    const head = new Int32Array(bytes.buffer, 0, 16);
    head.set([...large, 0, 0, 1, 0, 0, 0, 3]);
    // phi_in varies fastest: 1 3 1 3 ...
    new Float32Array(bytes.buffer, 64).forEach((_, i, all) => {
      all[i] = i % 2 === 0 ? 0.1 : 0.3;
    });
    const coarse = readCsail(bytes, 'large.dat');
    expect([...coarse.subarray(0, 6)]).toEqual([30, 30, 100, 50, 0, 0]);
    expect(coarse).toHaveLength(3 * (2 + size / 2));
    expect(coarse.subarray(6, 300).every((value) => Math.abs(value - 2) < 1e-5)).toBe(true);
    expect(coarse.at(-1)).toBeCloseTo(2, 5);
  });
});

describe('a broken file is refused with its name, the place and the fault:', () => {
  const packed = packCsail(readCsail(good, 'good.dat'));
  test.each<[string, () => Uint8Array, RegExp]>([
    ['empty', () => new Uint8Array(), /byte 0: the file ends here; expected 4 more bytes/],
    [
      'no bins',
      () => changed((v) => v.setInt32(4, 0, true)),
      /byte 4: not a CSAIL BRDF: 0 bins of theta_out/,
    ],
    ['negative', () => changed((v) => v.setInt32(8, -6, true)), /byte 8: .*-6 bins of phi_diff/],
    ['big-endian', () => changed((v) => v.setInt32(0, 4)), /byte 0: .*67108864 bins of theta_in/],
    ['enormous', () => changed((v) => new Int32Array(v.buffer, 0, 4).fill(4096)), /the file ends here/],
    [
      'kind',
      () => changed((v) => v.setInt32(24, 2, true)),
      /byte 24: the kind of parameters is 2; expected 1/,
    ],
    ['bin kind', () => changed((v) => v.setInt32(28, 1, true)), /byte 28: the kind of bins is 1; expected 0/],
    ['half', () => changed((v) => v.setInt32(36, 7, true)), /byte 36: half_data is 7; expected 0 or 1/],
    [
      'channels',
      () => changed((v) => v.setInt32(40, 1, true)),
      /byte 40: the number of channels is 1; expected 3/,
    ],
    [
      'cut',
      () => good.subarray(0, 1000),
      /byte 1000: the file ends here; expected 10584 more bytes of samples/,
    ],
    ['longer', () => Buffer.concat([good, Buffer.from('xy')]), /2 bytes after the last sample/],
    ['NaN', () => changed((v) => v.setFloat32(104, Number.NaN, true)), /byte 104: the sample is NaN/],
    [
      'infinite',
      () => changed((v) => v.setUint32(104, 0x7f800000, true)),
      /byte 104: the sample is Infinity/,
    ],
    ['without data', () => writeCsail(() => null, { bins }), /no data/],
    ['packed and cut', () => packed.subarray(0, 500), /byte 500: the file ends here/],
    ['packed half', () => changed((v) => v.setInt32(24, 3, true), packed), /half_data is 3/],
  ])('%s', (name, bytes, message) => {
    expect(() => readCsail(bytes(), `${name}.dat`)).toThrow(message);
    expect(() => readCsail(bytes(), `${name}.dat`)).toThrow(new RegExp(`^${name}\\.dat: `));
  });

  test('cut or garbled anywhere', () => {
    const random = createRandom(11);
    for (let i = 0; i < 400; i++) {
      const from = i % 2 === 0 ? good : packed;
      const copy = from.slice(0, i % 3 === 0 ? Math.floor(random() * from.length) : from.length);
      // Mostly in the head, where sizes stand.
      for (let k = 0; k < 3; k++)
        copy[Math.floor(random() * Math.min(copy.length, k === 0 ? copy.length : 64))] = random() * 256;
      try {
        expect(readCsail(copy, 'garbled.dat').every((value) => Number.isFinite(value) && value >= 0)).toBe(
          true,
        );
      } catch (error) {
        expect(error).toBeInstanceOf(ByteError);
      }
    }
  });
});
