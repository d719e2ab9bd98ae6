import { srgbToLinear } from '../../color/srgb.ts';

/** The linear value of every byte of an sRGB image. */
export const srgbTable: readonly number[] = Array.from({ length: 256 }, (_, byte) =>
  srgbToLinear(byte / 255),
);
