import { existsSync } from 'node:fs';
import { loadModel, shippedModels } from '../../models/index.ts';
import type { Model } from '../glsl/model.ts';
import { loadMeasured } from '../scene/measured.ts';
import { CliError } from './command.ts';
import { readInput } from './files.ts';

/** Whether a file's ending says that it holds measurements. */
export const isMeasured = (word: string): boolean => /\.binary$/i.test(word);

/** The model that MODEL|FILE means: one that ships, by its name, or a .brdf or .binary file. */
export function modelArgument(word: string): Model {
  const shipped = shippedModels.get(word);
  if (shipped) return shipped;
  if (existsSync(word)) {
    const bytes = readInput(word);
    return isMeasured(word) ? loadMeasured(bytes, word) : loadModel(bytes.toString('utf8'), word);
  }
  const names = [...shippedModels.keys()].join(', ');
  throw new CliError(`there is no model '${word}' and no such file; models that ship: ${names}`);
}
