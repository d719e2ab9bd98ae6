import { describe, expect, test } from 'vitest';
import { createRandom } from '../../src/analysis/random.ts';
import { ByteError } from '../../src/io/bytes.ts';
import { packRgl, readRgl } from '../../src/io/rgl.ts';
import { rglFields, tensorFile, writeRgl } from './rgl-writer.ts';

const small = { thetas: 3, resolution: 4 };
const fields = rglFields((L, V) => [0.2, 0.1 + L[2] * V[2], 0.4], small);
const good = tensorFile(fields);

describe('an RGL file', () => {
  const data = readRgl(good, 'good.bsdf');

  test('becomes triples: sizes, angles, tables', () => {
    const head = [...data.subarray(0, 18)];
    expect(head).toEqual([1, 3, 0, 96, 96, 10, 96, 96, 9226, 64, 64, 18442, 4, 4, 30730, 30778, 1, 0]);
    expect(data).toHaveLength(3 * (30778 + 3 * 16));
    expect(data[3 * 6]).toBe(0);
    expect(data[3 * 8]).toBeCloseTo(Math.PI / 4, 6);
  });

  test('has densities whose integrals end at 1', () => {
    const last = 3 * (18442 + 64 * 64 - 1);
    expect(data[last + 2]).toBeCloseTo(1, 6);
    // The integrals along the rows, summed as the rows' own integral, are 1 too.
    let sum = 0;
    for (let y = 0; y < 64; y++)
      sum += (data[3 * (18442 + y * 64 + 63) + 1] as number) * (y % 63 === 0 ? 0.5 : 1);
    expect(sum).toBeCloseTo(1, 5);
  });

  test('is kept with colours in place of spectra, and read from that as from itself', () => {
    expect(readRgl(packRgl(good, 'good.bsdf'), 'packed')).toEqual(data);
    const wavelengths = Array.from({ length: 81 }, (_, i) => 360 + 8 * i);
    const spectral = writeRgl((L) => [0.2, 0.3 + L[2], 0.4], {
      ...small,
      spectrum: { wavelengths, at: ([, level], nm) => (level * nm) / 700 },
    });
    const packed = packRgl(spectral, 'spectral.bsdf');
    expect(packed.length).toBeLessThan(spectral.length);
    expect(readRgl(packed, 'packed')).toEqual(readRgl(spectral, 'spectral.bsdf'));
  });

  test('a grey spectrum is the grey of the colours', () => {
    const f = (L: readonly number[]): [number, number, number] => [
      0.1 + (L[2] as number),
      0.1 + (L[2] as number),
      0.1 + (L[2] as number),
    ];
    const rgb = readRgl(writeRgl(f, small), 'rgb.bsdf');
    const wavelengths = Array.from({ length: 195 }, (_, i) => 360 + (640 * i) / 194);
    const spectra = readRgl(writeRgl(f, { ...small, spectrum: { wavelengths, at: ([r]) => r } }), 's.bsdf');
    expect(spectra).toHaveLength(rgb.length);
    rgb.forEach((value, i) => {
      if (Math.abs((spectra[i] as number) - value) > 1e-5 * Math.abs(value))
        expect(spectra[i], `${i}`).toBe(value);
    });
  });
});

