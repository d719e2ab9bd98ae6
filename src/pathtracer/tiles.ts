/** The squares of pixels that a picture can be rendered in. */
import type { TileMask } from './path-tracer.ts';

/** Pixels along the side of a tile: a whole number of a GPU's workgroups. */
export const TILE = 16;

export function tileGrid(width: number, height: number): { columns: number; rows: number } {
  return { columns: Math.ceil(width / TILE), rows: Math.ceil(height / TILE) };
}

/** The pixels of a tile, which at the picture's right and bottom may be smaller. */
export interface TilePixels {
  readonly tile: number;
  readonly left: number;
  readonly top: number;
  /** The first that is not of it. */
  readonly right: number;
  readonly bottom: number;
}

/** Calls for every tile, row by row. */
export function forEachTile(width: number, height: number, take: (tile: TilePixels) => void): void {
  const { columns, rows } = tileGrid(width, height);
  for (let tile = 0; tile < columns * rows; tile++) {
    const left = TILE * (tile % columns);
    const top = TILE * Math.floor(tile / columns);
    take({ tile, left, top, right: Math.min(width, left + TILE), bottom: Math.min(height, top + TILE) });
  }
}

/** The number of pixels in the tiles of a mask. */
export function maskedPixels(width: number, height: number, mask: TileMask): number {
  let pixels = 0;
  forEachTile(width, height, ({ tile, left, top, right, bottom }) => {
    if (mask[tile]) pixels += (right - left) * (bottom - top);
  });
  return pixels;
}

/** Pixels in the order of the film: from, to - 1. */
export interface Run {
  readonly from: number;
  readonly to: number;
}

/** The pixels of a mask's tiles, all of them if there is none, in runs of `most` pixels or less. */
export function pixelRuns(width: number, height: number, most: number, mask?: TileMask): Run[] {
  const runs: Run[] = [];
  const cut = (begin: number, end: number) => {
    for (let from = begin; from < end; from += most) runs.push({ from, to: Math.min(end, from + most) });
  };
  if (mask === undefined) {
    cut(0, width * height);
    return runs;
  }
  const { columns } = tileGrid(width, height);
  for (let y = 0; y < height; y++) {
    const row = mask.subarray(columns * Math.floor(y / TILE), columns * (Math.floor(y / TILE) + 1));
    for (let column = 0; column < columns; column++) {
      if (!row[column]) continue;
      const first = column;
      while (row[column + 1]) column++;
      cut(y * width + first * TILE, y * width + Math.min(width, (column + 1) * TILE));
    }
  }
  return runs;
}
