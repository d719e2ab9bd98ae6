import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';
import { CliError } from './command.ts';
import { packageRoot } from './package-root.ts';

const folder = join(packageRoot, 'scenes');

/** The scenes that ship, as documents in the folder scenes. */
export function shippedScenes(): string[] {
  const files = existsSync(folder) ? readdirSync(folder) : [];
  return files.filter((file) => file.endsWith('.json')).map((file) => file.slice(0, -'.json'.length));
}

export interface SceneArgument {
  document: Document;
  /** Its name, if it is one that ships. */
  shipped: string | null;
}

/** The document that SCENE means: one that ships, by its name, or a file. */
export function sceneArgument(word: string): SceneArgument {
  const shipped = shippedScenes().includes(word) ? word : null;
  const file = shipped ? join(folder, `${shipped}.json`) : word;
  if (!existsSync(file)) {
    const names = shippedScenes().join(', ');
    throw new CliError(`there is no scene '${word}' and no such file; scenes that ship: ${names}`);
  }
  return { document: parseDocument(readFileSync(file, 'utf8'), shipped ?? word), shipped };
}
