import fc from 'fast-check';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { FloatType } from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { ByteError } from '../../src/io/bytes.ts';
import { decodeExr, type ExrImage, encodeExr } from '../../src/io/exr.ts';
import { fromHalf, toHalf } from '../../src/io/half.ts';

/** A smooth image with some noise, in R, G, B of one type and A of another. */
function picture(
  width: number,
  height: number,
  [colorType, alphaType]: ['half' | 'float', 'half' | 'float'] = ['float', 'half'],
): ExrImage {
  const channel = (name: string, type: 'half' | 'float', seed: number) => ({
    name,
    type,
    pixels: Float32Array.from({ length: width * height }, (_, i) => {
      const value = Math.sin(i * 0.01 + seed) ** 2 * 40 + ((i * 2654435761) % 97) * 1e-3;
      return type === 'half' ? fromHalf(toHalf(value)) : value;
    }),
  });
  return {
    width,
    height,
    channels: [
      channel('R', colorType, 0),
      channel('G', colorType, 1),
      channel('B', colorType, 2),
      channel('A', alphaType, 3),
    ],
  };
}

const byName = (image: ExrImage) =>
  Object.fromEntries(image.channels.map(({ name, ...rest }) => [name, rest]));

describe('half floats', () => {
  test('all of them survive the way through a number', () => {
    for (let half = 0; half < 0x10000; half++) {
      const value = fromHalf(half);
      expect(Number.isNaN(value) ? 0x7e00 : toHalf(value)).toBe(Number.isNaN(value) ? 0x7e00 : half);
    }
  });

  test('a number becomes the nearest half, ties to even', () => {
    expect(fromHalf(toHalf(1 + 2 ** -11))).toBe(1);
    expect(fromHalf(toHalf(1 + 3 * 2 ** -11))).toBe(1 + 2 ** -9);
    expect(fromHalf(toHalf(2 ** -25))).toBe(0);
    expect(fromHalf(toHalf(2 ** -25 * 1.001))).toBe(2 ** -24);
    expect(fromHalf(toHalf(65519))).toBe(65504);
    expect(fromHalf(toHalf(-65520))).toBe(Number.NEGATIVE_INFINITY);
    fc.assert(
      fc.property(fc.double({ min: -65504, max: 65504, noNaN: true }), (value) => {
        const half = toHalf(value);
        const error = Math.abs(fromHalf(half) - value);
        const neighbours = [half - 1, half + 1].filter((h) => (h & 0x7c00) !== 0x7c00 && h >= 0);
        for (const neighbour of neighbours) {
          expect(error).toBeLessThanOrEqual(
            Math.abs(fromHalf(neighbour) - value) + Math.abs(value) * 2 ** -23,
          );
        }
      }),
    );
  });
});

