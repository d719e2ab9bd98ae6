/** Computes what takes longer than a frame, in steps, so that a newer wish is heard between two of them. */
import { albedoAngles, albedoCurve } from '../../../analysis/plots/albedo-curve.ts';
import { albedoSweep, SWEEP_POINTS } from '../../../analysis/plots/albedo-sweep.ts';
import { azimuthMapAt } from '../../../analysis/plots/azimuth-slice.ts';
import { imageSliceAt } from '../../../analysis/plots/image-slice.ts';
import { litPictures } from '../../../analysis/plots/lit-picture.ts';
import { lobe } from '../../../analysis/plots/lobe.ts';
import { type Picture, pictures } from '../../../analysis/plots/picture.ts';
import { meshSurface, sphereSurface, type TriangleMesh } from '../../../analysis/plots/surface.ts';
import { createQuickEvaluator } from '../../../analysis/quick-evaluator.ts';
import type { Answer, Job, Result, Shape, Source } from './jobs.ts';
import { modelOf } from './series.ts';
import type { OwnModel } from './settings.ts';

/** null is a pause; REST is a longer one, after which the job goes on if no other has come in its place. */
type Steps = Generator<Result | null | typeof REST>;
const REST = Symbol('rest');
/** Longer than from one frame to the next, slow ones, too: what is drawn while a slider moves has to be drawn fast. */
const REST_MS = 250;

const SIZES = [16, 32, 64, 128];
/** With fewer points a curve says nothing; with these it follows a slider, if coarsely. */
const FEWEST_POINTS = 5;
/** Between two looks at what has been asked for meanwhile. */
const SLICE_MS = 6;

interface Running {
  readonly job: Job;
  readonly steps: Steps;
}

const running = new Map<string, Running>();
/** Those that rest, by their timers. */
const resting = new Map<string, ReturnType<typeof setTimeout>>();
/** Only the shape that was sent last is asked for. */
let shape: Shape | null = null;
const sources = new Map<number, OwnModel>();
let busy = false;

self.addEventListener('message', ({ data }: MessageEvent<Job | Shape | Source>) => {
  if ('triangles' in data) shape = data;
  else if ('own' in data) {
    if (data.own) sources.set(data.source, data.own);
    else sources.delete(data.source);
  } else {
    const own = data.source === null ? null : sources.get(data.source);
    begin(data.key, { job: data, steps: stepsOf(data, own) });
  }
});

function begin(key: string, job: Running): void {
  clearTimeout(resting.get(key));
  resting.delete(key);
  running.set(key, job);
  if (!busy) void work();
}

async function work(): Promise<void> {
  busy = true;
  while (running.size > 0) {
    // In turn: every curve grows, not one after the other.
    for (const [key, { job, steps }] of [...running]) {
      if (running.get(key)?.job !== job) continue;
      const result = advance(steps);
      if (result === REST) {
        running.delete(key);
        resting.set(key, setTimeout(begin, REST_MS, key, { job, steps }));
        continue;
      }
      if (result === 'end' || (result && result.error !== undefined)) running.delete(key);
      if (result && result !== 'end') self.postMessage({ key, ticket: job.ticket, result } satisfies Answer);
      await nextTask();
    }
  }
  busy = false;
}

/** Messages are heard, without the 4 ms that a timer within a timer waits. */
const channel = new MessageChannel();
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });
}

function advance(steps: Steps): Result | null | typeof REST | 'end' {
  const until = performance.now() + SLICE_MS;
  try {
    do {
      const { value, done } = steps.next();
      if (done) return 'end';
      if (value) return value;
    } while (performance.now() < until);
    return null;
  } catch (error) {
    return { progress: 1, error: error instanceof Error ? error.message : String(error) };
  }
}

function* stepsOf({ model: name, parameters, term, task }: Job, source: OwnModel | null | undefined): Steps {
  const model = source === undefined ? undefined : modelOf({ model: name, source });
  if (!model) throw new Error(`there is no model ${name}`);
  const evaluator = createQuickEvaluator(model, parameters);
  const f = evaluator.term(term);
  switch (task.kind) {
    case 'albedo':
      for (const curve of albedoCurve(f, task.phiV)) {
        if (curve.length >= FEWEST_POINTS) yield { curve, progress: curve.length / albedoAngles.length };
      }
      break;
    case 'sweep': {
      const at = (value: number) => {
        evaluator.set({ ...parameters, [task.parameter]: value });
        return f;
      };
      for (const sweep of albedoSweep(at, task)) {
        if (!sweep) yield null;
        else if (sweep.length >= FEWEST_POINTS) yield { sweep, progress: sweep.length / SWEEP_POINTS };
      }
      break;
    }
    case 'lobe': {
      let progress = 0;
      for (const part of lobe(f, task.options)) {
        if (part) progress += 0.5;
        yield part && { lobe: part, progress };
        // The fine one has four times as many facets to draw.
        if (part && progress < 1) yield REST;
      }
      break;
    }
    case 'image':
      yield* growing(pictures(SIZES, (x, y) => imageSliceAt(f, x, y, task.options)));
      break;
    case 'map':
      yield* growing(pictures(SIZES, (x, y) => azimuthMapAt(f, x, y, task.options)));
      break;
    case 'sphere':
      yield* growing(litPictures(f, sphereSurface, task.options));
      break;
    case 'object': {
      const triangles = trianglesOf(task.mesh);
      yield* growing(litPictures(f, (eye, size) => meshSurface(triangles, eye, size), task.options));
      break;
    }
  }
}

/** A picture is shown when it is there; the last one, which a generator has to end after, is the whole. */
function* growing(steps: Generator<Picture | null>): Steps {
  let last: Picture | null = null;
  for (const picture of steps) {
    yield picture && { picture, progress: 0.5 };
    last = picture ?? last;
  }
  if (last) yield { picture: last, progress: 1 };
}

function trianglesOf(mesh: number): TriangleMesh {
  if (shape?.mesh !== mesh) throw new Error('the shape was not sent');
  return shape.triangles;
}
