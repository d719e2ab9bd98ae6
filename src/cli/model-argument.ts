import { existsSync, readFileSync } from 'node:fs';
import { loadModel, shippedModels } from '../../models/index.ts';
import type { Model } from '../glsl/model.ts';
import { CliError } from './command.ts';

/** The model that MODEL|FILE means: one that ships, by its name, or a .brdf file. */
export function modelArgument(word: string): Model {
  const shipped = shippedModels.get(word);
  if (shipped) return shipped;
  if (existsSync(word)) return loadModel(readFileSync(word, 'utf8'), word);
  const names = [...shippedModels.keys()].join(', ');
  throw new CliError(`there is no model '${word}' and no such file; models that ship: ${names}`);
}
