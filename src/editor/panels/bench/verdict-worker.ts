/** Holds one model to physics. To cancel it, end the worker. */
import { GpuFailure } from '../../../analysis/verdict/gpu-agreement.ts';
import { checkModel, type GpuEvaluation } from '../../../analysis/verdict/verdict.ts';
import { modelOf } from './series.ts';
import type { GpuReply, VerdictAnswer, VerdictJob, VerdictRequest } from './verdict-job.ts';

const answer = (message: VerdictAnswer) => self.postMessage(message);

self.addEventListener('message', ({ data }: MessageEvent<VerdictRequest>) => {
  if ('model' in data) void check(data);
});

async function check(job: VerdictJob): Promise<void> {
  try {
    const model = modelOf(job);
    if (!model) throw new Error(`there is no model ${job.model}`);
    const verdict = await checkModel(model, {
      onProgress: (done, property) => answer({ kind: 'progress', done, property }),
      gpu: askPage,
    });
    answer({ kind: 'verdict', verdict });
  } catch (error) {
    answer({ kind: 'error', message: error instanceof Error ? error.message : String(error) });
  }
}

const askPage: GpuEvaluation = (term, points) =>
  new Promise((resolve, reject) => {
    const listen = ({ data }: MessageEvent<VerdictRequest>) => {
      if ('model' in data) return;
      self.removeEventListener('message', listen);
      take(data);
    };
    const take = (reply: GpuReply) => {
      if ('values' in reply) resolve(reply.values);
      else reject(new GpuFailure(reply.failure));
    };
    self.addEventListener('message', listen);
    answer({ kind: 'gpu', term, points });
  });
