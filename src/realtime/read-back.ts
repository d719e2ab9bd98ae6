/** Targets of the GPU as arrays, the same from both back ends: WebGL's rows start at the bottom, these at the top. */
import type { RenderTarget, WebGPURenderer } from 'three/webgpu';
import { fromHalf } from '../io/half.ts';

export type Pixels = Float32Array | Uint16Array | Uint8Array;

export const isWebGPU = ({ backend }: WebGPURenderer): boolean => 'isWebGPUBackend' in backend;

export async function readTarget(three: WebGPURenderer, target: RenderTarget): Promise<Pixels> {
  const { width, height } = target;
  const pixels = (await three.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Pixels;
  if (!isWebGPU(three)) reverseRows(pixels, width * 4);
  return pixels;
}

/** One pixel. @param x @param y its place, from 0 at the left and the top to 1 */
export async function readTexel(
  three: WebGPURenderer,
  target: RenderTarget,
  x: number,
  y: number,
): Promise<[number, number, number, number]> {
  const { width, height } = target;
  const at = (part: number, length: number) => Math.min(length - 1, Math.max(0, Math.floor(part * length)));
  const [column, row] = [at(x, width), at(y, height)];
  const fromTop = isWebGPU(three) ? row : height - 1 - row;
  const pixels = (await three.readRenderTargetPixelsAsync(target, column, fromTop, 1, 1)) as Pixels;
  const [r = 0, g = 0, b = 0, a = 0] = numbersOf(pixels);
  return [r, g, b, a];
}

/** Half floats as floats. */
export const numbersOf = (pixels: Pixels): Pixels =>
  pixels instanceof Uint16Array ? Float32Array.from(pixels, fromHalf) : pixels;

/** Takes the alpha out of colours that it is multiplied into. */
export function divideByAlpha(pixels: Uint8Array): void {
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3]!;
    if (alpha > 0 && alpha < 255)
      for (let c = 0; c < 3; c++) pixels[i + c] = Math.min(255, Math.round((255 * pixels[i + c]!) / alpha));
  }
}

function reverseRows(pixels: Pixels, length: number): void {
  for (let top = 0, bottom = pixels.length - length; top < bottom; top += length, bottom -= length) {
    const row = pixels.slice(top, top + length);
    pixels.copyWithin(top, bottom, bottom + length);
    pixels.set(row, bottom);
  }
}
