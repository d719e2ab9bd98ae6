/** The viewport's renderings as pictures: to be saved, and to be compared. */
import type { RealtimeRenderer } from '../../realtime/renderer.ts';
import type { ImagePair } from '../path-tracing/difference.ts';
import type { PathTracing } from '../path-tracing/path-tracing.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';

interface Shown {
  readonly renderer: RealtimeRenderer;
  readonly session: Session;
}

/** The path traced picture, whatever part of it is shown. */
export async function tracedPng({ renderer, session }: Shown, { texture }: PathTracing): Promise<Blob> {
  if (texture === null) throw new Error('There is no path traced picture yet.');
  const { width, height } = renderer.canvas;
  const pixels = await renderer.readImage(session.store.document.view, { radiance: texture, from: 0 });
  const canvas = h('canvas', { width, height });
  canvas.getContext('2d')?.putImageData(new ImageData(Uint8ClampedArray.from(pixels), width, height), 0, 0);
  return pngOf(canvas);
}

/** The last frame and the path traced picture as the screen would show them; null while there is no such picture. */
export async function readPair(
  { renderer, session }: Shown,
  { texture }: PathTracing,
): Promise<ImagePair | null> {
  const { view } = session.store.document;
  if (texture === null) return null;
  const { width, height } = renderer.canvas;
  const [interactive, traced] = await Promise.all([
    renderer.readImage(view, null),
    renderer.readImage(view, { radiance: texture, from: 0 }),
  ]);
  return { width, height, interactive, traced };
}

export function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('The canvas gave no image.'))),
      'image/png',
    );
  });
}

/** The last frame as the screen shows it. */
export async function shownPixels({ renderer, session }: Shown): Promise<ImageData> {
  const { width, height } = renderer.canvas;
  const pixels = await renderer.readImage(session.store.document.view);
  return new ImageData(Uint8ClampedArray.from(pixels), width, height);
}

/** As much of a picture as has the shape of this size, in this size. */
export function middleOf(
  picture: HTMLCanvasElement | ImageData,
  width: number,
  height: number,
): Promise<ImageBitmap> {
  const scale = Math.max(width / picture.width, height / picture.height);
  const [partWidth, partHeight] = [width / scale, height / scale];
  const [x, y] = [(picture.width - partWidth) / 2, (picture.height - partHeight) / 2];
  return createImageBitmap(picture, x, y, partWidth, partHeight, {
    resizeWidth: width,
    resizeHeight: height,
    resizeQuality: 'high',
  });
}
