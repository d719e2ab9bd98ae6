/** A rendering in passes: as many samples as were asked for, and what there is when it ends before. */
import type { Film } from '../../pathtracer/film.ts';
import type { PathTracer } from '../../pathtracer/path-tracer.ts';

/** When a rendering ends. */
export type Until =
  | { readonly kind: 'samples'; readonly count: number }
  | { readonly kind: 'time'; readonly seconds: number }
  | { readonly kind: 'error'; readonly error: number };

export interface PassesOptions {
  /** Number of the first sample. */
  readonly first: number;
  readonly until: Until;
  readonly pixels: number;
  /** Paths of a pass at most, if that is one sample of each pixel or more. */
  readonly pathsPerPass: number;
  readonly signal: AbortSignal;
  /** Rejects when the machine is lost. */
  readonly lost?: Promise<never>;
  onProgress?(state: PassesState): void;
}

export interface PassesState {
  /** Samples of each pixel so far; a fraction while a pass is under way. */
  readonly samples: number;
  readonly seconds: number;
  /** 0 to 1. */
  readonly part: number;
  /** Film.relativeError() as it was last looked at; infinite at first. */
  readonly error: number;
}

export interface PassesResult extends PassesState {
  /** Null if not one pass was completed. */
  readonly film: Film | null;
  /** Why it ended before its time: the signal, or what the path tracer threw. */
  readonly stopped: 'signal' | Error | null;
}

/** An estimate of the error from fewer samples is not to be trusted: what is rare has not been met yet. */
const LEAST_SAMPLES_FOR_ERROR = 16;
/** More than so many samples of a pixel are not summed in float32. */
const MOST_SAMPLES_PER_PASS = 256;
/**
 * The film is looked at when there are so many times the samples of the last look: reading it takes a GPU's time.
 * It is kept, so that what a lost device had finished is not lost with it.
 */
const LOOK_FACTOR = { error: 1.25, otherwise: 2 } as const;
/** A look comes after so many paths at the latest: some seconds of a fast GPU. */
const MOST_PATHS_UNSEEN = 2 ** 29;

export async function renderPasses(tracer: PathTracer, options: PassesOptions): Promise<PassesResult> {
  const { first, until, pixels, signal, lost = NEVER, onProgress } = options;
  const start = performance.now();
  const elapsed = () => (performance.now() - start) / 1000;
  const look = () => Promise.race([tracer.film(), lost]);
  const factor = until.kind === 'error' ? LOOK_FACTOR.error : LOOK_FACTOR.otherwise;
  let done = 0;
  let seen = 0;
  let kept: Film | null = null;
  let error = Number.POSITIVE_INFINITY;
  let stopped: PassesResult['stopped'] = null;
  const state = (samples: number): PassesState => {
    const seconds = elapsed();
    return { samples, seconds, part: partOf(until, samples, seconds, error), error };
  };

  for (let count = 1; count > 0; count = nextCount(options, done, elapsed(), error)) {
    try {
      const pass = tracer.render(first + done, count, {
        signal,
        onProgress: (part) => onProgress?.(state(done + part * count)),
      });
      await Promise.race([pass, lost]);
      done += count;
      if (done >= factor * seen || (done - seen) * pixels >= MOST_PATHS_UNSEEN) {
        kept = await look();
        seen = done;
        error = kept.relativeError();
      }
    } catch (thrown) {
      stopped = signal.aborted ? 'signal' : thrown instanceof Error ? thrown : new Error(String(thrown));
      break;
    }
    onProgress?.(state(done));
  }
  const film = done === 0 ? null : await look().catch(() => kept);
  const samples = film?.count[0] ?? 0;
  if (film) error = film.relativeError();
  return { ...state(samples), film, stopped };
}

const NEVER = new Promise<never>(() => {});

/**
 * Samples of the next pass, 0 at the end: 1, 1, 2, 4, ..., which are the sets that the sampler spreads evenly, up to
 * the largest. They depend on nothing that differs from run to run, since float sums depend on where they are cut;
 * only --time does, as it must.
 */
function nextCount(
  { until, pixels, pathsPerPass }: PassesOptions,
  done: number,
  seconds: number,
  error: number,
): number {
  const most = Math.min(MOST_SAMPLES_PER_PASS, 2 ** Math.floor(Math.log2(pathsPerPass / pixels)));
  const count = Math.max(1, Math.min(done, most));
  if (until.kind === 'samples') return Math.min(count, until.count - done);
  if (until.kind === 'error') return done >= LEAST_SAMPLES_FOR_ERROR && error <= until.error ? 0 : count;
  const fit = Math.floor((done / seconds) * (until.seconds - seconds));
  return Math.max(0, Math.min(count, fit));
}

function partOf(until: Until, samples: number, seconds: number, error: number): number {
  if (until.kind === 'samples') return samples / until.count;
  if (until.kind === 'time') return Math.min(1, seconds / until.seconds);
  // The error falls with the square root of the number of samples.
  return Math.min(1, (until.error / error) ** 2);
}
