/**
 * Renders when something changed, or on every animation frame when asked to.
 *
 * What a frame took is told honestly in both cases. When frames follow one another, it is the time
 * from one to the next, which is what a person sees, stutter included. A frame that comes alone has
 * no frame before it; its time is from its start until the GPU has finished it.
 */

export interface FrameLoopOptions {
  /** Submits a frame; the promise resolves when the GPU has finished it. */
  render(): Promise<void>;
  onFrame(at: number, ms: number): void;
  onError(error: unknown): void;
}

/** Frames that the GPU may be behind; more would only delay what the hand does. */
const MOST_IN_FLIGHT = 2;

export class FrameLoop {
  readonly #options: FrameLoopOptions;
  #wanted = false;
  #continuous = false;
  #scheduled = false;
  #inFlight = 0;
  #previous: number | null = null;
  #stopped = false;

  constructor(options: FrameLoopOptions) {
    this.#options = options;
  }

  request(): void {
    this.#wanted = true;
    this.#schedule();
  }

  set continuous(value: boolean) {
    this.#continuous = value;
    this.interrupt();
    this.#schedule();
  }

  /** The next frame comes alone: the page was hidden, and browsers stop the clock of hidden pages. */
  interrupt(): void {
    this.#previous = null;
  }

  /** After an error that every further frame would repeat. */
  stop(): void {
    this.#stopped = true;
  }

  #schedule(): void {
    if (this.#scheduled || this.#stopped) return;
    this.#scheduled = true;
    requestAnimationFrame((now) => this.#tick(now));
  }

  #tick(now: number): void {
    this.#scheduled = false;
    if (this.#stopped) return;
    if (!this.#wanted && !this.#continuous) {
      this.#previous = null;
      return;
    }
    // One tick past the last change tells whether frames follow one another.
    this.#schedule();
    if (this.#inFlight >= MOST_IN_FLIGHT) return;
    this.#wanted = false;
    const previous = this.#previous;
    this.#previous = now;
    const start = performance.now();
    this.#inFlight += 1;
    this.#options
      .render()
      .then(() => this.#options.onFrame(now, previous === null ? performance.now() - start : now - previous))
      .catch((error: unknown) => this.#options.onError(error))
      .finally(() => {
        this.#inFlight -= 1;
      });
  }
}
