/** The part of a worker that is the same in a page and in Node. */
import { instantiateWasm, type WasmExports } from '../../glsl/wasm/instantiate.ts';
import { FILM_FLOATS } from '../film.ts';
import { HEADER, WORDS_PER_SLOT } from '../scene/layout.ts';
import type { FromWorker, LoadMessage, ToWorker, WorkerPlaces } from './protocol.ts';

/** Pixels of a job at most: a worker's film has room for them. */
export const MAX_JOB_PIXELS = 4096;

const PAGE = 65536;
const SETTINGS_BYTES = 4 * WORDS_PER_SLOT * HEADER.image;
/** For the kernel's arrays: far more than its traversal's two stacks. */
export const STACK_BYTES = PAGE;
export const FILM_BYTES = Math.ceil((MAX_JOB_PIXELS * FILM_FLOATS * 4) / PAGE) * PAGE;

/** Answers one message. @param reply takes the answer, with what may be handed over instead of copied */
export class WorkerCore {
  #memory: WebAssembly.Memory | null = null;
  #places: WorkerPlaces | null = null;
  #exports: WasmExports | null = null;
  readonly #reply: (message: FromWorker, transfer: ArrayBuffer[]) => void;

  constructor(reply: (message: FromWorker, transfer: ArrayBuffer[]) => void) {
    this.#reply = reply;
  }

  receive(message: ToWorker): void {
    try {
      this.#receive(message);
    } catch (error) {
      this.#reply({ kind: 'failed', message: error instanceof Error ? error.message : String(error) }, []);
    }
  }

  #receive(message: ToWorker): void {
    if (message.kind === 'load') {
      this.#load(message);
      return;
    }
    const { memory, places, exports } = this.#loaded();
    if (message.kind === 'set') {
      new Uint32Array(memory.buffer, places.scene + SETTINGS_BYTES).set(message.settings);
      return;
    }
    const { from, to, first, count, number } = message;
    const film = new Float32Array(memory.buffer, places.film, (to - from) * FILM_FLOATS);
    film.fill(0);
    exports.renderPixels?.(from, to, first, count);
    const copy = new Float32Array(film);
    this.#reply({ kind: 'done', number, from, film: copy }, [copy.buffer]);
  }

  #load({ module, words, memory, places }: LoadMessage): void {
    this.#memory = memory ?? ownMemory(words as Uint32Array<ArrayBuffer>);
    this.#places = places ?? OWN_PLACES;
    this.#exports = instantiateWasm(module, { memory: this.#memory, ...this.#places }).exports;
  }

  #loaded() {
    if (!this.#memory || !this.#places || !this.#exports) throw new Error('no scene has been loaded');
    return { memory: this.#memory, places: this.#places, exports: this.#exports };
  }
}

/** A worker with a memory of its own: stack, film, scene. */
const OWN_PLACES: WorkerPlaces = {
  stack: STACK_BYTES,
  film: STACK_BYTES,
  scene: STACK_BYTES + FILM_BYTES,
};

function ownMemory(words: Uint32Array<ArrayBuffer>): WebAssembly.Memory {
  const pages = Math.ceil((OWN_PLACES.scene + words.byteLength) / PAGE);
  const memory = new WebAssembly.Memory({ initial: pages, maximum: 65536 });
  new Uint32Array(memory.buffer, OWN_PLACES.scene, words.length).set(words);
  return memory;
}

/** One memory for `workers`: their stacks and films, then the scene. */
export function sharedMemory(
  words: Uint32Array<ArrayBuffer>,
  workers: number,
): { memory: WebAssembly.Memory; places: readonly WorkerPlaces[] } {
  const each = STACK_BYTES + FILM_BYTES;
  const scene = each * workers;
  const pages = Math.ceil((scene + words.byteLength) / PAGE);
  const memory = new WebAssembly.Memory({ initial: pages, maximum: 65536, shared: true });
  new Uint32Array(memory.buffer, scene, words.length).set(words);
  const places = Array.from({ length: workers }, (_, i) => ({
    scene,
    stack: each * i + STACK_BYTES,
    film: each * i + STACK_BYTES,
  }));
  return { memory, places };
}
