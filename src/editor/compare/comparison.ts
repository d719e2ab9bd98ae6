/** Two materials on the same objects: A, which the scene has, and B in its place. It is no part of the document. */
import type { MaterialFile } from '../../io/material-file.ts';
import { findModel, modelNames } from '../../scene/models.ts';
import type { Document, Material } from '../../scene/schema.ts';
import type { Offer } from '../panels/library/chosen.ts';

export interface Comparison {
  /** A: the id of a material of the document. */
  readonly material: string;
  /** B: a material that is offered, or A with another model. */
  readonly other: Offer | { readonly kind: 'model'; readonly model: string };
  /** B's name. */
  readonly title: string;
}

/** A with another model: the values that both know by name and type, as for a change of the model. */
export function withModel(document: Document, material: Material, model: string): MaterialFile {
  const [before, after] = [findModel(document, material.model), findModel(document, model)];
  const typeIn = (of: typeof before, name: string) =>
    of?.parameters.find((parameter) => parameter.name === name)?.type;
  const kept = <T>(values: Readonly<Record<string, T>>): Record<string, T> =>
    Object.fromEntries(
      Object.entries(values).filter(([name]) => {
        const type = typeIn(after, name);
        return type !== undefined && type === typeIn(before, name);
      }),
    );
  const changed = {
    ...material,
    model,
    parameters: kept(material.parameters),
    textures: kept(material.textures),
  };
  return { material: changed, models: document.models, assets: document.assets };
}

/** The models that a material can be compared under. */
export const otherModels = (document: Document, material: Material): string[] =>
  modelNames(document).filter((name) => name !== material.model);
