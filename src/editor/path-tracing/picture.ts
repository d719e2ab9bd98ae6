/** A film as the page shows it and as a file keeps it. */

import { encodeExr } from '../../io/exr.ts';
import { toHalf } from '../../io/half.ts';
import type { Film } from '../../pathtracer/film.ts';
import type { TracedPicture } from './messages.ts';

const LARGEST_HALF = 65_504;
const ONE = toHalf(1);

export function tracedPicture({ width, height, count, radiance }: Film): TracedPicture {
  const pixels = new Uint16Array(4 * width * height);
  for (let pixel = 0; pixel < count.length; pixel++) {
    const scale = 1 / Math.max(1, count[pixel]!);
    for (let c = 0; c < 3; c++) {
      const mean = radiance[3 * pixel + c]! * scale;
      pixels[4 * pixel + c] = toHalf(Math.min(mean, LARGEST_HALF));
    }
    pixels[4 * pixel + 3] = ONE;
  }
  return { width, height, pixels };
}

/** Linear radiance; the header says how many samples a pixel has. */
export function exrOf(film: Film, attributes: Readonly<Record<string, string | number>>): Uint8Array {
  const { width, height } = film;
  const mean = film.mean();
  const channels = ['R', 'G', 'B'].map((name, c) => ({
    name,
    type: 'float' as const,
    pixels: Float32Array.from({ length: width * height }, (_, pixel) => mean[3 * pixel + c]!),
  }));
  return encodeExr({ width, height, channels, attributes });
}
