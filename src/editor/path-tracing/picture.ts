/** A film as the page shows it and as a file keeps it. */

import { encodeExr } from '../../io/exr.ts';
import { toHalf } from '../../io/half.ts';
import type { Film } from '../../pathtracer/film.ts';
import type { TracedPicture } from './messages.ts';

const LARGEST_HALF = 65_504;

export function tracedPicture(film: Film): TracedPicture {
  const { width, height } = film;
  return { width, height, pixels: halfFloats(film.mean(), film.meanAlpha()) };
}

/** @param radiance RGB @returns RGBA */
export function halfFloats(radiance: Float32Array, alpha: Float32Array): Uint16Array<ArrayBuffer> {
  const pixels = new Uint16Array((4 * radiance.length) / 3);
  for (const [pixel, value] of alpha.entries()) pixels[4 * pixel + 3] = toHalf(value);
  for (let i = 0; i < radiance.length; i++) {
    const pixel = Math.floor(i / 3);
    pixels[4 * pixel + (i - 3 * pixel)] = toHalf(Math.min(radiance[i]!, LARGEST_HALF));
  }
  return pixels;
}

/**
 * Linear radiance; the header says how many samples a pixel has.
 *
 * @param noisy RGB
 * @param alpha by which colours are multiplied, before it was denoised; null where all is opaque
 * @param denoised then the noisy picture is in the layer 'noisy', as `render --denoise` writes it
 */
export function exrOf(
  { width, height }: Pick<Film, 'width' | 'height'>,
  noisy: Float32Array,
  denoised: { readonly radiance: Float32Array; readonly alpha: Float32Array } | null,
  attributes: Readonly<Record<string, string | number>>,
  alpha: Float32Array | null = null,
): Uint8Array {
  const layer = (prefix: string, radiance: Float32Array) =>
    ['R', 'G', 'B'].map((name, c) => ({
      name: prefix + name,
      type: 'float' as const,
      pixels: Float32Array.from({ length: width * height }, (_, pixel) => radiance[3 * pixel + c]!),
    }));
  const channels = [
    ...layer('', denoised?.radiance ?? noisy),
    ...(alpha ? [{ name: 'A', type: 'float' as const, pixels: denoised?.alpha ?? alpha }] : []),
    ...(denoised ? layer('noisy.', noisy) : []),
    ...(denoised && alpha ? [{ name: 'noisy.A', type: 'float' as const, pixels: alpha }] : []),
  ];
  return encodeExr({ width, height, channels, attributes });
}
