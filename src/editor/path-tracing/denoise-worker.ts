/** The denoiser's thread: it takes seconds, and is ended by ending the thread. */
import { denoise } from '../../pathtracer/denoise/denoise.ts';
import { denoiseAlpha } from '../../pathtracer/denoise/denoise-alpha.ts';
import { Film } from '../../pathtracer/film.ts';
import type { FromDenoiser } from './denoiser.ts';

const post = (message: FromDenoiser, transfer: Transferable[] = []) =>
  self.postMessage(message, { transfer });

self.addEventListener('message', async ({ data }: MessageEvent<Film>) => {
  // A message carries a film's sums, not its methods.
  const film = Object.assign(new Film(data.width, data.height), data);
  try {
    const radiance = await denoise(film, { onProgress: (part) => post({ kind: 'progress', part }) });
    const alpha = await denoiseAlpha(film);
    const transfer = [radiance, alpha].flatMap((values) => (values ? [values.buffer as ArrayBuffer] : []));
    post({ kind: 'done', radiance, alpha }, transfer);
  } catch (error) {
    post({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
});
