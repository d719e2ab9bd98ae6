/** The page's end of a thread that answers questions. It starts with the first, and ends when nobody has asked for a while. */

export interface ToThread<Question> {
  readonly ticket: number;
  readonly question: Question;
}
export type FromThread<Answer> =
  | { readonly ticket: number; readonly answer: Answer }
  | { readonly ticket: number; readonly refusal: string };

/** What is used of a Worker. */
export type ThreadWorker = Pick<Worker, 'postMessage' | 'addEventListener' | 'terminate'>;

/** It was ended before it answered. */
export class ThreadEnded extends Error {}

/** For what nobody waits for any more. */
export function ignoreEnd(error: unknown): void {
  if (!(error instanceof ThreadEnded)) throw error;
}

/** What it remembers takes memory. */
const IDLE_MS = 20_000;

export interface ThreadOptions {
  /** What it works for, which its failures tell. */
  readonly name?: string;
  /** A worker that is there already, and serves until it ends. */
  readonly running?: ThreadWorker;
}

export class Thread<Question, Answer> {
  readonly #spawn: () => ThreadWorker;
  readonly #name: string | null;
  readonly #waiting = new Map<number, { resolve(answer: Answer): void; reject(error: Error): void }>();
  #worker: ThreadWorker | null = null;
  #ticket = 0;
  #life = 0;
  #idle: ReturnType<typeof setTimeout> | undefined;

  constructor(spawn: () => ThreadWorker, { name, running }: ThreadOptions = {}) {
    this.#spawn = spawn;
    this.#name = name ?? null;
    if (!running) return;
    this.#use(running);
    this.#rest();
  }

  /** Another number whenever another thread is at work, which knows nothing of what this one was told. */
  get life(): number {
    return this.#life;
  }

  /** Fails with what is wrong, and with ThreadEnded if the thread ends. */
  ask(question: Question, transfer: Transferable[] = []): Promise<Answer> {
    const worker = this.#worker ?? this.#use(this.#spawn());
    clearTimeout(this.#idle);
    const ticket = ++this.#ticket;
    return new Promise((resolve, reject) => {
      this.#waiting.set(ticket, { resolve, reject });
      worker.postMessage({ ticket, question } satisfies ToThread<Question>, transfer);
    });
  }

  /** What is being worked on is given up. */
  end(error: Error = new ThreadEnded('The thread was ended.')): void {
    clearTimeout(this.#idle);
    this.#worker?.terminate();
    this.#worker = null;
    this.#life += 1;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of waiting) reject(error);
  }

  #use(worker: ThreadWorker): ThreadWorker {
    this.#worker = worker;
    worker.addEventListener('message', ({ data }: MessageEvent<FromThread<Answer>>) => {
      const waiting = this.#waiting.get(data.ticket);
      this.#waiting.delete(data.ticket);
      if (this.#waiting.size === 0) this.#rest();
      if ('refusal' in data) waiting?.reject(new Error(data.refusal));
      else waiting?.resolve(data.answer);
    });
    worker.addEventListener('error', (event) => {
      if (this.#worker !== worker) return;
      const { message } = event;
      const fault =
        this.#name === null
          ? message || 'A thread of the page ended.'
          : `${this.#name}: ${message || 'its thread ended'}`;
      this.end(new Error(fault));
    });
    return worker;
  }

  #rest(): void {
    clearTimeout(this.#idle);
    this.#idle = setTimeout(() => this.end(), IDLE_MS);
  }
}
