/** Denoises films one after the other in a thread of its own. */
import type { DenoiseOptions } from '../../pathtracer/denoise/denoise.ts';
import type { Film } from '../../pathtracer/film.ts';

export interface DenoisedPicture {
  /** RGB. */
  readonly radiance: Float32Array;
  /** Null where it has no noise that could be taken out. */
  readonly alpha: Float32Array | null;
}

export type FromDenoiser =
  | { readonly kind: 'progress'; readonly part: number }
  | ({ readonly kind: 'done' } & DenoisedPicture)
  | { readonly kind: 'failed'; readonly message: string };

/** As `denoise` and `denoiseAlpha`, of the film as it is now: the thread gets a copy. */
export type Denoise = (film: Film, options: DenoiseOptions) => Promise<DenoisedPicture>;

export function createDenoiser(): Denoise {
  let idle: Worker | null = null;
  return (film, { signal, onProgress }) =>
    new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      const thread = idle ?? new Worker(new URL('./denoise-worker.ts', import.meta.url), { type: 'module' });
      idle = null;
      const stop = (reason: unknown) => {
        signal?.removeEventListener('abort', abort);
        thread.terminate();
        reject(reason);
      };
      const abort = () => stop(signal?.reason);
      signal?.addEventListener('abort', abort);
      thread.onmessage = ({ data }: MessageEvent<FromDenoiser>) => {
        if (data.kind === 'progress') onProgress?.(data.part);
        else if (data.kind === 'failed') stop(new Error(data.message));
        else {
          signal?.removeEventListener('abort', abort);
          idle = thread;
          resolve(data);
        }
      };
      thread.onerror = ({ message }) => stop(new Error(message || 'the denoiser could not be loaded'));
      thread.postMessage(film);
    });
}
