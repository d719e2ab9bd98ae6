/** Where in a lesson's text something is wrong, and what was expected there. */
export interface Place {
  readonly file: string;
  /** From 1. */
  readonly line: number;
}

/** Texts from strangers may be long; a message should not be. */
const MOST_SHOWN = 80;

export const shown = (text: string): string =>
  text.length > MOST_SHOWN ? `${text.slice(0, MOST_SHOWN)}…` : text;

/** The message is always `file:line: what is wrong; expected ...`. */
export class LessonError extends Error {
  override readonly name = 'LessonError';
  readonly file: string;
  readonly line: number;
  readonly expected: string | undefined;

  constructor({ file, line }: Place, what: string, expected?: string) {
    super(`${file}:${line}: ${what}${expected === undefined ? '' : `; expected ${expected}`}`);
    this.file = file;
    this.line = line;
    this.expected = expected;
  }
}
