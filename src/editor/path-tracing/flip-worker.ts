/** Compares two pictures in a thread of its own: it takes a good part of a second. */
import { flip, type ScreenImage } from '../../analysis/flip/flip.ts';
import { magma } from '../../analysis/flip/magma.ts';

export interface FlipPicture {
  readonly width: number;
  readonly height: number;
  /** RGBA, sRGB. */
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  readonly mean: number;
}

self.addEventListener('message', ({ data }: MessageEvent<{ reference: ScreenImage; test: ScreenImage }>) => {
  const { width, height, values, mean } = flip(data.reference, data.test);
  const pixels = new Uint8ClampedArray(4 * values.length).fill(255);
  const colors = Array.from({ length: 256 }, (_, i) => magma(i / 255));
  for (const [i, value] of values.entries()) pixels.set(colors[Math.round(255 * value)]!, 4 * i);
  const picture: FlipPicture = { width, height, pixels, mean };
  self.postMessage(picture, { transfer: [pixels.buffer] });
});
