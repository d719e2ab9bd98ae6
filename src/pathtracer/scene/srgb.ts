/** IEC 61966-2-1: a byte of an sRGB image as a linear value. */
export function srgbToLinear(byte: number): number {
  const s = byte / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
}

/** srgbToLinear() of every byte. */
export const srgbTable: readonly number[] = Array.from({ length: 256 }, (_, byte) => srgbToLinear(byte));
