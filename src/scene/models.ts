/** The models that a document can use: those that ship, and its own under `models`. */

import { loadModel, shippedModels } from '../../models/index.ts';
import { BrdfError } from '../brdf/error.ts';
import type { Model } from '../glsl/model.ts';
import { ByteError } from '../io/bytes.ts';
import { decodeBase64 } from './base64.ts';
import { shortened } from './error.ts';
import { loadMeasured } from './measured.ts';
import type { Asset, Document, ModelSource } from './schema.ts';

type WithModels = Pick<Document, 'models' | 'assets'>;
type Fault = BrdfError | ByteError;

/** Compiled once per source or file: documents share the entries that did not change. */
const compiled = new WeakMap<ModelSource | Asset, Map<string, Model | Fault>>();

/** Undefined if the file that a measured model names is not there. */
function compileEmbedded(document: WithModels, name: string): Model | Fault | undefined {
  const entry = document.models[name] as ModelSource;
  const origin = 'source' in entry ? entry : measurements(document, entry.measured);
  if (origin === undefined) return undefined;
  // One model for all names of a file of measurements: its samples are megabytes.
  const key = 'source' in origin ? `${name}.brdf` : origin.name;
  const byName = compiled.get(origin) ?? new Map<string, Model | Fault>();
  compiled.set(origin, byName);
  const known = byName.get(key);
  if (known !== undefined) return known;
  const result = tryLoad(origin, key);
  byName.set(key, result);
  return result;
}

function measurements({ assets }: WithModels, id: string): Asset | undefined {
  return Object.hasOwn(assets, id) ? assets[id] : undefined;
}

function tryLoad(origin: { readonly source: string } | Asset, fileName: string): Model | Fault {
  try {
    if ('source' in origin) return loadModel(origin.source, fileName);
    return loadMeasured(decodeBase64(origin.data), fileName);
  } catch (error) {
    if (error instanceof BrdfError || error instanceof ByteError) return error;
    throw error;
  }
}

/**
 * The model of that name, or undefined. A document's own model comes before a shipped one: a
 * later Irradia that ships a model of the same name must not change what the document shows.
 * Throws BrdfError, or ByteError for measurements, if the document's own model is broken.
 */
export function findModel(document: WithModels, name: string): Model | undefined {
  if (!Object.hasOwn(document.models, name)) return shippedModels.get(name);
  const model = compileEmbedded(document, name);
  if (model instanceof Error) throw model;
  return model;
}

/** What is wrong with a document's own model: file, place and fault; null if it compiles. */
export function modelFault(document: WithModels, name: string): string | null {
  const model = compileEmbedded(document, name);
  if (model !== undefined) return model instanceof Error ? model.message : null;
  const entry = document.models[name] as { measured: string };
  return `there is no asset "${shortened(entry.measured)}"`;
}

/** What a document's own model is made from, the same object as long as it stays the same. */
export function modelOrigin(
  document: WithModels,
  name: string,
): { readonly source: string } | Asset | undefined {
  const entry = document.models[name];
  return entry === undefined || 'source' in entry ? entry : measurements(document, entry.measured);
}

/** The names of all models that a document's materials can have, the document's own first. */
export function modelNames(document: WithModels): string[] {
  return [...new Set([...Object.keys(document.models), ...shippedModels.keys()])];
}
