import { WORDS_PER_SLOT } from './layout.ts';

/** Growing memory that knows where in the scene's memory it will lie. Positions are absolute. */
export class Words {
  readonly #base: number;
  #length = 0;
  #uints = new Uint32Array(1024);
  #floats = new Float32Array(this.#uints.buffer);

  /** @param base the word at which it will begin, a slot's first */
  constructor(base = 0) {
    this.#base = base;
  }

  /** The next slot. */
  get slot(): number {
    return (this.#base + this.#length) / WORDS_PER_SLOT;
  }

  get length(): number {
    return this.#length;
  }

  /** What has been written so far. */
  get words(): Uint32Array<ArrayBuffer> {
    return this.#uints.subarray(0, this.#length);
  }

  /** Appends zeros and returns the slot at which they begin. */
  allocate(slots: number): number {
    const { slot } = this;
    this.#length += slots * WORDS_PER_SLOT;
    if (this.#length > this.#uints.length) {
      const grown = new Uint32Array(Math.max(this.#length, 2 * this.#uints.length));
      grown.set(this.#uints);
      this.#uints = grown;
      this.#floats = new Float32Array(grown.buffer);
    }
    return slot;
  }

  /** Where in `words` a slot begins. */
  wordOf(slot: number): number {
    return slot * WORDS_PER_SLOT - this.#base;
  }

  setUints(slot: number, ...values: readonly number[]): void {
    const at = this.wordOf(slot);
    for (let i = 0; i < values.length; i += 1) this.#uints[at + i] = values[i] as number;
  }

  setFloats(slot: number, ...values: readonly number[]): void {
    const at = this.wordOf(slot);
    for (let i = 0; i < values.length; i += 1) this.#floats[at + i] = values[i] as number;
  }

  /** One word of a slot of floats that is not a float. */
  setUint(slot: number, word: number, value: number): void {
    this.#uints[this.wordOf(slot) + word] = value;
  }
}
