/** Makes small pictures of materials, off the page's thread. */
import { thumbnail } from '../../../analysis/library/thumbnail.ts';
import { modelOf } from '../bench/series.ts';
import type { ThumbnailAnswer, ThumbnailRequest } from './thumbnail-job.ts';

self.addEventListener('message', ({ data }: MessageEvent<ThumbnailRequest>) => {
  const { job, size } = data;
  let answer: ThumbnailAnswer;
  try {
    const model = modelOf(job);
    if (!model) throw new Error(`there is no model ${job.model}`);
    answer = { pixels: thumbnail({ ...job, model }, size) };
  } catch (error) {
    answer = { message: error instanceof Error ? error.message : String(error) };
  }
  self.postMessage(answer, { transfer: 'pixels' in answer ? [answer.pixels.buffer] : [] });
});
