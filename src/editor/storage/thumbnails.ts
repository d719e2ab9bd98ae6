/** Small pictures of the view for the list of documents. They are drawn when the hand rests. */
import { h } from '../ui/dom.ts';
import type { KeptDocument, KeptDocuments } from './kept-documents.ts';

/** In pixels: sharp at twice the size it has in the list. */
const WIDTH = 400;
const HEIGHT = 250;
/** After the last edit. */
const REST_MS = 20_000;

export class Thumbnails {
  readonly #picture: () => Promise<Blob> | null;
  #timer: number | undefined;
  #stale = false;

  constructor(picture: () => Promise<Blob> | null) {
    this.#picture = picture;
  }

  later(storage: KeptDocuments | null, kept: KeptDocument | null): void {
    this.#stale = true;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => void this.take(storage, kept), REST_MS);
  }

  /** A document without a picture is no reason to bother the person. */
  async take(storage: KeptDocuments | null, kept: KeptDocument | null): Promise<void> {
    clearTimeout(this.#timer);
    if (!this.#stale || !storage || !kept) return;
    try {
      const picture = await this.#picture();
      if (!picture) return;
      this.#stale = false;
      await storage.setThumbnail(kept.id, await shrunk(picture));
    } catch {
      this.#stale = true;
    }
  }
}

/** The middle of the picture, cut to the list's shape. */
async function shrunk(picture: Blob): Promise<Blob> {
  const image = await createImageBitmap(picture);
  const scale = Math.max(WIDTH / image.width, HEIGHT / image.height);
  const [width, height] = [WIDTH / scale, HEIGHT / scale];
  const [x, y] = [(image.width - width) / 2, (image.height - height) / 2];
  const canvas = h('canvas', { width: WIDTH, height: HEIGHT });
  const context = canvas.getContext('2d');
  if (context) context.imageSmoothingQuality = 'high';
  context?.drawImage(image, x, y, width, height, 0, 0, WIDTH, HEIGHT);
  image.close();
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no image'))), 'image/webp', 0.8);
  });
}
