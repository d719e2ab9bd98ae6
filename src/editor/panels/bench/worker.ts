/** Computes what takes longer than a frame, in steps, so that a newer wish is heard between two of them. */
import { albedoAngles, albedoCurve } from '../../../analysis/plots/albedo-curve.ts';
import { imageSlice } from '../../../analysis/plots/image-slice.ts';
import type { Answer, Job, Result } from './jobs.ts';
import { evaluatorOf } from './series.ts';

const FINAL_IMAGE = 128;
/** With fewer points a curve says nothing; with these it follows a slider, if coarsely. */
const FEWEST_POINTS = 5;

const running = new Map<string, { job: Job; steps: Generator<Result> }>();
let busy = false;

self.addEventListener('message', ({ data }: MessageEvent<Job>) => {
  running.set(data.key, { job: data, steps: stepsOf(data) });
  if (!busy) void work();
});

async function work(): Promise<void> {
  busy = true;
  while (running.size > 0) {
    // In turn: every curve grows, not one after the other.
    for (const [key, { job, steps }] of [...running]) {
      if (running.get(key)?.job !== job) continue;
      const result = step(steps);
      if (!result || result.error) running.delete(key);
      if (result) self.postMessage({ key, ticket: job.ticket, result } satisfies Answer);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  busy = false;
}

function step(steps: Generator<Result>): Result | null {
  try {
    const { value, done } = steps.next();
    return done ? null : value;
  } catch (error) {
    return {
      curve: [],
      image: null,
      progress: 1,
      error: error instanceof Error ? error.message : String(error),
    };
  }
}

function* stepsOf({ subject, term, task }: Job): Generator<Result> {
  const evaluator = evaluatorOf(subject);
  const f: Parameters<typeof albedoCurve>[0] = (l, v) => evaluator.f(l, v, undefined, term);
  if (task.kind === 'albedo') {
    for (const curve of albedoCurve(f, task.phiV)) {
      if (curve.length < FEWEST_POINTS) continue;
      yield { curve, image: null, progress: curve.length / albedoAngles.length, error: null };
    }
  } else {
    for (const image of imageSlice(f, { phiD: 90, cosine: task.cosine })) {
      yield { curve: [], image, progress: image.size / FINAL_IMAGE, error: null };
    }
  }
}
