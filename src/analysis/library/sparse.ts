/** A picture of which only those pixels are computed that their neighbours do not tell. */
import type { Rgb } from '../plots/curve.ts';

/** Pixels of a side of the blocks to begin with; their corners are computed. */
const BLOCK = 4;
/** What may differ, as a share of what is there and of white. */
const TOLERANCE = 0.012;

/**
 * @param at the colour of a pixel, also of those just beyond the picture
 * @returns RGB, rows from the top
 */
export function sparsely(size: number, at: (column: number, row: number) => Rgb): Float32Array {
  const side = BLOCK * Math.ceil(size / BLOCK) + 1;
  const known: (Rgb | undefined)[] = new Array(side * side);
  const value = (column: number, row: number): Rgb => {
    const i = row * side + column;
    const rgb = known[i] ?? at(column, row);
    known[i] = rgb;
    return rgb;
  };
  const fill = (column: number, row: number, length: number): void => {
    const corners = [
      value(column, row),
      value(column + length, row),
      value(column, row + length),
      value(column + length, row + length),
    ] as const;
    if (length === 1) return;
    const half = length / 2;
    const middle = value(column + half, row + half);
    const isEven = middle.every((c, i) => {
      const four = corners.map((corner) => corner[i as 0]);
      const mean = (four[0]! + four[1]! + four[2]! + four[3]!) / 4;
      const most = Math.max(...four, c);
      return Math.abs(c - mean) < TOLERANCE * (most + 0.1) && most - Math.min(...four) < 0.35 * (most + 0.1);
    });
    if (!isEven) {
      for (const [x, y] of [
        [0, 0],
        [half, 0],
        [0, half],
        [half, half],
      ] as const)
        fill(column + x, row + y, half);
      return;
    }
    for (let y = 0; y <= length; y++) {
      for (let x = 0; x <= length; x++) {
        const i = (row + y) * side + column + x;
        known[i] ??= between(corners, x / length, y / length);
      }
    }
  };
  for (let row = 0; row < side - 1; row += BLOCK)
    for (let column = 0; column < side - 1; column += BLOCK) fill(column, row, BLOCK);
  const pixels = new Float32Array(3 * size * size);
  for (let row = 0; row < size; row++)
    for (let column = 0; column < size; column++) pixels.set(value(column, row), 3 * (row * size + column));
  return pixels;
}

function between(corners: readonly [Rgb, Rgb, Rgb, Rgb], x: number, y: number): Rgb {
  const [a, b, c, d] = corners;
  const at = (i: 0 | 1 | 2) => (a[i] * (1 - x) + b[i] * x) * (1 - y) + (c[i] * (1 - x) + d[i] * x) * y;
  return [at(0), at(1), at(2)];
}
