/**
 * Lets go of what is no longer shown, one thing in a task: three.js takes down, with a material, all that it had made to draw
 * each object with it.
 */
interface Disposable {
  dispose(): void;
}

export class Disposal {
  readonly #waiting: Disposable[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;

  later(thing: Disposable): void {
    this.#waiting.push(thing);
    this.#timer ??= setTimeout(() => this.#next());
  }

  #next(): void {
    this.#timer = undefined;
    this.#waiting.shift()?.dispose();
    if (this.#waiting.length > 0) this.#timer = setTimeout(() => this.#next());
  }

  /** At once what is left. */
  dispose(): void {
    clearTimeout(this.#timer);
    for (const thing of this.#waiting.splice(0)) thing.dispose();
  }
}
