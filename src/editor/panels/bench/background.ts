/** The page's side of the worker: asks again only when something changed, keeps what came last. */
import type { Answer, Job, Result, Task } from './jobs.ts';
import type { Subject } from './series.ts';

interface Wish {
  readonly signature: string;
  readonly source: Subject['source'];
  readonly ticket: number;
  result: Result | null;
}

export class Background {
  readonly #wishes = new Map<string, Wish>();
  readonly #onResult: () => void;
  #worker: Worker | null = null;
  #tickets = 0;

  constructor(onResult: () => void) {
    this.#onResult = onResult;
  }

  /** What is known of it so far; null until the first part has come. */
  ask(subject: Subject, term: string, task: Task): Result | null {
    const { model, source, parameters } = subject;
    const key = `${subject.id} ${task.kind}`;
    const signature = JSON.stringify([model, parameters, term, task]);
    const known = this.#wishes.get(key);
    if (known && known.signature === signature && known.source === source) return known.result;
    this.#tickets += 1;
    const job: Job = { key, ticket: this.#tickets, subject: { model, source, parameters }, term, task };
    // The old curve stays in sight until the first part of the new one comes.
    const result = known?.result ? { ...known.result, progress: 0 } : null;
    this.#wishes.set(key, { signature, source, ticket: job.ticket, result });
    this.#start().postMessage(job);
    return result;
  }

  #start(): Worker {
    if (this.#worker) return this.#worker;
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => {
      const wish = this.#wishes.get(data.key);
      if (!wish) return;
      // While a slider moves, what comes is of a moment ago: shown, and not taken for the end.
      wish.result = wish.ticket === data.ticket ? data.result : { ...data.result, progress: 0 };
      this.#onResult();
    });
    this.#worker = worker;
    return worker;
  }
}
