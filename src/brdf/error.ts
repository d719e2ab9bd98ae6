/** Where something stands in a source file; lines and columns count from 1. */
export interface SourcePlace {
  readonly file: string;
  readonly line: number;
  readonly column?: number;
}

/**
 * A fault in a `.brdf` file (or in a file that it includes): in its sections, its table of parameters or
 * its GLSL. The message reads `file:line:column: what is wrong; expected ...`.
 */
export class BrdfError extends Error {
  readonly file: string;
  readonly line: number;
  readonly column: number | undefined;
  readonly expected: string | undefined;

  constructor(place: SourcePlace, problem: string, expected?: string) {
    const column = place.column === undefined ? '' : `:${place.column}`;
    super(
      `${place.file}:${place.line}${column}: ${problem}${expected === undefined ? '' : `; expected ${expected}`}`,
    );
    this.name = 'BrdfError';
    this.file = place.file;
    this.line = place.line;
    this.column = place.column;
    this.expected = expected;
  }
}

/** A value that a model's parameter cannot take; names the model and the parameter. */
export class BrdfParameterError extends Error {
  readonly model: string;
  readonly parameter: string;

  constructor(model: string, parameter: string, problem: string) {
    super(`${model}: parameter ${parameter}: ${problem}`);
    this.name = 'BrdfParameterError';
    this.model = model;
    this.parameter = parameter;
  }
}
