/**
 * Measured BRDFs in the format of the MERL database (`.binary`), and packed to a quarter of that size, as a
 * document keeps them (docs/decisions/measured-data.md).
 */
import { ByteError, ByteReader, checkSize } from './bytes.ts';
import { LARGEST, PACKED_SAMPLE_SIZE, packSamples, unpackSamples } from './packed-samples.ts';

/** Bins of theta_h, theta_d and phi_d; phi_d varies fastest. */
export const MERL_BINS = [90, 90, 180] as const;
export const MERL_SAMPLES = MERL_BINS[0] * MERL_BINS[1] * MERL_BINS[2];
/** What the database's values are multiplied by, red, green and blue, to be in 1/sr. */
export const MERL_SCALES = [1 / 1500, 1.15 / 1500, 1.66 / 1500] as const;

const HEADER_SIZE = 12;
const FILE_SIZE = HEADER_SIZE + MERL_SAMPLES * 3 * 8;
const COLORS = ['red', 'green', 'blue'] as const;

export const PACKED_MERL_MAGIC: Uint8Array = new TextEncoder().encode('irrmerl1');
const PACKED_SIZE = PACKED_MERL_MAGIC.length + MERL_SAMPLES * 3 * PACKED_SAMPLE_SIZE;

/**
 * The samples as RGB triples in 1/sr, in the order of the file. Where the file has no data they have the
 * value of the nearest theta_d that has.
 *
 * @throws ByteError naming the file, the byte and what is wrong there
 */
export function readMerl(bytes: Uint8Array, fileName: string): Float32Array {
  return PACKED_MERL_MAGIC.every((byte, i) => bytes[i] === byte)
    ? unpack(bytes, fileName)
    : readBinary(bytes, fileName);
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

/** The samples in 16 bits each, within .03 % of the value. */
export function packMerl(data: Float32Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(PACKED_SIZE);
  bytes.set(PACKED_MERL_MAGIC);
  packSamples(data, bytes, PACKED_MERL_MAGIC.length);
  return bytes;
}

function unpack(bytes: Uint8Array, fileName: string): Float32Array {
  checkSize(bytes, PACKED_SIZE, fileName);
  const data = new Float32Array(MERL_SAMPLES * 3);
  unpackSamples(bytes, PACKED_MERL_MAGIC.length, data);
  return data;
}