describe('EXR', () => {
  test.each(['zip', 'none'] as const)('comes back as it was, compression %s', (compression) => {
    const attributes = { 'irradia.samples': 4096, software: 'Irradia é', negative: -1 };
    const image = { ...picture(37, 21), attributes };
    const decoded = decodeExr(encodeExr(image, { compression }), 'image.exr');
    expect(byName(decoded)).toEqual(byName(image));
    expect(decoded.attributes).toEqual(attributes);
    expect([decoded.width, decoded.height]).toEqual([37, 21]);
  });

  test('keeps channels and attributes with long names, infinities and NaN', () => {
    const pixels = Float32Array.of(Number.POSITIVE_INFINITY, Number.NaN, -0, 1e-45);
    const name = `${'layer.'.repeat(10)}variance`;
    const image: ExrImage = {
      width: 2,
      height: 2,
      channels: [{ name, type: 'float', pixels }],
      attributes: { [name]: 'x' },
    };
    const decoded = decodeExr(encodeExr(image), 'image.exr');
    expect(decoded.channels).toEqual(image.channels);
    expect(decoded.attributes).toEqual(image.attributes);
  });

  test('any image of any size comes back', () => {
    const sized = fc
      .tuple(fc.integer({ min: 1, max: 20 }), fc.integer({ min: 1, max: 40 }))
      .chain(([width, height]) =>
        fc.float32Array({ minLength: width * height, maxLength: width * height }).map((pixels) => ({
          width,
          height,
          channels: [{ name: 'Y', type: 'float' as const, pixels }],
        })),
      );
    fc.assert(
      fc.property(sized, (image) => {
        expect(decodeExr(encodeExr(image), 'image.exr').channels).toEqual(image.channels);
      }),
    );
  });

  // three.js expects all channels to be of one type.
  test.each([
    ['zip', 'float'],
    ['zip', 'half'],
    ['none', 'float'],
    ['none', 'half'],
  ] as const)("three.js's loader reads it, compression %s, %s", (compression, type) => {
    const image = picture(33, 18, [type, type]);
    const file = encodeExr(image, { compression });
    const loaded = new EXRLoader().setDataType(FloatType).parse(file.buffer as ArrayBuffer) as {
      width: number;
      height: number;
      data: Float32Array;
    };
    expect([loaded.width, loaded.height]).toEqual([33, 18]);
    const { R, A } = byName(image);
    for (let y = 0; y < 18; y++) {
      for (let x = 0; x < 33; x++) {
        // three.js turns rows over, as textures want them.
        const at = ((17 - y) * 33 + x) * 4;
        expect(loaded.data[at]).toBe(R?.pixels[y * 33 + x]);
        expect(loaded.data[at + 3]).toBe(A?.pixels[y * 33 + x]);
      }
    }
  });

  test('refuses what cannot be written', () => {
    const image = picture(4, 4);
    expect(() => encodeExr({ ...image, width: 5 })).toThrow('channel R has 16 pixels, not 5 x 4');
    expect(() => encodeExr({ ...image, attributes: { compression: 1 } })).toThrow(
      "'compression' cannot name",
    );
    expect(() => encodeExr({ ...image, attributes: { exposure: 0.5 } })).toThrow('not a 32-bit integer');
    expect(() => encodeExr({ ...image, channels: [...image.channels, ...image.channels] })).toThrow(
      'different names',
    );
  });
});

describe('broken EXR files', () => {
  const file = encodeExr({ ...picture(24, 20), attributes: { note: 'text' } });
  const outcome = (bytes: Uint8Array) => {
    try {
      decodeExr(bytes, 'broken.exr');
      return null;
    } catch (error) {
      return error;
    }
  };

  test('say which file, which byte and what is wrong', () => {
    expect(outcome(new Uint8Array(0))).toMatchObject({
      message: 'broken.exr: byte 0: the file ends here; expected 4 more bytes',
      offset: 0,
    });
    expect(outcome(new TextEncoder().encode('not an image at all'))).toMatchObject({
      message: 'broken.exr: byte 4: not an OpenEXR file',
    });
    const tiled = file.slice();
    tiled[5] = 2;
    expect(outcome(tiled)).toMatchObject({ message: expect.stringContaining('a file of tiles') });
    const piz = file.slice();
    piz[new TextDecoder('latin1').decode(file).indexOf('compression\0compression\0') + 28] = 4;
    expect(outcome(piz)).toMatchObject({
      message: expect.stringContaining('compression PIZ is not supported'),
    });
  });

  test('are refused wherever they are cut off', () => {
    for (let length = 0; length < file.length; length += 7) {
      expect(outcome(file.subarray(0, length)), `${length} bytes`).toBeInstanceOf(ByteError);
    }
  });

  test('do no harm whatever byte is wrong', () => {
    fc.assert(
      fc.property(fc.nat(file.length - 1), fc.nat(255), (at, value) => {
        const bytes = file.slice();
        bytes[at] = value;
        const error = outcome(bytes);
        if (error !== null) expect(error).toBeInstanceOf(ByteError);
      }),
      { numRuns: 500 },
    );
  });

  test('cannot ask for more memory than their size justifies', () => {
    const huge = file.slice();
    const window = new TextDecoder('latin1').decode(file).indexOf('dataWindow\0box2i\0') + 21;
    new DataView(huge.buffer).setInt32(window + 8, 2 ** 30, true);
    expect(outcome(huge)).toMatchObject({
      message: expect.stringContaining('too short for 1073741825 x 20 pixels'),
    });
  });
});
