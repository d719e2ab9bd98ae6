import { HEADER_SLOTS, WORDS_PER_SLOT } from './layout.ts';

/** Where the large parts lie, in the order in which they are asked for. */
export class Places {
  #words = HEADER_SLOTS * WORDS_PER_SLOT;
  readonly #parts: { at: number; place: (memory: Uint32Array<ArrayBuffer>, at: number) => void }[] = [];

  get words(): number {
    return this.#words;
  }

  /** Reserves whole slots. @returns the word at which they begin */
  reserve(words: number, place: (memory: Uint32Array<ArrayBuffer>, at: number) => void): number {
    const at = this.#words;
    this.#parts.push({ at, place });
    this.#words += WORDS_PER_SLOT * Math.ceil(words / WORDS_PER_SLOT);
    return at;
  }

  floats(values: Float32Array): number {
    return this.reserve(values.length, (memory, at) => new Float32Array(memory.buffer).set(values, at));
  }

  bytes(values: Uint8Array): number {
    return this.reserve(values.length / 4, (memory, at) => new Uint8Array(memory.buffer).set(values, 4 * at));
  }

  write(memory: Uint32Array<ArrayBuffer>): void {
    for (const { at, place } of this.#parts) place(memory, at);
  }
}
