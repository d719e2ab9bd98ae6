import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { shippedModels } from '../../models/index.ts';
import type { Parameter, ParameterValue } from '../brdf/model.ts';
import type { Model } from '../glsl/model.ts';
import { readBparam, savedValues } from '../io/bparam.ts';
import { CliError } from './command.ts';

export const isSaved = (word: string): boolean => /\.bparam$/i.test(word);

/**
 * The model that a .bparam file names, with the saved values for defaults. Its .brdf file is looked for
 * beside it, and then among the models that ship.
 *
 * @param load the model of that name or file
 */
export function savedModel(text: string, fileName: string, load: (word: string) => Model): Model {
  const saved = readBparam(text, fileName);
  const beside = join(dirname(fileName), saved.source);
  const found = existsSync(beside);
  if (!found && !shippedModels.has(saved.model)) {
    throw new CliError(
      `${fileName} has values for ${saved.source}; there is no such file beside it, and no model ` +
        `'${saved.model}' ships`,
    );
  }
  const model = load(found ? beside : saved.model);
  const { values, unknown } = savedValues(saved, model.parameters);
  if (unknown.length > 0)
    process.stderr.write(`${fileName}: ${model.name} has no such parameters: ${unknown.join(', ')}\n`);
  const parameters = model.parameters.map((parameter) => withDefault(parameter, values[parameter.name]));
  return { ...model, parameters, file: { ...model.file, parameters } };
}

function withDefault(parameter: Parameter, value: ParameterValue | undefined): Parameter {
  // savedValues() has matched the types.
  return value === undefined ? parameter : ({ ...parameter, default: value } as Parameter);
}
