/** When the director has a film denoised, and what came of it. */
import type { Film } from '../../pathtracer/film.ts';
import type { Denoise } from './denoiser.ts';

/** Fewer samples do not tell a pixel's variance. */
const LEAST_SAMPLES = 4;

export interface Denoised {
  /** Per pixel, of the film that was denoised. */
  readonly samples: number;
  /** RGB, before. */
  readonly noisy: Float32Array;
  /** RGB. */
  readonly radiance: Float32Array;
  /** The part of each pixel that something covers. */
  readonly alpha: Float32Array;
  /** The same before. */
  readonly noisyAlpha: Float32Array;
}

export interface DenoisingOptions {
  readonly denoise: Denoise;
  onProgress(part: number): void;
  /** There is another result, or the reason why there is none. */
  onEnd(error: unknown): void;
}

export class Denoising {
  readonly #options: DenoisingOptions;
  #job: AbortController | null = null;
  #result: Denoised | null = null;
  /** Samples of the film that was tried last: what failed is not tried again with the same ones. */
  #tried = 0;

  constructor(options: DenoisingOptions) {
    this.#options = options;
  }

  get result(): Denoised | null {
    return this.#result;
  }

  /** At rest what there is; before, each time that the samples have doubled. */
  isDue(samples: number, rests: boolean): boolean {
    if (this.#job !== null || samples < 1) return false;
    return rests ? samples > this.#tried : samples >= Math.max(LEAST_SAMPLES, 2 * this.#tried);
  }

  /** @param film may change meanwhile */
  async begin(film: Film, samples: number): Promise<void> {
    const job = new AbortController();
    this.#job = job;
    this.#tried = samples;
    const [noisy, noisyAlpha] = [film.mean(), film.meanAlpha()];
    let failure: unknown = null;
    try {
      const { radiance, alpha } = await this.#options.denoise(film, {
        signal: job.signal,
        onProgress: (part) => {
          if (this.#job === job) this.#options.onProgress(part);
        },
      });
      if (this.#job === job)
        this.#result = { samples, noisy, radiance, alpha: alpha ?? noisyAlpha, noisyAlpha };
    } catch (error) {
      failure = error;
    }
    if (this.#job !== job) return;
    this.#job = null;
    this.#options.onEnd(failure);
  }

  /** Ends what is under way; it may be begun again. */
  stop(): void {
    if (this.#job === null) return;
    this.#job.abort();
    this.#job = null;
    this.#tried = this.#result?.samples ?? 0;
  }

  /** For another picture. */
  forget(): void {
    this.stop();
    this.#result = null;
    this.#tried = 0;
  }
}
