/**
 * Anisotropic BRDFs measured at CSAIL (`.dat`): A. Ngan, F. Durand and W. Matusik, 2005, "Experimental Analysis of
 * BRDF Models", Eurographics Symposium on Rendering. Sixteen 32-bit numbers, then 32-bit floats: all of red, all of
 * green, all of blue, over theta_in, theta_out, phi_out - phi_in and phi_in, which varies fastest. And the same packed,
 * as a document keeps it.
 */
import { ByteError, ByteReader, checkSize } from './bytes.ts';
import { fillNegative } from './fill-negative.ts';
import { LARGEST, PACKED_SAMPLE_SIZE, packSamples, unpackSamples } from './packed-samples.ts';

const AXES = ['theta_in', 'theta_out', 'phi_diff', 'phi_in'] as const;
const HEADER_SIZE = 16 * 4;
/**
 * What the file's numbers are multiplied by. Nothing that was published says what their unit is; BRDF Explorer, whose
 * pictures people know, takes them times ten.
 */
export const CSAIL_SCALE = 10;

/** The lookup's own: counts of bins, and whether phi_diff ends at pi. */
const HEAD = 2;
/** A file has up to 65 million samples; this many are 134 MB on the GPU. */
const MOST_SAMPLES = 2 ** 23;
const LONGEST_AXIS = 4096;

export const PACKED_CSAIL_MAGIC: Uint8Array = new TextEncoder().encode('irrcsai1');

type Bins = [thetaIn: number, thetaOut: number, phiDiff: number, phiIn: number];

/**
 * The triples that models/measured/csail.brdf reads: the numbers of bins of theta_in, theta_out and phi_diff; that of
 * phi_in, and 1 if phi_diff ends at pi; then the samples in 1/sr. Where the file has no data they have the value of
 * the nearest bin that has, along theta_out if possible.
 *
 * @throws ByteError naming the file, the byte and what is wrong there
 */
export function readCsail(bytes: Uint8Array, fileName: string): Float32Array {
  const packed = PACKED_CSAIL_MAGIC.every((byte, i) => bytes[i] === byte);
  return packed ? unpack(bytes, fileName) : readDat(bytes, fileName);
}

const samplesOf = (bins: readonly number[]) => bins.reduce((product, count) => product * count, 1);

function readBins(reader: ByteReader): Bins {
  return AXES.map((axis) => {
    const at = reader.position;
    const count = reader.int32();
    if (count < 1 || count > LONGEST_AXIS)
      throw new ByteError(
        reader.fileName,
        at,
        `not a CSAIL BRDF: ${count} bins of ${axis}; expected 1 to ${LONGEST_AXIS}`,
      );
    return count;
  }) as Bins;
}

function readDat(bytes: Uint8Array, fileName: string): Float32Array {
  const reader = new ByteReader(bytes, fileName);
  const bins = readBins(reader);
  const expectNumber = (at: number, what: string, ...allowed: number[]): number => {
    reader.seek(at * 4);
    const value = reader.int32();
    if (!allowed.includes(value))
      throw new ByteError(fileName, at * 4, `${what} is ${value}; expected ${allowed.join(' or ')}`);
    return value;
  };
  expectNumber(6, 'the kind of parameters', 1);
  expectNumber(7, 'the kind of bins', 0);
  const half = expectNumber(9, 'half_data', 0, 1);
  expectNumber(10, 'the number of channels', 3);
  checkSize(bytes, HEADER_SIZE + samplesOf(bins) * 3 * 4, fileName);
  const coarse = coarser(bins);
  if (!coarse)
    throw new ByteError(
      fileName,
      0,
      `${bins.join(' x ')} bins; expected ${MOST_SAMPLES} in all, or even numbers of phi_diff and phi_in to halve`,
    );
  const data = new Float32Array(3 * (HEAD + samplesOf(coarse)));
  data.set([coarse[0], coarse[1], coarse[2], coarse[3], half, 0]);
  const samples = data.subarray(3 * HEAD);
  averageInto(samples, coarse, bytes, bins, fileName);
  if (!fillNegative(samples, coarse, [1, 0, 3, 2]))
    throw new ByteError(fileName, HEADER_SIZE, 'every sample is negative: the file has no data');
  return data;
}

