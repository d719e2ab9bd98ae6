/** Frames that somebody waits for: each wait ends with a frame that began after it, or with what ended the drawing. */

interface Waiter {
  resolve(): void;
  reject(error: unknown): void;
}

export class AwaitedFrames {
  #waiting: Waiter[] = [];
  /** Of frames that are being drawn. */
  readonly #begun = new Set<Waiter>();
  #fault: { readonly error: unknown } | null = null;

  /** Resolves when a frame that begins from now on is finished; rejects when none will be. */
  next(): Promise<void> {
    if (this.#fault) return Promise.reject(this.#fault.error);
    return new Promise((resolve, reject) => {
      this.#waiting.push({ resolve, reject });
    });
  }

  get areAwaited(): boolean {
    return this.#waiting.length > 0;
  }

  /** A frame begins. @returns what is called when it is finished */
  begin(): () => void {
    const waiters = this.#waiting;
    this.#waiting = [];
    for (const waiter of waiters) this.#begun.add(waiter);
    return () => {
      for (const waiter of waiters) {
        this.#begun.delete(waiter);
        waiter.resolve();
      }
    };
  }

  /** No frame comes any more. */
  fail(error: unknown): void {
    this.#fault = { error };
    for (const { reject } of [...this.#begun, ...this.#waiting]) reject(error);
    this.#begun.clear();
    this.#waiting = [];
  }
}
