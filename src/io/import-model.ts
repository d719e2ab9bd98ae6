/** Model files of any format that is read here, into a document. */
import type { AssetLoader } from '../scene/assets.ts';
import { Notes } from './gltf/notes.ts';
import { type ImportedModel, type ImportOptions, importConverted, importGltf } from './gltf.ts';
import { companionsFrom } from './meshes/companions.ts';
import { convertObj, convertPly, convertStl } from './meshes/convert.ts';
import { ModelFileError } from './meshes/error.ts';
import { modelExtensions } from './model-extensions.ts';
import { readObjectScene } from './object-scene/read.ts';
import { isObjectScene } from './object-scene/schema.ts';

const fileName = (path: string): string => path.replace(/^.*[/\\]/, '');

/**
 * Reads, checks and decodes all of a model before there is a recipe to apply: a broken file changes nothing.
 *
 * @throws GltfError, ModelFileError or ByteError, which name the file and the place in it
 */
export async function importModel(
  bytes: Uint8Array,
  path: string,
  assets: AssetLoader,
  { companions: all = new Map(), ...options }: ImportOptions = {},
): Promise<ImportedModel> {
  const file = fileName(path);
  const extension = /\.([a-z0-9]+)$/i.exec(file)?.[1]?.toLowerCase();
  const companions = companionsFrom(path, all);
  if (extension === 'glb' || extension === 'gltf')
    return importGltf(bytes, file, assets, { companions, ...options });
  const { onProgress } = options;
  const notes = new Notes();
  switch (extension) {
    case 'obj':
      return importConverted(convertObj(bytes, file, companions, notes), file, assets, notes, onProgress);
    case 'ply':
      return importConverted(convertPly(bytes, file, notes), file, assets, notes, onProgress);
    case 'stl':
      return importConverted(convertStl(bytes, file), file, assets, notes, onProgress);
    default:
      throw new ModelFileError(file, '', `not a kind of model that is read: ${modelExtensions.join(', ')}`);
  }
}

/** A three.js scene whose JSON is parsed already; null if it is something else. */
export async function importObjectScene(
  json: unknown,
  path: string,
  assets: AssetLoader,
  { companions: all = new Map(), onProgress }: ImportOptions = {},
): Promise<ImportedModel | null> {
  if (!isObjectScene(json)) return null;
  const file = fileName(path);
  const companions = companionsFrom(path, all);
  const notes = new Notes();
  return importConverted(readObjectScene(json, file, companions, notes), file, assets, notes, onProgress);
}
