import type { SourceText } from '../brdf/model.ts';
import { checkProgram, type KernelContext } from './check.ts';
import type { FunctionIR, Program, Variable } from './ir.ts';
import { findFunction, type Model } from './model.ts';
import { parseGlsl } from './parser.ts';
import { tokenize } from './tokens.ts';

/**
 * Programs of our own that run for every pixel, on a GPU or as WebAssembly, and call models: the path tracer
 * (docs/decisions/path-tracer.md). A kernel is GLSL with `while`, variables of the invocation and memory.
 */

/** Functions and variables of one part of a kernel have numbers from a range of its own. */
const IDS_PER_PART = 1_000_000;

export interface Kernel {
  readonly program: Program;
  /** @throws RangeError if the kernel has no such function */
  entry(name: string): FunctionIR;
}

/** @param models are called as `model0_BRDF()`, `model1_pdf()` ..., after their parameters `model0_roughness` ... are set */
export function compileKernel(source: SourceText, models: readonly Model[]): Kernel {
  const programs: Program[] = [];
  const functions = new Map<string, FunctionIR>();
  const variables = new Map<string, Variable>();
  for (const [index, model] of models.entries()) {
    const { program, names } = linkModel(model, index);
    programs.push(program);
    for (const [name, f] of names) functions.set(`model${index}_${name}`, f);
    for (const variable of program.parameters) variables.set(`model${index}_${variable.name}`, variable);
  }
  const firstId = IDS_PER_PART * (2 * models.length);
  const program = check(source, [], { firstId, programs, functions, variables });
  return {
    program,
    entry(name) {
      const f = program.functions.findLast((other) => other.name === name);
      if (!f) throw new RangeError(`the kernel has no function ${name}()`);
      return f;
    },
  };
}

/** The model's program once more, with parameters that a kernel can set and data that lies in the scene. */
function linkModel(model: Model, index: number): { program: Program; names: Map<string, FunctionIR> } {
  const firstId = IDS_PER_PART * 2 * index;
  const nothing = { programs: [], functions: new Map(), variables: new Map() };
  const data = model.data && check(dataLookup(index), [], { ...nothing, firstId: firstId + IDS_PER_PART });
  const [fetchData] = data?.functions ?? [];
  const { shader, sampling } = model.file;
  const program = check({ lines: [...shader.lines, ...(sampling?.lines ?? [])] }, model.parameters, {
    firstId,
    programs: data ? [data] : [],
    functions: fetchData ? new Map([['fetchData', fetchData]]) : new Map(),
    variables: new Map(),
  });
  const names = new Map<string, FunctionIR>();
  for (const name of model.hasSampling ? ['BRDF', 'sampleL', 'pdf'] : ['BRDF']) {
    const f = findFunction({ ...model, program }, name === 'BRDF' ? model.main : name);
    if (f) names.set(name, f);
  }
  return { program, names };
}

function check(source: SourceText, parameters: Model['parameters'], kernel: KernelContext): Program {
  return checkProgram(parseGlsl(tokenize(source), true), parameters, { kernel });
}

/** fetchData() of the model of this number: its triples lie where the header's list of models says. */
function dataLookup(index: number): SourceText {
  return kernelSource(
    'fetchData',
    `vec3 fetchData(int i) {
      uvec4 table = loadUint4(int(loadUint4(9).x) + ${index});
      int word = int(table.x) + 3 * clamp(i, 0, int(table.y) - 1);
      return vec3(loadFloat(word), loadFloat(word + 1), loadFloat(word + 2));
    }`,
  );
}

/** Text of our own as a kernel's source. @param name for messages */
export function kernelSource(name: string, text: string): SourceText {
  return { lines: text.split('\n').map((line, i) => ({ text: line, file: name, line: i + 1 })) };
}
