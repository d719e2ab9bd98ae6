/**
 * Measured BRDFs in the format of the MERL database (`.binary`), and packed to a quarter of that size, as a
 * document keeps them (docs/decisions/measured-data.md).
 */
import { ByteError, ByteReader } from './bytes.ts';

/** Bins of theta_h, theta_d and phi_d; phi_d varies fastest. */
export const MERL_BINS = [90, 90, 180] as const;
export const MERL_SAMPLES = MERL_BINS[0] * MERL_BINS[1] * MERL_BINS[2];
/** What the database's values are multiplied by, red, green and blue, to be in 1/sr. */
export const MERL_SCALES = [1 / 1500, 1.15 / 1500, 1.66 / 1500] as const;
export const PACKED_MERL_TYPE = 'application/x-irradia-merl';

const HEADER_SIZE = 12;
const FILE_SIZE = HEADER_SIZE + MERL_SAMPLES * 3 * 8;
const COLORS = ['red', 'green', 'blue'] as const;

/** No reflection is as strong: a mirror seen through a thousandth of a degree is not. */
const LARGEST = 2 ** 24;
const SMALLEST = 1 / LARGEST;

const MAGIC = new TextEncoder().encode('irrmerl1');
const PACKED_SIZE = MAGIC.length + MERL_SAMPLES * 3 * 2;
/** Codes from 1 divide the logarithms of SMALLEST to LARGEST evenly; 0 is 0. */
const CODES_PER_OCTAVE = 65534 / 48;

/**
 * The samples as RGB triples in 1/sr, in the order of the file. Where the file has no data they have the
 * value of the nearest theta_d that has.
 *
 * @throws ByteError naming the file, the byte and what is wrong there
 */
export function readMerl(bytes: Uint8Array, fileName: string): Float32Array {
  return MAGIC.every((byte, i) => bytes[i] === byte) ? unpack(bytes, fileName) : readBinary(bytes, fileName);
}

function readBinary(bytes: Uint8Array, fileName: string): Float32Array {
  const reader = new ByteReader(bytes, fileName);
  const bins = [reader.int32(), reader.int32(), reader.int32()];
  if (bins.some((count, i) => count !== MERL_BINS[i]))
    throw new ByteError(
      fileName,
      0,
      `not a MERL BRDF: it has ${bins.join(' x ')} bins; expected ${MERL_BINS.join(' x ')}`,
    );
  checkSize(bytes, FILE_SIZE, fileName);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const data = new Float32Array(MERL_SAMPLES * 3);
  for (const [c, scale] of MERL_SCALES.entries()) {
    const start = HEADER_SIZE + c * MERL_SAMPLES * 8;
    for (let i = 0; i < MERL_SAMPLES; i++) {
      const stored = view.getFloat64(start + i * 8, true);
      const value = stored * scale;
      // Written so that NaN fails it too.
      if (!(Math.abs(value) <= LARGEST))
        throw new ByteError(
          fileName,
          start + i * 8,
          `the ${COLORS[c]} sample ${i} is ${stored}; expected a finite reflection`,
        );
      data[i * 3 + c] = value;
    }
  }
  fillMissing(data, fileName);
  return data;
}

function checkSize(bytes: Uint8Array, size: number, fileName: string): void {
  const more = size - bytes.length;
  if (more > 0)
    throw new ByteError(fileName, bytes.length, `the file ends here; expected ${more} more bytes of samples`);
  if (more < 0)
    throw new ByteError(fileName, size, `${-more} bytes after the last sample; expected the end of the file`);
}

/** Negative samples mean that there is no data. */
function fillMissing(data: Float32Array, fileName: string): void {
  const [, thetaD, phiD] = MERL_BINS;
  const step = phiD * 3;
  let found = false;
  for (let thetaH = 0; thetaH < data.length; thetaH += thetaD * step) {
    for (let row = thetaH; row < thetaH + step; row++) {
      const at = (bin: number) => row + bin * step;
      let known = 0;
      while (known < thetaD && (data[at(known)] as number) < 0) known++;
      found ||= known < thetaD;
      let value = known < thetaD ? (data[at(known)] as number) : 0;
      for (let bin = 0; bin < thetaD; bin++) {
        const own = data[at(bin)] as number;
        if (own < 0) data[at(bin)] = value;
        else value = own;
      }
    }
  }
  if (!found) throw new ByteError(fileName, HEADER_SIZE, 'every sample is negative: the file has no data');
}

/** The samples in 16 bits each: equal steps of the logarithm, within .03 % of the value. */
export function packMerl(data: Float32Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(PACKED_SIZE);
  bytes.set(MAGIC);
  const view = new DataView(bytes.buffer);
  for (const [i, value] of data.entries()) {
    const code = value < SMALLEST ? 0 : 1 + Math.round((Math.log2(value) + 24) * CODES_PER_OCTAVE);
    view.setUint16(MAGIC.length + i * 2, code, true);
  }
  return bytes;
}

function unpack(bytes: Uint8Array, fileName: string): Float32Array {
  checkSize(bytes, PACKED_SIZE, fileName);
  const values = Float32Array.from({ length: 65536 }, (_, code) =>
    code === 0 ? 0 : 2 ** ((code - 1) / CODES_PER_OCTAVE - 24),
  );
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const data = new Float32Array(MERL_SAMPLES * 3);
  for (let i = 0; i < data.length; i++)
    data[i] = values[view.getUint16(MAGIC.length + i * 2, true)] as number;
  return data;
}
