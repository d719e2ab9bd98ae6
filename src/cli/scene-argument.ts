import { existsSync } from 'node:fs';
import { loadScene, sceneNames } from '../../scenes/index.ts';
import { isModelFile } from '../io/model-extensions.ts';
import { isObjectScene } from '../io/object-scene/schema.ts';
import { isZip } from '../io/zip.ts';
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';
import { CliError } from './command.ts';
import { readInput } from './files.ts';

export interface SceneArgument {
  document: Document;
  /** Its name, if it is one that ships. */
  shipped: string | null;
  /** What a model of another format has that a document has not. */
  notes: readonly string[];
}

/** The document that SCENE means: one that ships, by its name, or a file, which may be a model. */
export async function sceneArgument(word: string): Promise<SceneArgument> {
  if (sceneNames.includes(word)) return { document: await loadScene(word), shipped: word, notes: [] };
  if (existsSync(word)) return { ...(await sceneOfFile(word)), shipped: null };
  throw new CliError(
    `there is no scene '${word}' and no such file; scenes that ship: ${sceneNames.join(', ')}`,
  );
}

async function sceneOfFile(path: string): Promise<Omit<SceneArgument, 'shipped'>> {
  const bytes = readInput(path);
  const isModel = isModelFile(path) || isZip(path);
  const text = isModel ? '' : bytes.toString('utf8');
  const json = isModel ? null : parsed(text);
  if (!isModel && !isObjectScene(json)) return { document: parseDocument(json ?? text, path), notes: [] };
  // three.js is loaded only where it is needed.
  return (await import('./model-file.ts')).readModelFile(path, bytes, json);
}

/** Null for what is not JSON: the document's own parser says where it ends to be that. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