/** The azimuths' bins, halved in turn until all samples fit. */
function coarser(bins: Bins): Bins | null {
  const [thetaIn, thetaOut, phiDiff, phiIn] = bins;
  if (samplesOf(bins) <= MOST_SAMPLES) return bins;
  const even = (count: number) => count % 2 === 0;
  if (even(phiIn) && (phiIn >= phiDiff || !even(phiDiff)))
    return coarser([thetaIn, thetaOut, phiDiff, phiIn / 2]);
  return even(phiDiff) ? coarser([thetaIn, thetaOut, phiDiff / 2, phiIn]) : null;
}

/** The mean of those samples that fall into one coarse bin and are known; -1 where none is. */
function averageInto(
  target: Float32Array,
  coarse: Bins,
  bytes: Uint8Array,
  bins: Bins,
  fileName: string,
): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = samplesOf(bins);
  const known = new Uint16Array(samplesOf(coarse));
  const [wide, narrow] = [bins[2] / coarse[2], bins[3] / coarse[3]];
  const sample = (i: number): number => {
    const value = view.getFloat32(HEADER_SIZE + 4 * i, true);
    // Written so that NaN fails it too.
    if (!(Math.abs(value) * CSAIL_SCALE <= LARGEST))
      throw new ByteError(
        fileName,
        HEADER_SIZE + 4 * i,
        `the sample is ${value}; expected a finite reflection`,
      );
    return value * CSAIL_SCALE;
  };
  // A line is all phi_in of one phi_diff. Files have 65 million samples: nothing is allocated for each.
  for (let line = 0; line * bins[3] < count; line++) {
    const thetas = Math.floor(line / bins[2]);
    const intoLine = (thetas * coarse[2] + Math.floor((line % bins[2]) / wide)) * coarse[3];
    for (let phi = 0; phi < bins[3]; phi++) {
      const i = line * bins[3] + phi;
      const [r, g, b] = [sample(i), sample(count + i), sample(2 * count + i)];
      if (r < 0 || g < 0 || b < 0) continue;
      const into = intoLine + Math.floor(phi / narrow);
      known[into]!++;
      target[3 * into]! += r;
      target[3 * into + 1]! += g;
      target[3 * into + 2]! += b;
    }
  }
  for (const [i, many] of known.entries()) {
    for (let c = 0; c < 3; c++) target[3 * i + c] = many === 0 ? -1 : (target[3 * i + c] as number) / many;
  }
}

/** Triples of readCsail() in 16 bits a number. */
export function packCsail(data: Float32Array): Uint8Array<ArrayBuffer> {
  const head = PACKED_CSAIL_MAGIC.length;
  const samples = data.subarray(3 * HEAD);
  const bytes = new Uint8Array(head + 5 * 4 + samples.length * PACKED_SAMPLE_SIZE);
  bytes.set(PACKED_CSAIL_MAGIC);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < 5; i++) view.setInt32(head + 4 * i, data[i] as number, true);
  packSamples(samples, bytes, head + 5 * 4);
  return bytes;
}

function unpack(bytes: Uint8Array, fileName: string): Float32Array {
  const reader = new ByteReader(bytes, fileName);
  reader.seek(PACKED_CSAIL_MAGIC.length);
  const bins = readBins(reader);
  const at = reader.position;
  const half = reader.int32();
  if (half !== 0 && half !== 1) throw new ByteError(fileName, at, `half_data is ${half}; expected 0 or 1`);
  checkSize(bytes, reader.position + samplesOf(bins) * 3 * PACKED_SAMPLE_SIZE, fileName);
  const data = new Float32Array(3 * (HEAD + samplesOf(bins)));
  data.set([...bins, half]);
  unpackSamples(bytes, reader.position, data.subarray(3 * HEAD));
  return data;
}
