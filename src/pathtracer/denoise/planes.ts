/** Pictures as planes of float32, one for each component: what the filters work on. */
import type { Film } from '../film.ts';
import { boxMean } from './statistics.ts';

export interface Planes {
  readonly width: number;
  readonly height: number;
  readonly channels: readonly Float32Array[];
  /** Of the means, summed over the channels. */
  readonly variance: Float32Array;
}

/** What the denoiser reads of a film. */
export interface FilmPlanes {
  /** RGB. The variance is 0 where a pixel has one sample or none: it is not known. */
  readonly radiance: Planes;
  readonly albedo: Planes;
  readonly normal: Planes;
  /** Distance in metres where something was hit. */
  readonly depth: Float32Array;
  /** The part of the samples that hit something; 1 about shadows on the ground, which have noise like any surface. */
  readonly alpha: Float32Array;
}

/** Pixels from a shadow on the ground, to each side, where few samples may have missed it. */
const PENUMBRA = 8;

export function filmPlanes(film: Film): FilmPlanes {
  const { width, height, count } = film;
  const pixels = width * height;
  const plane = (value: (pixel: number) => number) =>
    new Float32Array(pixels).map((_, pixel) => {
      const x = value(pixel);
      return Number.isFinite(x) ? x : 0;
    });
  const rgb = (sums: Float32Array | Float64Array) =>
    [0, 1, 2].map((c) => plane((pixel) => sums[3 * pixel + c]! / count[pixel]!));
  const squared = (channels: readonly Float32Array[], pixel: number) =>
    channels.reduce((sum, channel) => sum + channel[pixel]! ** 2, 0);
  const variance = (channels: readonly Float32Array[], squares: (pixel: number) => number) =>
    plane((pixel) => {
      const n = count[pixel]!;
      // Float32 sums round: below their last digits there is no variance to be seen.
      return n < 2 ? 0 : Math.max(0, squares(pixel) / n - squared(channels, pixel)) / (n - 1);
    });
  const [radiance, albedo, normal] = [rgb(film.radiance), rgb(film.albedo), rgb(film.normal)];
  const radianceSquares = (pixel: number) =>
    film.squares[3 * pixel]! + film.squares[3 * pixel + 1]! + film.squares[3 * pixel + 2]!;
  const planes = (channels: readonly Float32Array[], squares: (pixel: number) => number): Planes => ({
    width,
    height,
    channels,
    variance: variance(channels, squares),
  });
  const shaded = boxMean(
    film.shadow.map((sum) => (sum > 0 ? 1 : 0)),
    film,
    PENUMBRA,
  );
  return {
    radiance: planes(radiance, radianceSquares),
    albedo: planes(albedo, (pixel) => film.albedoSquares[pixel]!),
    // Normals of single samples have length 1, where there are any.
    normal: planes(normal, (pixel) => film.alpha[pixel]!),
    depth: film.meanDepth(),
    alpha: plane((pixel) => (shaded[pixel]! > 0 ? 1 : film.alpha[pixel]! / count[pixel]!)),
  };
}
