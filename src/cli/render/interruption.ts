/** Ctrl+C, and the signal of a render farm that wants its machine back. */

const NUMBERS = { SIGINT: 2, SIGTERM: 15 } as const;
type Signal = keyof typeof NUMBERS;

/** The first signal asks for an end, after which what there is is written; the second one ends the process. */
export class Interruption {
  readonly #controller = new AbortController();
  #exitCode = 0;

  constructor() {
    for (const name of Object.keys(NUMBERS) as Signal[]) process.on(name, this.#receive);
  }

  get signal(): AbortSignal {
    return this.#controller.signal;
  }

  /** As shells have it: 130 after Ctrl+C. */
  get exitCode(): number {
    return this.#exitCode;
  }

  dispose(): void {
    for (const name of Object.keys(NUMBERS) as Signal[]) process.off(name, this.#receive);
  }

  readonly #receive = (name: NodeJS.Signals): void => {
    const code = 128 + NUMBERS[name as Signal];
    if (this.#exitCode > 0) process.exit(code);
    this.#exitCode = code;
    this.#controller.abort();
  };
}
