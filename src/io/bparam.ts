/**
 * Parameters that Disney's BRDF Explorer saved (`.bparam`): the name of the file they belong to, then a
 * table of parameters as in a .brdf file, whose defaults are the saved values.
 */
import { BrdfError } from '../brdf/error.ts';
import type { Parameter, ParameterValue } from '../brdf/model.ts';
import { parseBrdf } from '../brdf/parse.ts';

export interface SavedParameters {
  /** The BRDF's file as the Explorer knew it, without folders: `disney.brdf`. */
  readonly source: string;
  /** The name of the model in that file. */
  readonly model: string;
  readonly parameters: readonly Parameter[];
}

const FIRST_LINE = /^\uFEFF?[ \t]*bparam[ \t]+(.*?)[ \t]*(?:\r\n|\r|\n|$)/;

/** @throws BrdfError naming file, line and what was expected */
export function readBparam(text: string, fileName: string): SavedParameters {
  const first = FIRST_LINE.exec(text);
  const source = (first?.[1] ?? '').replace(/^.*[/\\]/, '');
  if (!first || source === '')
    throw new BrdfError({ file: fileName, line: 1 }, 'not saved parameters', "'bparam FILE.brdf'");
  // What follows is a .brdf file without GLSL: its parser says what is wrong on which line.
  const table = `analytic\n${text.slice(first[0].length)}\n::begin shader\n::end shader\n`;
  const { parameters } = parseBrdf(table, fileName);
  return { source, model: source.replace(/\.[A-Za-z0-9]+$/, ''), parameters };
}

/**
 * The saved values that a model can take, by name and type; and the names of the others, as the Explorer
 * passes over them too.
 */
export function savedValues(
  saved: SavedParameters,
  of: readonly Parameter[],
): { values: Record<string, ParameterValue>; unknown: string[] } {
  const fits = (parameter: Parameter) =>
    of.some(({ name, type }) => name === parameter.name && type === parameter.type);
  return {
    values: Object.fromEntries(saved.parameters.filter(fits).map((p) => [p.name, p.default])),
    unknown: saved.parameters.filter((p) => !fits(p)).map(({ name }) => name),
  };
}
