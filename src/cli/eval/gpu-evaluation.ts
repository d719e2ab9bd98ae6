import type { GpuEvaluation } from '../../analysis/verdict/types.ts';
import type { Model } from '../../glsl/model.ts';
import type { Backend } from './query.ts';

/** How src/analysis asks for a model's terms on the GPU, or the software one. */
export async function gpuEvaluation(model: Model): Promise<GpuEvaluation> {
  const { createNodeRenderer } = await import('../node-renderer.ts');
  const { gpuBackend } = await import('./gpu.ts');
  const renderer = await createNodeRenderer({ width: 1, height: 1 });
  const backends = new Map<string, Backend>();
  return (term, points) => {
    const backend = backends.get(term) ?? gpuBackend(model, term, renderer);
    backends.set(term, backend);
    return backend(points);
  };
}
