/** A rendering in passes: as many samples as were asked for, and what there is when it ends before. */
import { BASE_SAMPLES, openTiles, tileErrors } from '../../pathtracer/adaptive.ts';
import type { Film } from '../../pathtracer/film.ts';
import type { PathTracer, TileMask } from '../../pathtracer/path-tracer.ts';
import { maskedPixels } from '../../pathtracer/tiles.ts';

/** When a rendering ends. */
export type Until =
  | { readonly kind: 'samples'; readonly count: number }
  | { readonly kind: 'time'; readonly seconds: number }
  /** Of every tile, or when a pixel has so many samples. */
  | { readonly kind: 'error'; readonly error: number; readonly most: number };

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
  /** Samples of each pixel so far, on average; a fraction while a pass is under way. */
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
  /** How many numbers of samples the film has some of: as many as any pixel has, or more. */
  readonly numbers: number;
  /** Why it ended before its time: the signal, or what the path tracer threw. */
  readonly stopped: 'signal' | Error | null;
}

/** More than so many samples of a pixel are not summed in float32. */
const MOST_SAMPLES_PER_PASS = 256;
/**
 * The film is looked at when there are so many times the samples of the last look: reading it takes a GPU's time.
 * It is kept, so that what a lost device had finished is not lost with it.
 */
const LOOK_FACTOR = 2;
/** Where tiles end one by one, a pass adds this part of the largest power of two of samples that are there. */
const ADAPTIVE_PART = 1 / 4;
/** A look comes after so many paths at the latest: some seconds of a fast GPU. */
const MOST_PATHS_UNSEEN = 2 ** 29;

export async function renderPasses(tracer: PathTracer, options: PassesOptions): Promise<PassesResult> {
  const { first, until, pixels, signal, lost = NEVER, onProgress } = options;
  const start = performance.now();
  const elapsed = () => (performance.now() - start) / 1000;
  const look = () => Promise.race([tracer.film(), lost]);
  let done = 0;
  let paths = 0;
  let seen = 0;
  let kept: Film | null = null;
  let error = Number.POSITIVE_INFINITY;
  let worst = Number.POSITIVE_INFINITY;
  let tiles: TileMask | null = null;
  let open = pixels;
  let stopped: PassesResult['stopped'] = null;
  const state = (samples: number): PassesState => {
    const seconds = elapsed();
    return { samples, seconds, part: partOf(until, samples, seconds, worst), error };
  };

  for (let count = 1; count > 0; count = nextCount(options, done, elapsed(), open)) {
    try {
      const pass = tracer.render(first + done, count, {
        signal,
        onProgress: (part) => onProgress?.(state((paths + part * count * open) / pixels)),
        ...(tiles !== null && { tiles }),
      });
      await Promise.race([pass, lost]);
      done += count;
      paths += count * open;
      const isAdaptive = until.kind === 'error' && done >= BASE_SAMPLES;
      if (isAdaptive || done >= LOOK_FACTOR * seen || (done - seen) * pixels >= MOST_PATHS_UNSEEN) {
        kept = await look();
        seen = done;
        error = kept.relativeError();
      }
      if (isAdaptive && kept !== null) {
        worst = tileErrors(kept).reduce((most, one) => Math.max(most, one), 0);
        tiles = openTiles(kept, until.error, tiles);
        open = tiles === null ? 0 : maskedPixels(kept.width, kept.height, tiles);
      }
    } catch (thrown) {
      stopped = signal.aborted ? 'signal' : thrown instanceof Error ? thrown : new Error(String(thrown));
      break;
    }
    onProgress?.(state(paths / pixels));
  }
  if (done > 0) {
    const last = await look().catch(() => null);
    if (last !== null) [kept, seen] = [last, done];
  }
  const samples = kept === null ? 0 : kept.count.reduce((sum, n) => sum + n, 0) / pixels;
  if (kept !== null) error = kept.relativeError();
  return { ...state(samples), film: kept, numbers: seen, stopped };
}

const NEVER = new Promise<never>(() => {});

/**
 * Samples of the next pass for `open` pixels, 0 at the end: 1, 1, 2, 4, ..., which are the sets that the sampler spreads evenly, up to
 * the largest. They depend on nothing that differs from run to run, since float sums depend on where they are cut;
 * only --time does, as it must.
 */
function nextCount(
  { until, pathsPerPass }: PassesOptions,
  done: number,
  seconds: number,
  open: number,
): number {
  if (open === 0) return 0;
  const most = Math.min(MOST_SAMPLES_PER_PASS, 2 ** Math.floor(Math.log2(pathsPerPass / open)));
  const count = Math.max(1, Math.min(done, most));
  if (until.kind === 'samples') return Math.min(count, until.count - done);
  if (until.kind === 'error') {
    const fine = done < BASE_SAMPLES ? count : ADAPTIVE_PART * 2 ** Math.floor(Math.log2(done));
    return Math.min(count, fine, until.most - done);
  }
  const fit = Math.floor((done / seconds) * (until.seconds - seconds));
  return Math.max(0, Math.min(count, fit));
}

function partOf(until: Until, samples: number, seconds: number, worst: number): number {
  if (until.kind === 'samples') return samples / until.count;
  if (until.kind === 'time') return Math.min(1, seconds / until.seconds);
  // The error falls with the square root of the number of samples; the worst tile's is the last to do so.
  return Math.min(1, (until.error / worst) ** 2);
}
