/** A model's source in the document, as it is being written. */
import { loadModel, modelSources } from '../../../../models/index.ts';
import { BrdfError } from '../../../brdf/error.ts';
import type { Model } from '../../../glsl/model.ts';
import { modelNameFor } from '../../../scene/material-commands.ts';
import { findModel } from '../../../scene/models.ts';
import type { Document } from '../../../scene/schema.ts';
import type { DocumentStore, Draft } from '../../../scene/store.ts';
import { t } from '../../language/language.ts';

export interface SourceFault {
  /** 1 is the first line of the text. */
  readonly line: number;
  readonly column: number | undefined;
  readonly message: string;
}

/** The text of a document's own model, or of one that ships; null where it is none (measurements). */
export function sourceOf(document: Document, name: string): string | null {
  const entry = Object.hasOwn(document.models, name) ? document.models[name] : undefined;
  if (entry) return 'source' in entry ? entry.source : null;
  return modelSources.get(`${name}.brdf`) ?? null;
}

export const isOwn = (document: Document, name: string): boolean => Object.hasOwn(document.models, name);

/** A copy in the document of a model that ships, and the material with it: one undo step. Returns its name. */
export function copyShipped(store: DocumentStore, material: string): string {
  const { model } = store.document.materials[material] ?? { model: '' };
  const source = sourceOf(store.document, model);
  if (source === null) throw new Error(t('{model} has no source that could be edited', { model }));
  const name = modelNameFor(store, `${model}.brdf`);
  store.edit(t('Copy {model} to edit it', { model }), (draft) => {
    draft.models[name] = { source };
    const target = draft.materials[material];
    if (target) target.model = name;
  });
  return name;
}

/** The fault in a text, at a line of it; null if it compiles. */
export function faultOf(text: string, name: string): SourceFault | null {
  const file = `${name}.brdf`;
  try {
    loadModel(text, file);
    return null;
  } catch (error) {
    if (!(error instanceof BrdfError)) throw error;
    const own = error.file === file;
    return {
      // What is wrong in an included file is shown where it is included.
      line: own ? error.line : includeLine(text, error.file),
      column: own ? error.column : undefined,
      message: own ? error.message.replace(/^[^:]*(:\d+)+: /, '') : error.message,
    };
  }
}

function includeLine(text: string, path: string): number {
  const lines = text.split('\n');
  const at = lines.findIndex((line) => line.startsWith('::include') && line.includes(path));
  return at < 0 ? Math.max(1, lines.findIndex((line) => line.startsWith('::include')) + 1) : at + 1;
}

/**
 * Values of parameters that went away while somebody typed: they come back when the parameter does, so that a
 * moment without its line loses nothing.
 */
export type Remembered = Map<string, unknown>;

/** Puts a text that compiles into the document; materials lose what their model no longer has. */
export function applySource(
  store: DocumentStore,
  name: string,
  source: string,
  merge: string,
  remembered: Remembered,
): void {
  const next = loadModel(source, `${name}.brdf`);
  const before = findModel(store.document, name);
  store.edit(
    t('Edit {name}', { name }),
    (draft) => {
      draft.models[name] = { source };
      for (const [id, material] of Object.entries(draft.materials)) {
        if (material.model === name) fitMaterial(draft, id, before, next, remembered);
      }
    },
    { merge },
  );
}

function fitMaterial(
  draft: Draft,
  id: string,
  before: Model | undefined,
  next: Model,
  remembered: Remembered,
): void {
  const material = draft.materials[id];
  if (!material) return;
  const { parameters, textures } = material;
  const typeIn = (model: Model | undefined, name: string) =>
    model?.parameters.find((parameter) => parameter.name === name)?.type;
  for (const collection of [parameters, textures] as Record<string, unknown>[]) {
    const kind = collection === parameters ? 'value' : 'texture';
    for (const [name, value] of Object.entries(collection)) {
      const type = typeIn(before, name);
      if (type === typeIn(next, name)) continue;
      remembered.set([id, kind, name, type].join('\n'), structuredClone(value));
      delete collection[name];
    }
    for (const { name, type } of next.parameters) {
      const key = [id, kind, name, type].join('\n');
      if (name in collection || !remembered.has(key)) continue;
      collection[name] = remembered.get(key);
      remembered.delete(key);
    }
  }
  const { term } = draft.view;
  if (term?.material === id && !next.terms.includes(term.name)) draft.view.term = null;
}
