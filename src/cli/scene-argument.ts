import { existsSync } from 'node:fs';
import { loadScene, sceneNames } from '../../scenes/index.ts';
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';
import { CliError } from './command.ts';
import { readInput } from './files.ts';

export interface SceneArgument {
  document: Document;
  /** Its name, if it is one that ships. */
  shipped: string | null;
}

/** The document that SCENE means: one that ships, by its name, or a file. */
export async function sceneArgument(word: string): Promise<SceneArgument> {
  if (sceneNames.includes(word)) return { document: await loadScene(word), shipped: word };
  if (existsSync(word))
    return { document: parseDocument(readInput(word).toString('utf8'), word), shipped: null };
  throw new CliError(
    `there is no scene '${word}' and no such file; scenes that ship: ${sceneNames.join(', ')}`,
  );
}
