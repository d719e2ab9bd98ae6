import { messageOf } from '../assets.ts';

/** Work that has been started and not come back yet, such as assets being decoded. */
export class Pending {
  readonly #work = new Set<Promise<void>>();
  readonly #onError: (message: string) => void;

  constructor(onError: (message: string) => void) {
    this.#onError = onError;
  }

  /** Hands the result to `use` when it comes; a failure is reported, not thrown. */
  add<T>(work: Promise<T>, use: (result: T) => void): void {
    const done = work
      .then(use)
      .catch((error: unknown) => this.#onError(messageOf(error)))
      .finally(() => this.#work.delete(done));
    this.#work.add(done);
  }

  /** All work asked for so far, and what that work asked for, is done. */
  async settled(): Promise<void> {
    while (this.#work.size > 0) await Promise.all(this.#work);
  }
}
