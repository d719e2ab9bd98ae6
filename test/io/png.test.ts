import sharp from 'sharp';
import { describe, expect, test } from 'vitest';
import { encodePng } from '../../src/io/png.ts';

const decode = async (file: Uint8Array) => {
  const { data, info } = await sharp(file).raw().toBuffer({ resolveWithObject: true });
  return { pixels: new Uint8Array(data), width: info.width, height: info.height, channels: info.channels };
};

describe('PNG', () => {
  test.each([
    ['noise', (i: number) => (i * 2654435761) >>> 24],
    ['a gradient', (i: number) => (i >> 3) & 255],
    ['one colour', () => 200],
  ])('%s is read as it was written', async (_, value) => {
    const pixels = Uint8Array.from({ length: 61 * 17 * 4 }, (_, i) => value(i));
    expect(await decode(encodePng(pixels, 61, 17))).toEqual({ pixels, width: 61, height: 17, channels: 4 });
  });

  test('smooth pictures are filtered before they are compressed', () => {
    const pixels = Uint8Array.from({ length: 256 * 256 * 4 }, (_, i) => ((i >> 2) & 255) ^ ((i >> 10) & 3));
    expect(encodePng(pixels, 256, 256).length).toBeLessThan(pixels.length / 50);
  });

  test('refuses pixels that are not as many as the size says', () => {
    expect(() => encodePng(new Uint8Array(15), 2, 2)).toThrow('15 bytes are not 2 x 2 RGBA pixels');
  });
});
