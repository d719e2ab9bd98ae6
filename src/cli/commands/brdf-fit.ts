import { shippedModels } from '../../../models/index.ts';
import { codeSample } from '../../analysis/fit/code-sample.ts';
import { fitModel } from '../../analysis/fit/fit.ts';
import type { Parameter, ParameterValue } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import { type Command, type OptionValue, UsageError } from '../command.ts';
import { checkOutput, writeOutput } from '../files.ts';
import { fitTable } from '../fit-table.ts';
import { modelArgument, modelFiles } from '../model-argument.ts';
import { progressLine } from '../progress.ts';

const command: Command = {
  usage: 'brdf fit TARGET --model MODEL|FILE',
  summary: 'Parameters with which one model reproduces another, or a measured material.',
  details: [
    "Searches the parameters' ranges from several starts, under several metrics, and takes the fit whose lit",
    'sphere looks most like the target. docs/fit.md explains the figures.',
    '',
    `  TARGET             a model that ships, ${modelFiles}`,
    '  --model            what is fitted: a model that ships, or a .brdf file',
    '  --parameters JSON  values for the parameters of TARGET: \'{"roughness": 0.3}\'',
    '  --fix NAME=VALUE   a parameter of the model that keeps a value; a colour is r,g,b. Can be given again.',
    '  --seed N           of the search, which is the same for the same seed; 1 is the default',
    '  --json             as JSON: {"model", "parameters", "errors": {"cubeRoot", "look"}, "defaults", "size",',
    '                     "metric", "candidates", "numbers": [{"name", "value", "play", "bound"}], "loose"}',
    '  -o FILE            writes the material as documents have it: {"name", "model", "parameters"}',
  ],
  options: {
    model: { type: 'string' },
    parameters: { type: 'string', default: '{}' },
    fix: { type: 'string', multiple: true },
    seed: { type: 'string', default: '1' },
    json: { type: 'boolean' },
    output: { type: 'string', short: 'o' },
  },
  arguments: { least: 1, most: 1 },
  async run({ arguments: [word = ''], options }) {
    if (typeof options.model !== 'string') throw new UsageError('brdf fit: --model names what is fitted');
    const target = { model: modelArgument(word), parameters: targetParameters(options.parameters) };
    const model = modelArgument(options.model);
    const { json, output } = options;
    if (typeof output === 'string') checkOutput(output, `-o ${output}`);
    const line = progressLine(!json);
    const fit = await fitModel(target, model, {
      seed: seedOf(options.seed),
      fixed: fixedValues(model, options.fix),
      onProgress: (done, error) => line(done, Number.isFinite(error) ? `error ${error.toPrecision(3)}` : ''),
    });
    if (typeof output === 'string') {
      const material = { name: target.model.name, model: model.name, parameters: fit.parameters };
      writeOutput(output, `-o ${output}`, Buffer.from(`${JSON.stringify(material, null, 2)}\n`));
    }
    if (json) console.log(JSON.stringify(fit, null, 2));
    else {
      const code = codeSample(
        model,
        fit.parameters,
        shippedModels.get(model.name)?.file.fileName === model.file.fileName,
      );
      console.log([...fitTable(fit, target.model.name, model.parameters), '', code.trimEnd()].join('\n'));
    }
    return 0;
  },
};

export default command;

function targetParameters(text: OptionValue): Record<string, unknown> {
  let value: unknown;
  try {
    value = JSON.parse(String(text));
  } catch (cause) {
    throw new UsageError(`--parameters: not JSON: ${(cause as Error).message}`);
  }
  if (typeof value === 'object' && value !== null && !Array.isArray(value))
    return value as Record<string, unknown>;
  throw new UsageError('--parameters: expected an object such as {"roughness": 0.3}');
}

function seedOf(text: OptionValue): number {
  const seed = Number(text);
  if (Number.isSafeInteger(seed) && seed >= 0) return seed;
  throw new UsageError(`--seed ${text}: expected a whole number`);
}

function fixedValues(model: Model, given: OptionValue): Record<string, ParameterValue> {
  const words = Array.isArray(given) ? given.map(String) : [];
  return Object.fromEntries(
    words.map((word) => {
      const [name = '', text = ''] = word.split(/=(.*)/s).map((part) => part.trim());
      const parameter = model.parameters.find((candidate) => candidate.name === name);
      if (!parameter) {
        const names = model.parameters.map((candidate) => candidate.name).join(', ');
        throw new UsageError(`--fix ${word}: ${model.name} has no parameter '${name}'; it has ${names}`);
      }
      return [name, parameterValue(parameter, text, word)];
    }),
  );
}

function parameterValue({ type }: Parameter, text: string, word: string): ParameterValue {
  if (type === 'bool') {
    if (/^(true|1)$/.test(text)) return true;
    if (/^(false|0)$/.test(text)) return false;
    throw new UsageError(`--fix ${word}: expected true or false`);
  }
  const numbers = text.split(/[\s,]+/).map((part) => (part === '' ? Number.NaN : Number(part)));
  const [r = 0, g = 0, b = 0] = numbers;
  if (!numbers.every(Number.isFinite) || numbers.length !== (type === 'color' ? 3 : 1))
    throw new UsageError(`--fix ${word}: expected ${type === 'color' ? 'three numbers, r,g,b' : 'a number'}`);
  return type === 'color' ? [r, g, b] : r;
}
