/**
 * Adaptive sampling: where the picture is good enough already, in squares of pixels, no more samples are taken.
 *
 * A tile's error is that of H. Dammertz, J. Hanika, A. Keller and H. Lensch, 2010, "A Hierarchical Automatic Stopping
 * Condition for Monte Carlo Global Illumination", section 2: the standard deviation of the means over the square root
 * of the luminance. In units of the root of the picture's mean it compares with Film.relativeError(), and where no
 * tile has more than E, the picture has not, either: the mean of the tiles' variances is then E^2 mean^2 at most.
 *
 * That a tile ends depends on its own samples: one that has missed what is rare ends early and stays too dark. Its
 * neighbours, the first samples that all pixels have, and a goal that is not set too high keep this bias small
 * (D. Kirk and J. Arvo, 1991, "Unbiased Sampling Techniques for Image Synthesis").
 */
import type { Film } from './film.ts';
import type { TileMask } from './path-tracer.ts';
import { forEachTile, tileGrid } from './tiles.ts';

/** Samples of each pixel before any tile may end: the error as fewer tell it is not to be trusted. */
export const BASE_SAMPLES = 16;

/** A tile that has ended begins anew only if its error, in units of the goal, has become larger than this. */
const BEGIN_ANEW = 1.25;
/** A tile beside one that goes on does so, too, if its error is above this part of the goal. */
const BESIDE = 0.5;
/** A tile darker than this part of the picture's mean counts as one that has it. */
const DARKEST = 0.01;

/** The error of every tile, row by row; infinite where a pixel has less than two samples. */
export function tileErrors(film: Film): Float32Array {
  const { width, height } = film;
  const { columns, rows } = tileGrid(width, height);
  const [means, variances] = [new Float64Array(columns * rows), new Float64Array(columns * rows)];
  const shadows = new Float64Array(columns * rows);
  let whole = 0;
  forEachTile(width, height, ({ tile, left, top, right, bottom }) => {
    let [mean, variance] = [0, 0];
    for (let y = top; y < bottom; y++) {
      for (let i = 3 * (y * width + left); i < 3 * (y * width + right); i++) {
        const n = film.count[Math.floor(i / 3)]!;
        const value = n > 0 ? film.radiance[i]! / n : 0;
        mean += value;
        variance +=
          n < 2 ? Number.POSITIVE_INFINITY : Math.max(0, film.squares[i]! / n - value * value) / (n - 1);
      }
    }
    for (let y = top; y < bottom; y++)
      for (let x = left; x < right; x++) shadows[tile]! += film.shadowVariance(y * width + x);
    const values = 3 * (right - left) * (bottom - top);
    shadows[tile]! /= values / 3;
    means[tile] = mean / values;
    variances[tile] = variance / values;
    whole += mean;
  });
  whole /= film.radiance.length;
  return Float32Array.from(means, (mean, tile) => {
    // A shadow in a transparent picture counts as before a background as bright as the picture is in the mean.
    const unit = Math.max(mean, (shadows[tile]! > 0 ? 1 : DARKEST) * whole) * whole;
    return unit > 0
      ? Math.sqrt((variances[tile]! + shadows[tile]! * whole * whole) / unit)
      : variances[tile]! > 0
        ? Number.POSITIVE_INFINITY
        : 0;
  });
}

/**
 * The tiles that go on.
 *
 * @param goal the error that is good enough
 * @param previous the tiles that the last samples were taken of
 * @returns null if there are none: the picture is complete
 */
export function openTiles(film: Film, goal: number, previous: TileMask | null): TileMask | null {
  const errors = tileErrors(film);
  const { columns } = tileGrid(film.width, film.height);
  const isOpen = (tile: number) =>
    errors[tile]! > goal * (previous === null || previous[tile] ? 1 : BEGIN_ANEW);
  const open = Uint8Array.from(errors, (_, tile) => (isOpen(tile) ? 1 : 0));
  if (!open.includes(1)) return null;
  return open.map((own, tile) => {
    if (own || errors[tile]! <= BESIDE * goal) return own;
    const [column, row] = [tile % columns, Math.floor(tile / columns)];
    for (let y = row - 1; y <= row + 1; y++) {
      for (let x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
        if (open[y * columns + x]) return 1;
      }
    }
    return 0;
  });
}
