/** Model files as documents, for commands that take scenes. */
import { existsSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { addImported, type ImportedModel } from '../io/gltf.ts';
import { importModel, importObjectScene } from '../io/import-model.ts';
import { pathIn } from '../io/meshes/companions.ts';
import { referencesOf } from '../io/meshes/references.ts';
import { isModelFile, modelExtensions } from '../io/model-extensions.ts';
import { lightByFile, modelStage } from '../io/stage.ts';
import { isZip, readZip } from '../io/zip.ts';
import { AssetLoader } from '../scene/assets.ts';
import type { Document } from '../scene/schema.ts';
import { DocumentStore } from '../scene/store.ts';
import { CliError } from './command.ts';
import { readInput } from './files.ts';
import { nodeAssets } from './node-assets.ts';

export interface SceneFile {
  document: Document;
  /** What could not be kept. */
  notes: readonly string[];
}

/** A model by itself, under light from all around. @param json what is in a scene of three.js */
export async function readModelFile(path: string, bytes: Buffer, json: unknown): Promise<SceneFile> {
  if (isZip(path)) return readArchive(bytes, basename(path));
  const companions = companionsOf(path, bytes);
  if (isModelFile(path)) return staged(basename(path), bytes, companions);
  const imported = await importObjectScene(json, basename(path), new AssetLoader(nodeAssets), { companions });
  if (imported === null) throw new CliError(`${path}: not a model`);
  return onStage(basename(path), imported);
}

async function readArchive(bytes: Uint8Array, name: string): Promise<SceneFile> {
  const files = readZip(bytes, name);
  const main = modelExtensions
    .flatMap((extension) => [...files.keys()].filter((path) => path.toLowerCase().endsWith(`.${extension}`)))
    .at(0);
  if (main === undefined)
    throw new CliError(`${name}: there is no model in it: ${modelExtensions.join(', ')}`);
  return staged(main, files.get(main) as Uint8Array, files);
}

async function staged(
  path: string,
  bytes: Uint8Array,
  companions: ReadonlyMap<string, Uint8Array>,
): Promise<SceneFile> {
  return onStage(basename(path), await importModel(bytes, path, new AssetLoader(nodeAssets), { companions }));
}

function onStage(name: string, imported: ImportedModel): SceneFile {
  const store = new DocumentStore(modelStage(name));
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
    lightByFile(draft, imported);
  });
  return { document: store.document, notes: imported.notes };
}

/** The files that a model names, as far as they lie where it says, and those that these name. */
function companionsOf(path: string, bytes: Uint8Array): Map<string, Uint8Array> {
  const found = new Map<string, Uint8Array>();
  const pending = referencesOf(path, bytes);
  for (let reference = pending.pop(); reference !== undefined; reference = pending.pop()) {
    const name = pathIn(reference);
    const file = join(dirname(path), name);
    if (found.has(name) || !existsSync(file)) continue;
    const content = readInput(file);
    found.set(name, content);
    pending.push(...referencesOf(name, content));
  }
  return found;
}
