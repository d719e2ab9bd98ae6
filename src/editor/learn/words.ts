/** The words after a directive's name: split at spaces, "some words" and [1, 2, 3] in one piece. */
import { LessonError, type Place, shown } from './error.ts';

const WORD = /"[^"]*"|\[[^\]]*\]|\S+/g;

export class Words {
  readonly #text: string;
  readonly #place: Place;
  readonly #pattern = new RegExp(WORD);

  constructor(text: string, place: Place) {
    this.#text = text;
    this.#place = place;
  }

  fail(what: string, expected: string): never {
    throw new LessonError(this.#place, what, expected);
  }

  /** The next one, if there is one. */
  optional(): string | null {
    const word = this.#pattern.exec(this.#text)?.[0];
    if (word === undefined) this.#end();
    return word ?? null;
  }

  word(expected: string): string {
    return this.optional() ?? this.fail('something is missing at the end', expected);
  }

  number(expected: string): number {
    return this.#toNumber(this.word(expected), expected);
  }

  /** The next word if it is a number; otherwise it is left for rest(). */
  optionalNumber(): number | null {
    const { lastIndex } = this.#pattern;
    const word = this.optional();
    if (word !== null && isNumber(word)) return Number(word);
    this.#pattern.lastIndex = lastIndex;
    return null;
  }

  /** The rest of the line as it stands. */
  rest(): string {
    const rest = this.#text.slice(this.#pattern.lastIndex).trim();
    this.#end();
    return rest;
  }

  /** All that is left, as `name=value`. */
  pairs(): Map<string, string> {
    const pairs = new Map<string, string>();
    for (let word = this.optional(); word !== null; word = this.optional()) {
      const [, name, value] = /^([A-Za-z_]\w*)=(.+)$/.exec(word) ?? [];
      if (name === undefined || value === undefined) this.fail(`“${shown(word)}”`, 'name=value');
      if (pairs.has(name)) this.fail(`${name} stands twice`, 'it once');
      pairs.set(name, value);
    }
    return pairs;
  }

  nothingMore(): void {
    const rest = this.rest();
    if (rest !== '') this.fail(`“${shown(rest)}” is too much`, 'the end of the line');
  }

  /** A pattern that has come to its end would begin anew. */
  #end(): void {
    this.#pattern.lastIndex = this.#text.length;
  }

  #toNumber(word: string, expected: string): number {
    if (!isNumber(word)) this.fail(`“${shown(word)}” is not a number`, expected);
    return Number(word);
  }
}

export const isNumber = (word: string): boolean => /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word);

/** `3`, `true`, `[1, 0, 0]`, `"some words"`, `word`, or any JSON. Undefined if it is none of these. */
export function readValue(text: string): unknown {
  if (isNumber(text)) return Number(text);
  if (/^[A-Za-z][\w-]*$/.test(text) && !['true', 'false', 'null'].includes(text)) return text;
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
