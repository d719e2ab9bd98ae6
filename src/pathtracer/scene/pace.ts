/**
 * Lets long work share its thread: it asks `due` often and awaits rest() when it is.
 */
const SLICE_MS = 20;
/** Items of a loop that are handled between two looks at the clock. */
const SLICE_ITEMS = 32_768;

/**
 * Node's way to let others have their turn: there a message would come before any timer. In pages messages it is:
 * timers are slowed down when they are nested, and in hidden pages.
 */
const { setImmediate } = globalThis as { setImmediate?: (callback: () => void) => void };

export class Pace {
  readonly #signal: AbortSignal | undefined;
  readonly #channel = setImmediate === undefined ? new MessageChannel() : null;
  #until = performance.now() + SLICE_MS;

  /** @param signal ends the work: rest() then throws its reason */
  constructor(signal?: AbortSignal) {
    this.#signal = signal;
    signal?.throwIfAborted();
  }

  get due(): boolean {
    return performance.now() >= this.#until;
  }

  /** Resolves in a later task, when others have had theirs. */
  async rest(): Promise<void> {
    await new Promise<void>((resolve) => {
      if (this.#channel === null) setImmediate?.(resolve);
      else {
        this.#channel.port1.onmessage = () => resolve();
        this.#channel.port2.postMessage(null);
      }
    });
    this.#signal?.throwIfAborted();
    this.#until = performance.now() + SLICE_MS;
  }

  /** Calls `work` for parts of a range of items, in order, and rests in between when that is due. */
  async each(from: number, to: number, work: (from: number, to: number) => void): Promise<void> {
    for (let at = from; at < to; at += SLICE_ITEMS) {
      work(at, Math.min(to, at + SLICE_ITEMS));
      if (this.due) await this.rest();
    }
  }

  end(): void {
    this.#channel?.port1.close();
  }
}