describe('a broken file is refused with its name, the field and the fault:', () => {
  const at = (part: string) => Buffer.from(good).indexOf(part);
  const changed = (change: (view: DataView) => void) => {
    const copy = good.slice();
    change(new DataView(copy.buffer));
    return copy;
  };
  const without = (name: string) =>
    tensorFile(Object.fromEntries(Object.entries(fields).filter(([key]) => key !== name)));
  const withField = (name: string, shape: number[], data: Float32Array | Uint8Array) =>
    tensorFile({ ...fields, [name]: { shape, data } });
  const floats = (values: number[]) => Float32Array.from(values);
  test.each<[string, () => Uint8Array, RegExp]>([
    ['empty', () => new Uint8Array(), /byte 0: not a tensor file/],
    ['text', () => Buffer.from('this is no BRDF at all, is it'), /not a tensor file; expected it to begin/],
    ['magic alone', () => good.subarray(0, 12), /byte 12: the file ends here/],
    ['version', () => changed((v) => v.setUint8(12, 2)), /byte 12: version 2.0; expected 1.0/],
    ['fields', () => changed((v) => v.setUint32(14, 4e9, true)), /byte 14: 4000000000 fields/],
    ['dimensions', () => changed((v) => v.setUint16(at('ndf') + 3, 99, true)), /"ndf": 99 dimensions/],
    ['type', () => changed((v) => v.setUint8(at('ndf') + 5, 77)), /"ndf": no type has the number 77/],
    [
      'other type',
      () => changed((v) => v.setUint8(at('ndf') + 5, 5)),
      /"ndf": type 5; expected 10 \(float32\)/,
    ],
    [
      'place',
      () => changed((v) => v.setUint32(at('ndf') + 6, 2 ** 31, true)),
      /"ndf": 96 x 96 values .* the file ends at/,
    ],
    [
      'enormous',
      () => changed((v) => v.setUint32(at('ndf') + 18, 2 ** 31, true)),
      /"ndf": .*; the file ends at/,
    ],
    [
      'rank',
      () => withField('sigma', [9216], fields.sigma?.data as Float32Array),
      /"sigma": 1 dimensions; expected 2/,
    ],
    ['no vndf', () => without('vndf'), /there is no field "vndf"; the file has description, jacobian, phi_i/],
    ['no colours', () => without('rgb'), /there is no field "rgb"/],
    ['angles', () => withField('theta_i', [3], floats([0, 1, 0.5])), /"theta_i": angle 2 is 0.5 after 1/],
    [
      'degrees',
      () => withField('theta_i', [3], floats([0, 45, 90])),
      /"theta_i": angle 1 is 45; expected radians/,
    ],
    [
      'NaN',
      () => withField('theta_i', [3], floats([0, Number.NaN, 1])),
      /"theta_i": value 1 is NaN; expected a finite/,
    ],
    [
      'fewer',
      () => withField('theta_i', [2], floats([0, 1])),
      /"luminance": 1 x 3 x 4 x 4 values; expected 1 x 2 x/,
    ],
    [
      'a third of a turn',
      () => withField('phi_i', [3], floats([0, 1, 2])),
      /"phi_i": from 0 to 2; expected a turn/,
    ],
    [
      'negative ndf',
      () => withField('ndf', [2, 2], floats([1, 1, -1, 1])),
      /"ndf": value 2 is -1; .* at least 0/,
    ],
    ['thin', () => withField('ndf', [1, 4], floats([1, 1, 1, 1])), /"ndf": 1 x 4 values; expected 2 to 4096/],
    [
      'no facets',
      () => withField('vndf', [1, 3, 2, 2], floats([1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1])),
      /"vndf": nothing but 0 for phi_i 0, theta_i 1/,
    ],
    ['jacobian', () => withField('jacobian', [2], Uint8Array.of(1, 1)), /"jacobian": 2 values; expected 1/],
    [
      'colours',
      () => withField('rgb', [1, 3, 4, 4, 4], new Float32Array(192)),
      /"rgb": 1 x 3 x 4 x 4 x 4 values; expected 1 x 3 x 3 x 4 x 4/,
    ],
  ])('%s', (name, bytes, message) => {
    expect(() => readRgl(bytes(), `${name}.bsdf`)).toThrow(message);
    expect(() => readRgl(bytes(), `${name}.bsdf`)).toThrow(new RegExp(`^${name}\\.bsdf: byte \\d+: `));
  });

  test('cut or garbled anywhere', () => {
    const random = createRandom(7);
    for (let i = 0; i < 300; i++) {
      const copy = good.slice(0, i % 3 === 0 ? Math.floor(random() * good.length) : good.length);
      // Mostly in the head, where sizes and places stand.
      for (let k = 0; k < 4; k++)
        copy[Math.floor(random() * (k === 0 ? copy.length : Math.min(copy.length, 450)))] = Math.floor(
          random() * 256,
        );
      try {
        const data = readRgl(copy, 'garbled.bsdf');
        expect(data.every(Number.isFinite)).toBe(true);
      } catch (error) {
        expect(error).toBeInstanceOf(ByteError);
      }
    }
  });
});
