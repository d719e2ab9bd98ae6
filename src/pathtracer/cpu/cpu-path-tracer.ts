/** The path tracer on the CPU: WebAssembly in one worker per core. */
import { emitWasm } from '../../glsl/wasm/emit.ts';
import type { Camera } from '../../scene/schema.ts';
import { FILM_FLOATS, Film } from '../film.ts';
import { pathTracerKernel } from '../kernel.ts';
import type { PassOptions, PathTracer } from '../path-tracer.ts';
import { type RenderSettings, writeCamera, writeSettings } from '../scene/camera.ts';
import { HEADER, HEADER_SLOTS, WORDS_PER_SLOT } from '../scene/layout.ts';
import type { PackedScene } from '../scene/pack.ts';
import { maskedPixels, pixelRuns, type Run } from '../tiles.ts';
import type { FromWorker, WorkerPort } from './protocol.ts';
import { MAX_JOB_PIXELS, sharedMemory } from './worker-core.ts';

/** About so many samples make a job: a fraction of a second, so that a picture grows and a cancel is quick. */
const JOB_SAMPLES = 4096;

export interface CpuOptions {
  readonly workers: number;
  spawn(): WorkerPort;
  /** Whether memory can be shared between workers: in a page only if it is isolated. */
  readonly shared: boolean;
}

/** A pass of render() that is under way. */
interface Pass {
  readonly jobs: Run[];
  readonly first: number;
  readonly count: number;
  readonly pixels: number;
  /** What has come so far: it counts only when all has. */
  readonly results: Extract<FromWorker, { kind: 'done' }>[];
  done: number;
  running: number;
  readonly onProgress: ((part: number) => void) | undefined;
  settle(error?: unknown): void;
}

export class CpuPathTracer implements PathTracer {
  readonly device: string;
  readonly #options: CpuOptions;
  #workers: WorkerPort[] = [];
  #module: WebAssembly.Module | null = null;
  #models: PackedScene['models'] = [];
  #settings: RenderSettings | null = null;
  #film = new Film(0, 0);
  /** Counts renderings: what a job of an earlier one brings is thrown away. */
  #number = 0;
  #pass: Pass | null = null;
  #failure: Error | null = null;

  constructor(options: CpuOptions) {
    this.#options = options;
    this.device = `${options.workers} CPU thread${options.workers === 1 ? '' : 's'}`;
  }

  async load(scene: PackedScene): Promise<void> {
    const sameModels =
      this.#module !== null &&
      this.#models.length === scene.models.length &&
      this.#models.every((model, i) => model === scene.models[i]);
    if (!sameModels) {
      const kernel = pathTracerKernel(scene.models);
      const bytes = emitWasm([kernel.entry('renderPixels')], { shared: this.#options.shared });
      this.#module = await WebAssembly.compile(bytes);
      this.#models = scene.models;
    }
    this.#spawn();
    const module = this.#module as WebAssembly.Module;
    const { shared } = this.#options;
    const { memory, places } = shared
      ? sharedMemory(scene.words, this.#workers.length)
      : { memory: null, places: [] };
    for (const [i, worker] of this.#workers.entries()) {
      const words = shared ? null : scene.words;
      worker.post({ kind: 'load', module, words, memory, places: places[i] ?? null });
    }
  }

  start(camera: Camera, settings: RenderSettings): void {
    this.#settings = settings;
    this.#film = new Film(settings.width, settings.height);
    this.#number += 1;
    const header = new Uint32Array(HEADER_SLOTS * WORDS_PER_SLOT);
    writeCamera(header, camera, settings);
    writeSettings(header, settings);
    const part = header.slice(HEADER.image * WORDS_PER_SLOT);
    for (const worker of this.#workers) worker.post({ kind: 'set', settings: part });
  }

  render(first: number, count: number, { signal, onProgress, tiles }: PassOptions = {}): Promise<void> {
    if (this.#settings === null) throw new Error('render() before start()');
    if (this.#pass !== null) throw new Error('render() while another pass is under way');
    if (this.#failure !== null) return Promise.reject(this.#failure);
    const { width, height } = this.#settings;
    const pixels = tiles ? maskedPixels(width, height, tiles) : width * height;
    const step = Math.max(1, Math.min(MAX_JOB_PIXELS, Math.floor(JOB_SAMPLES / count)));
    const jobs = pixelRuns(width, height, step, tiles);
    if (jobs.length === 0) return Promise.resolve();
    return new Promise<void>((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      const stop = () => {
        // What is being rendered comes to its end; the rest is not begun.
        jobs.length = 0;
        if (this.#pass?.running === 0) this.#pass.settle();
      };
      const settle = (error?: unknown) => {
        this.#pass = null;
        signal?.removeEventListener('abort', stop);
        if (error !== undefined) reject(error);
        else if (signal?.aborted) reject(signal.reason);
        else resolve(this.#commit(results));
      };
      const results: Pass['results'] = [];
      signal?.addEventListener('abort', stop);
      this.#pass = { jobs, first, count, pixels, results, done: 0, running: 0, onProgress, settle };
      for (const worker of this.#workers) this.#next(worker);
    });
  }

  async film(): Promise<Film> {
    return this.#film;
  }

  dispose(): void {
    for (const worker of this.#workers) worker.terminate();
    this.#workers = [];
    this.#pass?.settle(new DOMException('the path tracer was disposed of', 'AbortError'));
  }

  #spawn(): void {
    while (this.#workers.length < this.#options.workers) {
      const worker = this.#options.spawn();
      worker.onMessage((message) => this.#receive(worker, message));
      worker.onError((message) => this.#fail(message));
      this.#workers.push(worker);
    }
  }

  #next(worker: WorkerPort): void {
    const pass = this.#pass;
    const job = pass?.jobs.shift();
    if (!pass || !job) return;
    pass.running += 1;
    worker.post({ kind: 'job', number: this.#number, first: pass.first, count: pass.count, ...job });
  }

  #receive(worker: WorkerPort, message: FromWorker): void {
    if (message.kind === 'failed') {
      this.#fail(message.message);
      return;
    }
    const pass = this.#pass;
    // A job of a rendering that has been given up.
    if (!pass || message.number !== this.#number) return;
    pass.results.push(message);
    pass.running -= 1;
    pass.done += message.film.length;
    pass.onProgress?.(Math.min(1, pass.done / (pass.pixels * FILM_FLOATS)));
    this.#next(worker);
    if (pass.running === 0 && pass.jobs.length === 0) pass.settle();
  }

  #commit(results: Pass['results']): void {
    for (const { film, from } of results) this.#film.add(film, from);
  }

  #fail(message: string): void {
    this.#failure = new Error(`a worker of the path tracer failed: ${message}`);
    this.#pass?.settle(this.#failure);
  }
}
