import { checkModel, type GpuEvaluation } from '../../analysis/verdict/verdict.ts';
import type { Model } from '../../glsl/model.ts';
import { type Command, UsageError } from '../command.ts';
import { writeHeatMap } from '../heat-map-file.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';
import { progressLine } from '../progress.ts';
import { verdictTable } from '../verdict-table.ts';

const command: Command = {
  usage: 'brdf check MODEL|FILE [--json] [--backend cpu|gpu] [--map A,B -o FILE]',
  summary: 'Holds a model to physics: energy, reciprocity, its sampler and more.',
  details: [
    'Searches all parameters and directions for the worst case of each law, and says what it means. The exit',
    "code is 1 when a law is broken that the model's header does not give up, such as by `# gives up: energy`.",
    'docs/verdict.md explains each law.',
    '',
    '  MODEL       a model that ships; `irradia brdf list` names them',
    `  FILE        ${modelFiles}`,
    '  --json      as JSON: {"model", "sound", "checks": [{"property", "outcome", "figure", "figureText",',
    '              "sentence", "worst": {"term", "parameters", "l", "v"}}]}',
    '  --backend   gpu: compares a GPU, or the software one, with float64 as well; cpu is the default',
    '  --map       instead of the verdict, a map of one law over two parameters: their names with a comma, or main',
    '              for those that matter most. The others are at their defaults, colours white.',
    '  --law       of the map: energy, the largest albedo (the default), or reciprocity',
    '  -o FILE     of the map: .svg, .png or .csv',
  ],
  options: {
    json: { type: 'boolean' },
    backend: { type: 'string', default: 'cpu' },
    map: { type: 'string' },
    law: { type: 'string', default: 'energy' },
    output: { type: 'string', short: 'o' },
  },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options: { json, backend, map, law, output } }) {
    const model = modelArgument(word);
    if (typeof map === 'string') {
      console.log(await writeHeatMap(model, { axes: map, law, output }));
      return 0;
    }
    if (output !== undefined) throw new UsageError('-o is for --map');
    if (backend !== 'cpu' && backend !== 'gpu')
      throw new UsageError(`--backend ${backend}: expected cpu or gpu`);
    const gpu = backend === 'gpu' ? await askedGpu(model) : null;
    const verdict = await checkModel(model, { ...(gpu && { gpu }), onProgress: progressLine(!json) });
    console.log(json ? JSON.stringify(verdict, null, 2) : verdictTable(verdict, model.parameters).join('\n'));
    return verdict.sound ? 0 : 1;
  },
};

export default command;

async function askedGpu(model: Model): Promise<GpuEvaluation> {
  const { gpuBackend } = await import('../eval/gpu.ts');
  const backend = await gpuBackend(model);
  return (term, points) => backend(term)(points);
}
