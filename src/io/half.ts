/** IEEE 754 half precision floats, as 16-bit integers. */

const bits = new DataView(new ArrayBuffer(4));

/** Rounds to the nearest half, ties to even; too large a number becomes infinite. */
export function toHalf(value: number): number {
  bits.setFloat32(0, value);
  const word = bits.getUint32(0);
  const sign = (word >>> 16) & 0x8000;
  const exponent = ((word >>> 23) & 0xff) - 127;
  const mantissa = word & 0x7fffff;
  if (exponent === 128) return sign | 0x7c00 | (mantissa ? 0x200 : 0);
  if (exponent > 15) return sign | 0x7c00;
  // Normal halves keep 10 of 23 bits; subnormal ones lose one more for each power of two below 2^-14.
  if (exponent >= -14) return sign | roundShift(((exponent + 15) << 23) | mantissa, 13);
  if (exponent < -25) return sign;
  return sign | roundShift(mantissa | 0x800000, -1 - exponent);
}

/** A carry out of the mantissa runs into the exponent, which is what it should do. */
function roundShift(value: number, shift: number): number {
  const kept = value >>> shift;
  const rest = value & ((1 << shift) - 1);
  const tie = 1 << (shift - 1);
  return rest > tie || (rest === tie && kept & 1) ? kept + 1 : kept;
}

export function fromHalf(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >>> 10) & 0x1f;
  const mantissa = half & 0x3ff;
  if (exponent === 0) return sign * mantissa * 2 ** -24;
  if (exponent === 31) return mantissa ? Number.NaN : sign * Number.POSITIVE_INFINITY;
  return sign * (1 + mantissa / 1024) * 2 ** (exponent - 15);
}
