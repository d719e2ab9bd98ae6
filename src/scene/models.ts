/** The models that a document can use: those that ship, and its own under `models`. */

import { loadModel, shippedModels } from '../../models/index.ts';
import { BrdfError } from '../brdf/error.ts';
import type { Model } from '../glsl/model.ts';
import type { Document, ModelSource } from './schema.ts';

type WithModels = Pick<Document, 'models'>;

/** Compiled once per source: documents share the entries that did not change. */
const compiled = new WeakMap<ModelSource, Map<string, Model | BrdfError>>();

function compileEmbedded(name: string, entry: ModelSource): Model | BrdfError {
  const byName = compiled.get(entry) ?? new Map<string, Model | BrdfError>();
  compiled.set(entry, byName);
  const known = byName.get(name);
  if (known !== undefined) return known;
  const result = tryLoad(entry.source, `${name}.brdf`);
  byName.set(name, result);
  return result;
}

function tryLoad(source: string, fileName: string): Model | BrdfError {
  try {
    return loadModel(source, fileName);
  } catch (error) {
    if (error instanceof BrdfError) return error;
    throw error;
  }
}

/**
 * The model of that name, or undefined. A document's own model comes before a shipped one: a
 * later Irradia that ships a model of the same name must not change what the document shows.
 * Throws BrdfError if the document's own model is broken.
 */
export function findModel(document: WithModels, name: string): Model | undefined {
  const entry = Object.hasOwn(document.models, name) ? document.models[name] : undefined;
  if (entry === undefined) return shippedModels.get(name);
  const model = compileEmbedded(name, entry);
  if (model instanceof BrdfError) throw model;
  return model;
}

/** What is wrong with a document's own model: file, line and fault; null if it compiles. */
export function modelFault(name: string, entry: ModelSource): string | null {
  const model = compileEmbedded(name, entry);
  return model instanceof BrdfError ? model.message : null;
}

/** The names of all models that a document's materials can have, the document's own first. */
export function modelNames(document: WithModels): string[] {
  return [...new Set([...Object.keys(document.models), ...shippedModels.keys()])];
}
