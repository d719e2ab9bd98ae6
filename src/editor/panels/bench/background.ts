/** The page's side of the workers: asks again only when something changed, keeps what came last. */
import type { TriangleMesh } from '../../../analysis/plots/surface.ts';
import type { Answer, Job, Result, Shape, Source, Task } from './jobs.ts';
import type { Subject } from './series.ts';
import type { OwnModel } from './settings.ts';

interface Wish {
  readonly signature: string;
  readonly source: Subject['source'];
  readonly ticket: number;
  result: Result | null;
}

/** Integrals take far longer than pictures: those do not wait for them. */
const SLOW: readonly Task['kind'][] = ['albedo', 'sweep'];

/** One who types makes a source with every key; a worker keeps the last few. */
const MOST_SOURCES = 12;

export class Background {
  readonly #wishes = new Map<string, Wish>();
  readonly #onResult: () => void;
  readonly #workers = new Map<boolean, Worker>();
  readonly #shapes = new WeakMap<TriangleMesh, number>();
  /** Which sources each worker has. */
  readonly #sources = new Map<Worker, Map<OwnModel, number>>();
  #sent: TriangleMesh | null = null;
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
    const worker = this.#worker(SLOW.includes(task.kind));
    const ticket = this.#tickets;
    const job: Job = {
      key,
      ticket,
      model,
      source: source && this.#source(worker, source),
      parameters,
      term,
      task,
    };
    // The old curve stays in sight until the first part of the new one comes.
    const result = known?.result ? { ...known.result, progress: 0 } : null;
    this.#wishes.set(key, { signature, source, ticket, result });
    worker.postMessage(job);
    return result;
  }

  /** The number by which a task names a shape. */
  shape(triangles: TriangleMesh): number {
    const mesh = this.#shapes.get(triangles) ?? ++this.#tickets;
    this.#shapes.set(triangles, mesh);
    if (this.#sent !== triangles) this.#worker(false).postMessage({ mesh, triangles } satisfies Shape);
    this.#sent = triangles;
    return mesh;
  }

  #source(worker: Worker, own: OwnModel): number {
    const sent = this.#sources.get(worker) ?? new Map<OwnModel, number>();
    this.#sources.set(worker, sent);
    const known = sent.get(own);
    if (known !== undefined) return known;
    const source = ++this.#tickets;
    sent.set(own, source);
    worker.postMessage({ source, own } satisfies Source);
    const [oldest] = sent;
    if (oldest && sent.size > MOST_SOURCES) {
      sent.delete(oldest[0]);
      worker.postMessage({ source: oldest[1], own: null } satisfies Source);
    }
    return source;
  }

  #worker(slow: boolean): Worker {
    const known = this.#workers.get(slow);
    if (known) return known;
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => {
      const wish = this.#wishes.get(data.key);
      if (!wish) return;
      // While a slider moves, what comes is of a moment ago: shown, and not taken for the end.
      wish.result = wish.ticket === data.ticket ? data.result : { ...data.result, progress: 0 };
      this.#onResult();
    });
    this.#workers.set(slow, worker);
    return worker;
  }
}
