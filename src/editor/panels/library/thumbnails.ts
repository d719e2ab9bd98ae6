/** Small pictures of materials: asked for by whoever shows them, made one after the other in a worker, kept. */
import { KeptMaterials } from '../../storage/material-library.ts';
import { h } from '../../ui/dom.ts';
import { keyOf, type ThumbnailAnswer, type ThumbnailJob, type ThumbnailRequest } from './thumbnail-job.ts';

type Pixels = Uint8ClampedArray<ArrayBuffer>;

interface Waiting {
  readonly key: string;
  readonly request: ThumbnailRequest;
  readonly keep: boolean;
  readonly resolve: (pixels: Pixels | null) => void;
}

/** Those of a scene that is edited: each value of a slider is another picture. */
const MOST_REMEMBERED = 400;

export class Thumbnails {
  #worker: Worker | null = null;
  #storage: Promise<KeptMaterials | null> | null = null;
  readonly #remembered = new Map<string, Promise<Pixels | null>>();
  readonly #waiting: Waiting[] = [];
  #current: Waiting | null = null;
  #done = 0;
  /** Called when one more is made; `left` are still to be made. */
  onProgress: ((done: number, left: number) => void) | null = null;

  /** What the browser keeps; null where it keeps nothing. */
  storage(): Promise<KeptMaterials | null> {
    this.#storage ??= KeptMaterials.open().catch(() => null);
    return this.#storage;
  }

  /**
   * RGBA of a square; null where the material has no picture.
   *
   * @param keep in the browser, for other sessions
   */
  picture(job: ThumbnailJob, size: number, keep = false): Promise<Pixels | null> {
    const key = keyOf(job, size);
    if (key === null) return Promise.resolve(null);
    const known = this.#remembered.get(key);
    if (known) return known;
    const made = this.#find(key, keep).then((kept) => kept ?? this.#make(key, { job, size }, keep));
    this.#remembered.set(key, made);
    for (const old of this.#remembered.keys()) {
      if (this.#remembered.size <= MOST_REMEMBERED) break;
      this.#remembered.delete(old);
    }
    return made;
  }

  /** Those of these keys that are not made yet come next: somebody looks at where they will be. */
  hasten(keys: ReadonlySet<string>): void {
    const all = this.#waiting.splice(0);
    const isNear = ({ key }: Waiting) => keys.has(key);
    this.#waiting.push(...all.filter(isNear), ...all.filter((waiting) => !isNear(waiting)));
  }

  async #find(key: string, keep: boolean): Promise<Pixels | null> {
    if (!keep) return null;
    try {
      return (await (await this.storage())?.picture(key)) ?? null;
    } catch {
      return null;
    }
  }

  #make(key: string, request: ThumbnailRequest, keep: boolean): Promise<Pixels | null> {
    return new Promise((resolve) => {
      const waiting = { key, request, keep, resolve };
      // What changes now is looked at now; the library has time.
      if (keep) this.#waiting.push(waiting);
      else this.#waiting.unshift(waiting);
      this.#next();
    });
  }

  #next(): void {
    if (this.#current) return;
    this.#current = this.#waiting.shift() ?? null;
    if (this.#current) this.#running().postMessage(this.#current.request);
  }

  #running(): Worker {
    if (this.#worker) return this.#worker;
    const worker = new Worker(new URL('./thumbnail-worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<ThumbnailAnswer>) =>
      this.#finish('pixels' in data ? data.pixels : null),
    );
    worker.addEventListener('error', () => {
      worker.terminate();
      this.#worker = null;
      this.#finish(null);
    });
    this.#worker = worker;
    return worker;
  }

  #finish(pixels: Pixels | null): void {
    const current = this.#current;
    this.#current = null;
    if (!current) return;
    if (pixels && current.keep)
      void this.storage()
        .then((storage) => storage?.setPicture(current.key, pixels))
        .catch(() => {
          // Storage may be full: it is made anew in the next session.
        });
    this.#done += 1;
    current.resolve(pixels);
    this.onProgress?.(this.#done, this.#waiting.length);
    this.#next();
  }
}

/** A canvas that shows a material's picture when it has come. */
export function thumbnailCanvas(size: number): HTMLCanvasElement {
  return h('canvas', { class: 'material-picture', width: size, height: size, 'aria-hidden': 'true' });
}

export function drawThumbnail(canvas: HTMLCanvasElement, pixels: Pixels | null): void {
  const { width, height } = canvas;
  const context = canvas.getContext('2d');
  if (pixels) context?.putImageData(new ImageData(pixels, width, height), 0, 0);
  else context?.clearRect(0, 0, width, height);
  canvas.classList.toggle('made', pixels !== null);
}
