/** Frames beside what the path tracer makes of the same document. */
import type { Document } from '../../../src/scene/schema.ts';
import { trace } from '../../pathtracer/tracer.ts';
import type { Picture } from './frames.ts';

/** The mean over squares of pixels. */
export function reduced({ width, height, pixels }: Picture, factor: number): Picture {
  const small = { width: width / factor, height: height / factor };
  const sums = new Float32Array(small.width * small.height * 4);
  for (let i = 0; i < pixels.length; i++) {
    const [x, y] = [Math.floor(i / 4) % width, Math.floor(i / 4 / width)];
    const at = Math.floor(y / factor) * small.width + Math.floor(x / factor);
    sums[4 * at + (i % 4)]! += pixels[i]! / factor ** 2;
  }
  return { ...small, pixels: sums };
}

/** The path traced picture of a document. */
export async function traced(
  document: Document,
  { width, height }: { width: number; height: number },
  samples: number,
  maxDepth: number,
): Promise<Picture> {
  const film = await trace(document, { width, height, samples, maxDepth });
  const mean = film.mean();
  const pixels = Float32Array.from({ length: width * height * 4 }, (_, i) =>
    i % 4 === 3 ? 1 : mean[3 * (i >> 2) + (i % 4)]!,
  );
  return { width, height, pixels };
}

/** The mean distance of two pictures, as a part of the reference's mean: with its sign, and without. */
export function meanError(
  shown: Picture,
  reference: Picture,
  where: (x: number, y: number) => boolean = () => true,
): { bias: number; error: number } {
  let [bias, error, sum] = [0, 0, 0];
  for (let i = 0; i < shown.pixels.length; i++) {
    if (i % 4 === 3 || !where((i >> 2) % shown.width, Math.floor((i >> 2) / shown.width))) continue;
    const difference = shown.pixels[i]! - reference.pixels[i]!;
    bias += difference;
    error += Math.abs(difference);
    sum += reference.pixels[i]!;
  }
  return { bias: bias / sum, error: error / sum };
}

export const finite = ({ pixels }: Picture): boolean => pixels.every((x) => Number.isFinite(x) && x >= 0);

/** The mean of the colour values of some pixels. */
export function meanWithin({ width, pixels }: Picture, where: (x: number, y: number) => boolean): number {
  let [sum, count] = [0, 0];
  for (let i = 0; i < pixels.length; i++) {
    if (i % 4 === 3 || !where((i >> 2) % width, Math.floor((i >> 2) / width))) continue;
    sum += pixels[i]!;
    count++;
  }
  return sum / count;
}
