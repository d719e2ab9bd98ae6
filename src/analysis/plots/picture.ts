/** Square pictures that are made at growing sizes: who asks can show the first while the next is made. */
import type { Rgb } from './curve.ts';

export interface Picture {
  readonly size: number;
  /** RGB, linear, rows from the top. */
  readonly pixels: Float32Array;
  /** The share of each pixel that is covered; null where all of it is. */
  readonly alpha: Float32Array | null;
}

/** So many pixels are computed between two pauses. */
const PIXELS_AT_ONCE = 2048;

/**
 * @param at the value at a point of the unit square, y upwards
 * @returns null in the pauses, in which whoever drives it may stop
 */
export function* pictures(
  sizes: readonly number[],
  at: (x: number, y: number) => Rgb,
): Generator<Picture | null> {
  for (const size of sizes) {
    const pixels = new Float32Array(3 * size * size);
    for (let i = 0; i < size * size; i++) {
      const [column, row] = [i % size, Math.floor(i / size)];
      pixels.set(at((column + 0.5) / size, 1 - (row + 0.5) / size), 3 * i);
      if (i % PIXELS_AT_ONCE === PIXELS_AT_ONCE - 1) yield null;
    }
    yield { size, pixels, alpha: null };
  }
}
