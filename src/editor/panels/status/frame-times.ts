/**
 * The frame times of late, and what they say: percentiles and spikes. An average would hide the
 * stutter that a person sees when one frame takes 30 ms among frames of 16.
 */

export interface FrameSample {
  /** When the frame was shown, in the page's clock. */
  readonly at: number;
  readonly ms: number;
  readonly spike: boolean;
}

export interface FrameStatistics {
  readonly count: number;
  readonly p50: number;
  readonly p95: number;
  readonly p99: number;
  readonly spikes: number;
  /** Frames shown in the last second. */
  readonly fps: number;
}

const KEPT = 600;
/** The frames that say what is usual now. */
const USUAL = 60;
const SPIKE_FACTOR = 1.5;
/** Less than this is not seen, however short the usual frame is. */
const SPIKE_LEAST_MS = 4;

export class FrameTimes {
  readonly #samples: FrameSample[] = [];

  get samples(): readonly FrameSample[] {
    return this.#samples;
  }

  add(at: number, ms: number): void {
    const usual = median(this.#samples.slice(-USUAL).map((sample) => sample.ms));
    const spike = usual !== null && ms > usual * SPIKE_FACTOR && ms - usual > SPIKE_LEAST_MS;
    this.#samples.push({ at, ms, spike });
    if (this.#samples.length > KEPT) this.#samples.shift();
  }

  clear(): void {
    this.#samples.length = 0;
  }

  statistics(now: number): FrameStatistics {
    const sorted = this.#samples.map((sample) => sample.ms).sort((a, b) => a - b);
    return {
      count: sorted.length,
      p50: percentile(sorted, 0.5),
      p95: percentile(sorted, 0.95),
      p99: percentile(sorted, 0.99),
      spikes: this.#samples.filter((sample) => sample.spike).length,
      fps: this.#samples.filter((sample) => now - sample.at < 1000).length,
    };
  }
}

/** Nearest rank: always a time that some frame really took. NaN without frames. */
export function percentile(sorted: readonly number[], fraction: number): number {
  return sorted[Math.max(0, Math.ceil(fraction * sorted.length) - 1)] ?? Number.NaN;
}

function median(values: readonly number[]): number | null {
  if (values.length < 4) return null;
  return percentile(
    [...values].sort((a, b) => a - b),
    0.5,
  );
}
