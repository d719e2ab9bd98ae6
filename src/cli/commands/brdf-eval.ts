import type { Rgb } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import { type Call, type Command, UsageError } from '../command.ts';
import { cpuBackend } from '../eval/cpu.ts';
import { type Backend, parseQuery, type Query } from '../eval/query.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';

const command: Command = {
  usage: 'brdf eval MODEL|FILE [--backend cpu|gpu] [--term NAME]',
  summary: 'Values of a model, for directions and parameters read as lines of JSON.',
  details: [
    'Reads from standard input, one query a line:',
    '  {"parameters": {"roughness": 0.3}, "l": [0, 0, 1], "v": [0.6, 0, 0.8]}',
    'and writes a line {"f": [r, g, b]} for each, in 1/sr without the cosine. The normal is +z, the tangent +x,',
    'the bitangent +y; l and v are unit vectors that point away from the surface: one whose length is within',
    '1 % of 1 is normalised, any other is an error. Parameters that are not named take their defaults; a colour',
    'is an array of 3 linear numbers. A bad line gets {"error": "..."} in its place, and the exit code is 1.',
    '',
    '  MODEL       a model that ships; `irradia brdf list` names them',
    `  FILE        ${modelFiles}`,
    '  --backend   cpu: 64-bit floats (the default); gpu: 32-bit floats, a GPU or the software one',
    '  --term      one term of the model instead of all of it; `irradia brdf show` names them',
  ],
  options: { backend: { type: 'string', default: 'cpu' }, term: { type: 'string', default: 'BRDF' } },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options }) {
    const model = modelArgument(word);
    const backend = await chooseBackend(model, options);
    let allGood = true;
    for await (const lines of linesOf(process.stdin)) {
      const answers = await answerLines(lines, model, backend);
      allGood &&= answers.every((answer) => 'f' in answer);
      await write(answers.map((answer) => `${JSON.stringify(answer)}\n`).join(''));
    }
    return allGood ? 0 : 1;
  },
};

export default command;

type Answer = { f: Rgb } | { error: string };

async function chooseBackend(model: Model, { backend, term }: Call['options']): Promise<Backend> {
  if (!model.terms.includes(term as string)) {
    throw new UsageError(`${model.name} has no term '${term}'; it has ${model.terms.join(', ')}`);
  }
  if (backend === 'cpu') return cpuBackend(model, term as string);
  if (backend !== 'gpu') throw new UsageError(`--backend ${backend}: expected cpu or gpu`);
  const { gpuBackend } = await import('../eval/gpu.ts');
  return (await gpuBackend(model))(term as string);
}

async function answerLines(lines: readonly string[], model: Model, backend: Backend): Promise<Answer[]> {
  const queries: Query[] = [];
  const answers = lines.map((line): Answer | null => {
    try {
      queries.push(parseQuery(line, model));
      return null;
    } catch (error) {
      return { error: (error as Error).message };
    }
  });
  const values = (await backend(queries)).values();
  return answers.map((answer) => answer ?? answerOf(values.next().value as Rgb));
}

/** JSON has no infinities; a model that gives one is at fault at that place. */
function answerOf(f: Rgb): Answer {
  return f.every(Number.isFinite) ? { f } : { error: `the model's value is not finite: [${f.join(', ')}]` };
}

/** The lines that came together, as soon as they came: one who asks line by line is answered line by line. */
async function* linesOf(stream: NodeJS.ReadableStream): AsyncGenerator<string[]> {
  let rest = '';
  stream.setEncoding('utf8');
  for await (const chunk of stream) {
    const lines = (rest + chunk).split('\n');
    rest = lines.pop() as string;
    if (lines.length) yield lines;
  }
  if (rest) yield [rest];
}

/** Waits until the reader took it, so that a fast writer cannot fill the memory with answers. */
function write(text: string): Promise<void> {
  return new Promise((resolve) => {
    if (process.stdout.write(text)) resolve();
    else process.stdout.once('drain', resolve);
  });
}
