/** Two materials on the same objects: A, which the scene has, and B in its place. It is no part of the document. */
import type { MaterialFile } from '../../io/material-file.ts';
import { carriedLook } from '../../scene/carried-look.ts';
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

/** Why there is nothing to compare: A or B has gone, or no object has A any more. Null if there is. */
export function missingOf(document: Document, { material, other }: Comparison): 'A' | 'B' | 'objects' | null {
  if (!Object.hasOwn(document.materials, material)) return 'A';
  if (other.kind === 'scene' && !Object.hasOwn(document.materials, other.id)) return 'B';
  const isUsed = Object.values(document.objects).some((object) => object.material === material);
  return isUsed ? null : 'objects';
}

/** A with another model, which has of its look what a change of the model leaves. */
export function withModel(document: Document, material: Material, model: string): MaterialFile {
  const [before, after] = [findModel(document, material.model), findModel(document, model)];
  const changed = { ...material, model, ...carriedLook(before, after, material) };
  return { material: changed, models: document.models, assets: document.assets };
}

/** The models that a material can be compared under. */
export const otherModels = (document: Document, material: Material): string[] =>
  modelNames(document).filter((name) => name !== material.model);
