import { nextTask } from '../next-task.ts';

/** Brings a panel up to date: at once where that is little work, else in a task of its own, once for all that changes before it. */
export class Follower {
  readonly #work: () => void;
  readonly #isQuick: () => boolean;
  #isWaiting = false;

  /** @param isQuick whether the work may be done within the task that asks for it */
  constructor(work: () => void, isQuick: () => boolean) {
    this.#work = work;
    this.#isQuick = isQuick;
  }

  soon(): void {
    if (this.#isQuick()) {
      this.#isWaiting = false;
      this.#work();
    } else if (!this.#isWaiting) {
      this.#isWaiting = true;
      void nextTask().then(() => this.now());
    }
  }

  /** Does what waits: to be called before what the panel shows is used. */
  now(): void {
    if (!this.#isWaiting) return;
    this.#isWaiting = false;
    this.#work();
  }
}
