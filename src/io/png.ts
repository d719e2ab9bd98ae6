import { zlibSync } from 'fflate';

/** PNG files of 8-bit RGBA pixels in sRGB. Format: https://www.w3.org/TR/png-3/ */

export const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const RGBA = 6;
const PERCEPTUAL = 0;

/**
 * Rows from the top; alpha is not multiplied in.
 *
 * @param texts are kept in the header, by keywords of 1 to 79 Latin letters
 */
export function encodePng(
  pixels: Uint8Array | Uint8ClampedArray,
  width: number,
  height: number,
  texts: Readonly<Record<string, string | number>> = {},
): Uint8Array {
  if (pixels.length !== width * height * 4) {
    throw new RangeError(`${pixels.length} bytes are not ${width} x ${height} RGBA pixels`);
  }
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, RGBA, 0, 0, 0], 8);
  return concatenate([
    Uint8Array.from(SIGNATURE),
    chunk('IHDR', header),
    chunk('sRGB', Uint8Array.of(PERCEPTUAL)),
    ...Object.entries(texts).map(([keyword, text]) => chunk('iTXt', internationalText(keyword, `${text}`))),
    chunk('IDAT', zlibSync(filterRows(pixels, width * 4, height))),
    chunk('IEND', new Uint8Array(0)),
  ]);
}

/** Not compressed, of no language. */
const internationalText = (keyword: string, text: string): Uint8Array =>
  new TextEncoder().encode(`${keyword}\0\0\0\0\0${text}`);

/** Puts before each row the number of the filter whose output has the least sum of magnitudes. */
function filterRows(pixels: ArrayLike<number>, rowBytes: number, height: number): Uint8Array {
  const out = new Uint8Array((rowBytes + 1) * height);
  const candidate = new Uint8Array(rowBytes);
  for (let y = 0; y < height; y++) {
    let least = Number.POSITIVE_INFINITY;
    for (let filter = 0; filter < FILTERS.length; filter++) {
      const sum = filterRow(pixels, y * rowBytes, rowBytes, FILTERS[filter]!, candidate);
      if (sum < least) {
        least = sum;
        out[y * (rowBytes + 1)] = filter;
        out.set(candidate, y * (rowBytes + 1) + 1);
      }
    }
  }
  return out;
}

/** Predicts a byte from the ones to its left, above it, and above that one. */
type Filter = (left: number, up: number, upLeft: number) => number;

const FILTERS: readonly Filter[] = [
  () => 0,
  (left) => left,
  (_, up) => up,
  (left, up) => (left + up) >> 1,
  (left, up, upLeft) => {
    const [a, b, c] = [Math.abs(up - upLeft), Math.abs(left - upLeft), Math.abs(left + up - 2 * upLeft)];
    return a <= b && a <= c ? left : b <= c ? up : upLeft;
  },
];

function filterRow(
  pixels: ArrayLike<number>,
  start: number,
  length: number,
  predict: Filter,
  out: Uint8Array,
): number {
  let sum = 0;
  for (let i = 0; i < length; i++) {
    const at = start + i;
    const left = i >= 4 ? pixels[at - 4]! : 0;
    const up = start > 0 ? pixels[at - length]! : 0;
    const upLeft = i >= 4 && start > 0 ? pixels[at - length - 4]! : 0;
    const value = (pixels[at]! - predict(left, up, upLeft)) & 0xff;
    out[i] = value;
    sum += value < 128 ? value : 256 - value;
  }
  return sum;
}

function chunk(type: string, data: Uint8Array): Uint8Array {
  const out = new Uint8Array(data.length + 12);
  const view = new DataView(out.buffer);
  view.setUint32(0, data.length);
  out.set(new TextEncoder().encode(type), 4);
  out.set(data, 8);
  view.setUint32(out.length - 4, crc32(out.subarray(4, out.length - 4)));
  return out;
}

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

export function crc32(data: Uint8Array): number {
  let c = 0xffffffff;
  for (const byte of data) c = CRC_TABLE[(c ^ byte) & 0xff]! ^ (c >>> 8);
  return ~c >>> 0;
}

function concatenate(parts: readonly Uint8Array[]): Uint8Array {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
