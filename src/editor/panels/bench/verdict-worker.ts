/** Holds one model to physics. To cancel it, end the worker. */
import { checkModel } from '../../../analysis/verdict/verdict.ts';
import { modelOf } from './series.ts';
import type { VerdictAnswer, VerdictJob } from './verdict-job.ts';

const answer = (message: VerdictAnswer) => self.postMessage(message);

self.addEventListener('message', async ({ data }: MessageEvent<VerdictJob>) => {
  try {
    const model = modelOf(data);
    if (!model) throw new Error(`there is no model ${data.model}`);
    const verdict = await checkModel(model, {
      onProgress: (done, property) => answer({ kind: 'progress', done, property }),
    });
    answer({ kind: 'verdict', verdict });
  } catch (error) {
    answer({ kind: 'error', message: error instanceof Error ? error.message : String(error) });
  }
});
