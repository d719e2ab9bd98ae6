import { existsSync } from 'node:fs';
import { loadModel, shippedModels } from '../../models/index.ts';
import type { Model } from '../glsl/model.ts';
import { isMeasuredFile, loadMeasured, measuredKinds } from '../scene/measured.ts';
import { CliError } from './command.ts';
import { readInput } from './files.ts';
import { isSaved, savedModel } from './saved-model.ts';

/** The files that modelArgument() takes, for `--help`. */
export const modelFiles = `a .brdf file, saved parameters (.bparam), or measurements: ${measuredKinds}`;

/** The model that MODEL|FILE means: one that ships, by its name, or a file's. */
export function modelArgument(word: string): Model {
  const shipped = shippedModels.get(word);
  if (shipped) return shipped;
  if (existsSync(word)) {
    const bytes = readInput(word);
    if (isMeasuredFile(word)) return loadMeasured(bytes, word);
    const text = bytes.toString('utf8');
    return isSaved(word) ? savedModel(text, word, modelArgument) : loadModel(text, word);
  }
  const names = [...shippedModels.keys()].join(', ');
  throw new CliError(`there is no model '${word}' and no such file; models that ship: ${names}`);
}
