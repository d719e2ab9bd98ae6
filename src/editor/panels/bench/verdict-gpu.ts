/** The GPU's part of the verdict, on the page: its worker has no GPU. */
import type { Point } from '../../../analysis/verdict/types.ts';
import type { Rgb } from '../../../brdf/model.ts';
import type { Model } from '../../../glsl/model.ts';
import { GpuEvaluation } from '../../../realtime/gpu-evaluation.ts';
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import { modelOf } from './series.ts';
import type { GpuReply, VerdictJob } from './verdict-job.ts';

/** Between two frames of the picture: so many take a few milliseconds to pack, and less than a frame to draw. */
const POINTS_AT_ONCE = 256;

/** Answers one question after the other. */
export async function askGpu(
  renderer: RealtimeRenderer | null,
  job: VerdictJob,
  term: string,
  points: readonly Point[],
): Promise<GpuReply> {
  if (!renderer) return { failure: 'There is no GPU that could be asked.' };
  try {
    const model = modelOf(job);
    if (!model) throw new Error(`there is no model ${job.model}`);
    return { values: await valuesOf(renderer, model, term, points) };
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    return { failure: `The GPU gave no answer: ${message}` };
  }
}

async function valuesOf(
  { three }: RealtimeRenderer,
  model: Model,
  term: string,
  points: readonly Point[],
): Promise<Rgb[]> {
  const evaluation = new GpuEvaluation(three, model, term);
  try {
    const values: Rgb[] = [];
    for (let at = 0; at < points.length; at += POINTS_AT_ONCE)
      values.push(...(await evaluation.evaluate(points.slice(at, at + POINTS_AT_ONCE))));
    return values;
  } finally {
    evaluation.dispose();
  }
}
