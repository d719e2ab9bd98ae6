import type { Model } from '../../glsl/model.ts';
import { GpuEvaluation } from '../../realtime/gpu-evaluation.ts';
import { createNodeRenderer } from '../node-renderer.ts';
import type { Backend } from './query.ts';

/** A model's terms on the GPU, or the software one. */
export async function gpuBackend(model: Model): Promise<(term: string) => Backend> {
  const { renderer } = await createNodeRenderer({ width: 1, height: 1 });
  const evaluations = new Map<string, GpuEvaluation>();
  return (term) => {
    const evaluation = evaluations.get(term) ?? new GpuEvaluation(renderer, model, term);
    evaluations.set(term, evaluation);
    return (queries) => evaluation.evaluate(queries);
  };
}
