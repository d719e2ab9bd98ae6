/**
 * Radiance HDR images (.hdr, .pic): three mantissas that share an exponent. Ward 1991, "Real Pixels", Graphics Gems II; the
 * layout is that of Radiance's own reader, src/common/color.c.
 */
import { ByteError } from './bytes.ts';
import { toHalf } from './half.ts';
import { MOST_TEXELS } from './image-size.ts';

export interface HdrImage {
  width: number;
  height: number;
  /** RGBA as half floats, rows from the top; alpha is 1. */
  pixels: Uint16Array<ArrayBuffer>;
}

const LARGEST_HALF = 0x7bff;
const ONE = toHalf(1);
/** Of the whole header; there are some lines of it in any file. */
const MOST_HEADER = 64 * 1024;

/** Mantissa and exponent as a half float: each value is in the middle of those that are stored so. */
const halves = new Uint16Array(256 * 256);
for (let exponent = 1; exponent < 256; exponent++)
  for (let mantissa = 0; mantissa < 256; mantissa++)
    halves[256 * exponent + mantissa] = Math.min(
      toHalf((mantissa + 0.5) * 2 ** (exponent - 136)),
      LARGEST_HALF,
    );

/** @throws ByteError */
export function decodeHdr(bytes: Uint8Array, fileName: string): HdrImage {
  const fail = (at: number, message: string): never => {
    throw new ByteError(fileName, at, message);
  };
  const { width, height, start } = readHeader(bytes, fail);
  // However it is packed, a row takes four bytes.
  if (width * height > MOST_TEXELS || 4 * height > bytes.length - start)
    fail(start, `an image of ${width} x ${height} texels, for which the file is too short or memory is`);
  const pixels = new Uint16Array(4 * width * height);
  const line = new Uint8Array(4 * width);
  let at = start;
  for (let y = 0; y < height; y++) {
    at = readLine(bytes, at, line, width, fail);
    for (let x = 0; x < width; x++) {
      const exponent = 256 * line[3 * width + x]!;
      const to = 4 * (y * width + x);
      for (let c = 0; c < 3; c++) pixels[to + c] = halves[exponent + line[c * width + x]!]!;
      pixels[to + 3] = ONE;
    }
  }
  return { width, height, pixels };
}

type Fail = (at: number, message: string) => never;

function readHeader(bytes: Uint8Array, fail: Fail): { width: number; height: number; start: number } {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, MOST_HEADER));
  if (!/^#\?(RADIANCE|RGBE)\b/.test(text)) fail(0, 'not a Radiance HDR image');
  const blank = /\r?\n\r?\n/.exec(text);
  if (blank === null) return fail(bytes.length, 'the header does not end with an empty line');
  const format = /^FORMAT=(.*?)\s*$/m.exec(text.slice(0, blank.index))?.[1];
  if (format !== undefined && format !== '32-bit_rle_rgbe')
    fail(0, `its texels are in ${format.slice(0, 40)}; expected 32-bit_rle_rgbe`);
  const at = blank.index + blank[0].length;
  const line = /^[^\n]{0,80}\n/.exec(text.slice(at))?.[0] ?? '';
  const size = /^-Y +(\d{1,9}) +\+X +(\d{1,9})\s*$/.exec(line);
  if (size === null)
    return fail(
      at,
      `a size of "${line.trim().slice(0, 40)}"; expected "-Y height +X width", rows from the top`,
    );
  const [height, width] = [Number(size[1]), Number(size[2])];
  if (width < 1 || height < 1) fail(at, 'an image without texels');
  return { width, height, start: at + line.length };
}

/** One row, into four rows of its components; returns where the next one begins. */
function readLine(bytes: Uint8Array, start: number, line: Uint8Array, width: number, fail: Fail): number {
  const isPacked = bytes[start] === 2 && bytes[start + 1] === 2 && (bytes[start + 2] ?? 128) < 128;
  if (width < 8 || width > 0x7fff || !isPacked) return readOldLine(bytes, start, line, width, fail);
  if (256 * bytes[start + 2]! + (bytes[start + 3] ?? 0) !== width)
    fail(start, 'a row of another width than the image');
  let at = start + 4;
  let to = 0;
  for (let c = 1; c <= 4; c++)
    while (to < c * width) {
      const code = bytes[at++] ?? fail(bytes.length, 'the file ends within a row');
      const count = code > 128 ? code - 128 : code;
      if (count === 0 || to + count > c * width)
        fail(at - 1, `a run of ${count} that the row has no room for`);
      const used = code > 128 ? 1 : count;
      if (at + used > bytes.length) fail(bytes.length, 'the file ends within a row');
      if (code > 128) line.fill(bytes[at]!, to, to + count);
      else line.set(bytes.subarray(at, at + count), to);
      at += used;
      to += count;
    }
  return at;
}

/** Texel by texel; one of 1, 1, 1 says how often the last one is repeated, the next such one 256 times as often. */
function readOldLine(bytes: Uint8Array, start: number, line: Uint8Array, width: number, fail: Fail): number {
  let at = start;
  let shift = 0;
  for (let x = 0; x < width; at += 4) {
    if (at + 4 > bytes.length) fail(bytes.length, 'the file ends within a row');
    const texel = bytes.subarray(at, at + 4);
    if (texel[0] === 1 && texel[1] === 1 && texel[2] === 1) {
      const count = texel[3]! * 2 ** shift;
      if (x === 0 || x + count > width) fail(at, `a run of ${count} that the row has no room for`);
      for (let c = 0; c < 4; c++) line.fill(line[c * width + x - 1]!, c * width + x, c * width + x + count);
      x += count;
      shift += 8;
      if (shift > 16) fail(at, 'a run of runs');
    } else {
      for (let c = 0; c < 4; c++) line[c * width + x] = texel[c]!;
      x += 1;
      shift = 0;
    }
  }
  return at;
}
