/** The thread that puts a picture together of its parts and makes a file of it. */
import { displayPixels } from '../../../color/tone-mapping.ts';
import { encodeExr } from '../../../io/exr.ts';
import { fromHalf } from '../../../io/half.ts';
import { encodePng } from '../../../io/png.ts';
import type { FromPicture, PictureFormat, ToPicture } from './picture-messages.ts';

const JPEG_QUALITY = 0.92;
const LARGEST_HALF = 65_504;

const post = (message: FromPicture) => self.postMessage(message);
let width = 0;
let height = 0;
let format: PictureFormat = 'png';
let transparent = false;
/** RGBA. */
let screen: Uint8ClampedArray<ArrayBufferLike> = new Uint8ClampedArray(0);
/** Red, green, blue, and alpha where there is one. */
let planes: Float32Array[] = [];

self.addEventListener('message', async ({ data }: MessageEvent<ToPicture>) => {
  try {
    if (data.kind === 'begin') begin(data);
    else if (data.kind === 'tile') addTile(data);
    else if (data.kind === 'radiance') addRadiance(data);
    else post({ kind: 'file', file: await file() });
  } catch (error) {
    post({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
});

function begin(message: Extract<ToPicture, { kind: 'begin' }>): void {
  ({ width, height, format, transparent } = message);
  if (format === 'exr')
    planes = Array.from({ length: transparent ? 4 : 3 }, () => new Float32Array(width * height));
  else screen = new Uint8ClampedArray(4 * width * height);
}

function addTile({ tile, pixels }: Extract<ToPicture, { kind: 'tile' }>): void {
  for (let y = 0; y < tile.height; y++) {
    const from = 4 * tile.width * y;
    const to = (tile.y + y) * width + tile.x;
    if (format !== 'exr') screen.set(pixels.subarray(from, from + 4 * tile.width), 4 * to);
    else
      for (let x = 0; x < tile.width; x++)
        for (const [c, plane] of planes.entries()) plane[to + x] = pixels[from + 4 * x + c]!;
  }
}

function addRadiance({ pixels, display }: Extract<ToPicture, { kind: 'radiance' }>): void {
  const rgb = new Float32Array((3 * pixels.length) / 4);
  for (let i = 0; i < pixels.length / 4; i++)
    for (let c = 0; c < 3; c++) rgb[3 * i + c] = fromHalf(pixels[4 * i + c]!);
  const alpha = Float32Array.from({ length: pixels.length / 4 }, (_, i) => fromHalf(pixels[4 * i + 3]!));
  screen = displayPixels(rgb, display, transparent ? alpha : undefined);
}

async function file(): Promise<Blob> {
  if (format === 'exr') {
    const channels = planes.map((plane, c) => ({
      name: 'RGBA'[c] as string,
      type: 'half' as const,
      pixels: plane.map((value) => Math.min(value, LARGEST_HALF)),
    }));
    return new Blob([new Uint8Array(encodeExr({ width, height, channels }))], { type: 'image/x-exr' });
  }
  if (transparent && format === 'jpg') layOverBlack(screen);
  // Not a copy: at 8K that would be 130 MB.
  const image = new ImageData(screen as Uint8ClampedArray<ArrayBuffer>, width, height);
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', { alpha: transparent && format === 'png' });
  if (context === null) {
    // A canvas so large is beyond some browsers; PNG needs none.
    if (format === 'jpg')
      throw new Error(`This browser makes no JPEG of ${width} x ${height} pixels; PNG works.`);
    return new Blob([new Uint8Array(encodePng(screen, width, height))], { type: 'image/png' });
  }
  context.putImageData(image, 0, 0);
  return format === 'png'
    ? canvas.convertToBlob({ type: 'image/png' })
    : canvas.convertToBlob({ type: 'image/jpeg', quality: JPEG_QUALITY });
}

/** For formats without alpha. */
function layOverBlack(pixels: Uint8ClampedArray): void {
  for (let i = 0; i < pixels.length; i += 4) {
    for (let c = 0; c < 3; c++) pixels[i + c] = (pixels[i + c]! * pixels[i + 3]!) / 255;
    pixels[i + 3] = 255;
  }
}
