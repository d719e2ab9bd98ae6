/** Fits one model to a target. To cancel it, end the worker. */
import { fitModel } from '../../../analysis/fit/fit.ts';
import { spherePicture } from '../../../analysis/fit/sphere.ts';
import { resolveParameters } from '../../../brdf/values.ts';
import type { Model } from '../../../glsl/model.ts';
import { modelOf, type Subject } from '../bench/series.ts';
import { type FitAnswer, type FitJob, SPHERE_SIZE } from './job.ts';

const answer = (message: FitAnswer) => self.postMessage(message);

self.addEventListener('message', async ({ data }: MessageEvent<FitJob>) => {
  try {
    const [target, model] = [existing(data.target), existing(data.model)];
    const { parameters } = data.target;
    const fit = await fitModel({ model: target, parameters }, model, {
      onProgress: (done, error) => answer({ kind: 'progress', done, error }),
    });
    const wanted = await spherePicture(target, resolveParameters(target.file, parameters), SPHERE_SIZE);
    const found = await spherePicture(model, fit.parameters, SPHERE_SIZE);
    answer({ kind: 'fit', fit, spheres: [wanted, found] });
  } catch (error) {
    answer({ kind: 'error', message: error instanceof Error ? error.message : String(error) });
  }
});

function existing(subject: Pick<Subject, 'model' | 'source'>): Model {
  const model = modelOf(subject);
  if (!model) throw new Error(`there is no model ${subject.model}`);
  return model;
}
