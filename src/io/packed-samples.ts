/** Samples of reflection in 16 bits each, as documents keep them (docs/decisions/measured-data.md). */

/** No reflection is as strong: a mirror seen through a thousandth of a degree is not. */
export const LARGEST = 2 ** 24;
const SMALLEST = 1 / LARGEST;
/** Codes from 1 divide the logarithms of SMALLEST to LARGEST evenly; 0 is 0. */
const CODES_PER_OCTAVE = 65534 / 48;

export const PACKED_SAMPLE_SIZE = 2;

/** Writes non-negative samples, within .03 % of their value, from a byte on. */
export function packSamples(samples: Float32Array, target: Uint8Array, at: number): void {
  const view = new DataView(target.buffer, target.byteOffset, target.byteLength);
  for (const [i, value] of samples.entries()) {
    const code = value < SMALLEST ? 0 : 1 + Math.round((Math.log2(value) + 24) * CODES_PER_OCTAVE);
    view.setUint16(at + i * PACKED_SAMPLE_SIZE, code, true);
  }
}

/** Reads as many samples as the target holds. */
export function unpackSamples(bytes: Uint8Array, at: number, target: Float32Array): void {
  const values = Float32Array.from({ length: 65536 }, (_, code) =>
    code === 0 ? 0 : 2 ** ((code - 1) / CODES_PER_OCTAVE - 24),
  );
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let i = 0; i < target.length; i++)
    target[i] = values[view.getUint16(at + i * PACKED_SAMPLE_SIZE, true)] as number;
}
