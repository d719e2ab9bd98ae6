import { BrdfError } from '../brdf/error.ts';
import type { BrdfFile, Parameter } from '../brdf/model.ts';
import { checkProgram } from './check.ts';
import type { FunctionIR, Program } from './ir.ts';
import { parseGlsl } from './parser.ts';
import { tokenize } from './tokens.ts';
import { typeNamed } from './types.ts';

/** A BRDF file whose GLSL is parsed, resolved and typed: what every back end starts from. */
export interface Model {
  readonly name: string;
  readonly file: BrdfFile;
  readonly parameters: readonly Parameter[];
  /**
   * Every function with the signature of BRDF(), BRDF first: each can be looked at alone.
   */
  readonly terms: readonly string[];
  /** Whether the file brings sampleL() and pdf() of its own. */
  readonly hasSampling: boolean;
  readonly program: Program;
  /** The term that renderers evaluate; the file's BRDF() unless multipleScatteringModel() chose another. */
  readonly main: string;
  /** Measured data, RGB triples that the GLSL reads by fetchData(int); null for a formula. */
  readonly data: Float32Array | null;
}

const DIRECTIONS = 'vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y';
/** The functions that the file format gives a meaning: result, argument types, as they must be written. */
const CONTRACT = {
  BRDF: { result: 'vec3', args: 'vec3 vec3 vec3 vec3 vec3', text: `vec3 BRDF(${DIRECTIONS})` },
  sampleL: {
    result: 'vec3',
    args: 'vec2 vec3 vec3 vec3 vec3',
    text: 'vec3 sampleL(vec2 u, vec3 V, vec3 N, vec3 X, vec3 Y)',
  },
  pdf: { result: 'float', args: 'vec3 vec3 vec3 vec3 vec3', text: `float pdf(${DIRECTIONS})` },
} as const;

/**
 * @param data measured RGB triples; the file's GLSL may then call `vec3 fetchData(int i)`
 * @throws BrdfError naming file, line and what was expected
 */
export function compileModel(file: BrdfFile, data: Float32Array | null = null): Model {
  const lines = [...file.shader.lines, ...(file.sampling?.lines ?? [])];
  const program = checkProgram(parseGlsl(tokenize({ lines })), file.parameters, {
    hasData: data !== null,
  });
  const last = file.shader.lines.at(-1) ?? { file: file.fileName, line: 1 };
  const model: Model = {
    name: file.name,
    file,
    parameters: file.parameters,
    terms: termsOf(program),
    hasSampling: file.sampling !== null,
    program,
    main: 'BRDF',
    data,
  };
  const wanted = file.sampling ? (['BRDF', 'sampleL', 'pdf'] as const) : (['BRDF'] as const);
  for (const name of wanted) {
    if (findFunction(model, name)) continue;
    const other = program.functions.find((f) => f.name === name);
    const place = other?.place ?? { file: last.file, line: last.line };
    throw new BrdfError(
      place,
      other ? `${name}() has another signature` : `there is no function ${name}()`,
      CONTRACT[name].text,
    );
  }
  checkDeclaration(model);
  return model;
}

/** What a material's switch chooses must be there when the model is read, not when somebody throws it. */
function checkDeclaration({ file, terms }: Model): void {
  const { multipleScattering } = file.declarations;
  if (multipleScattering === null || terms.includes(multipleScattering)) return;
  throw new BrdfError(
    { file: file.fileName, line: 1 },
    `the header's 'multiple scattering:' names ${multipleScattering}(), which is no term of the model`,
    terms.join(', '),
  );
}

const withScattering = new WeakMap<Model, Model>();

/** The model with its BRDF() taken from the term that has multiple scattering; itself if it has none. */
export function multipleScatteringModel(model: Model): Model {
  const main = model.file.declarations.multipleScattering;
  if (main === null) return model;
  const known = withScattering.get(model) ?? { ...model, main };
  withScattering.set(model, known);
  return known;
}

function termsOf(program: Program): string[] {
  const names = program.functions.filter((f) => matches(f, CONTRACT.BRDF)).map((f) => f.name);
  // A helper that only an include brings is no term of this model unless it has BRDF()'s arguments: then
  // it is meant to be one. Functions stand in the order of their calls; a reader expects the file's.
  return ['BRDF', ...names.filter((name) => name !== 'BRDF')];
}

function matches(f: FunctionIR, contract: { result: string; args: string }): boolean {
  const args = f.arguments.map(({ variable, qualifier }) =>
    qualifier === 'in' ? variable.type.name : qualifier,
  );
  return f.result === typeNamed(contract.result) && args.join(' ') === contract.args;
}

/** BRDF(), a term, sampleL() or pdf() of a model; undefined if it has none of that name. */
export function findFunction(model: Model, name: string): FunctionIR | undefined {
  const contract = name === 'sampleL' || name === 'pdf' ? CONTRACT[name] : CONTRACT.BRDF;
  return model.program.functions.find((f) => f.name === name && matches(f, contract));
}
