/** Small pictures of the view for the list of documents. They are drawn when the hand rests. */
import { thumbnailFile } from './document-work.ts';
import type { KeptDocument, KeptDocuments } from './kept-documents.ts';

/** In pixels: sharp at twice the size it has in the list. */
const SIZE = { width: 400, height: 250 } as const;
/** After the last edit. */
const REST_MS = 20_000;

/** The middle of the view, in a size; null while there is none. */
export type TakePicture = (width: number, height: number) => Promise<ImageBitmap> | null;

export class Thumbnails {
  readonly #picture: TakePicture;
  #timer: number | undefined;
  #stale = false;

  constructor(picture: TakePicture) {
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
      const picture = await this.#picture(SIZE.width, SIZE.height);
      if (!picture) return;
      this.#stale = false;
      await storage.setThumbnail(kept.id, await thumbnailFile(picture));
    } catch {
      this.#stale = true;
    }
  }
}
