import { nextTask } from '../next-task.ts';

/**
 * Brings a panel up to date: at once where that is little work, else in a task of its own, once for all that changes before it.
 * A key that is pressed before that task comes first brings it about: browsers put input before tasks, and on a busy page a
 * person with the keyboard would go through a panel that is not there yet.
 */
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
      this.#done();
      this.#work();
    } else if (!this.#isWaiting) {
      this.#isWaiting = true;
      window.addEventListener('keydown', this.now, true);
      void nextTask().then(this.now);
    }
  }

  /** Does what waits: to be called before what the panel shows is used. */
  readonly now = (): void => {
    if (!this.#isWaiting) return;
    this.#done();
    this.#work();
  };

  #done(): void {
    this.#isWaiting = false;
    window.removeEventListener('keydown', this.now, true);
  }
}
