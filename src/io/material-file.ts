/**
 * A material as a file of its own: with the models, images and measurements that it needs. Its parts are those of a
 * document, and are checked as those are.
 */
import { keepAsset } from '../scene/commands.ts';
import { parseDocument } from '../scene/document.ts';
import { entity } from '../scene/entity.ts';
import { DocumentError } from '../scene/error.ts';
import { putMaterial } from '../scene/material-commands.ts';
import { materialMaps } from '../scene/material-schema.ts';
import { modelNames } from '../scene/models.ts';
import { freeName } from '../scene/names.ts';
import {
  type Asset,
  type Document,
  documentVersion,
  type Material,
  type ModelSource,
} from '../scene/schema.ts';
import type { Draft } from '../scene/store.ts';
import { assetsOf } from '../scene/validate.ts';

const FORMAT = 'irradia-material';

export interface MaterialFile {
  material: Material;
  models: Readonly<Record<string, ModelSource>>;
  assets: Readonly<Record<string, Asset>>;
}

export const isMaterialFile = (json: unknown): boolean =>
  (json as { format?: unknown } | null)?.format === FORMAT;

export function writeMaterialFile(document: Document, id: string): string {
  const material = entity(document, 'materials', id);
  const models: Record<string, ModelSource> = {};
  const names = new Set(assetsOf(material).map(([, asset]) => asset));
  const model = Object.hasOwn(document.models, material.model) ? document.models[material.model] : undefined;
  if (model !== undefined) {
    models[material.model] = model;
    if ('measured' in model) names.add(model.measured);
  }
  const assets = Object.fromEntries([...names].map((name) => [name, entity(document, 'assets', name)]));
  return `${JSON.stringify({ format: FORMAT, version: documentVersion, material, models, assets }, null, 2)}\n`;
}

/** @throws DocumentError with the path of the field that is wrong */
export function readMaterialFile(json: unknown, file: string): MaterialFile {
  const { version, material, models = {}, assets = {} } = json as Record<string, unknown>;
  const document = parseDocument(
    { format: 'irradia', version, materials: { material }, models, assets },
    file,
  );
  const read = document.materials.material;
  if (read === undefined) throw new DocumentError(file, [{ path: 'material', message: 'is missing' }]);
  return { material: read, models: document.models, assets: document.assets };
}

/** Puts it into a draft of a document, under names that are free there; returns the material's id. @param put puts the material itself */
export function addMaterialFile(
  draft: Draft,
  file: MaterialFile,
  put: (draft: Draft, material: Material) => string = putMaterial,
): string {
  const ids = new Map(
    Object.entries(file.assets).map(([id, asset]) => [id, keepAsset(draft, asset)] as const),
  );
  const names = new Map<string, string>();
  for (const [name, source] of Object.entries(file.models)) {
    const added = 'measured' in source ? { measured: ids.get(source.measured) ?? '' } : { ...source };
    const same = JSON.stringify(draft.models[name]) === JSON.stringify(added);
    const free = same ? name : freeName(name, modelNames(draft));
    draft.models[free] = added;
    names.set(name, free);
  }
  const material = structuredClone(file.material);
  material.model = names.get(material.model) ?? material.model;
  const textures = [...Object.values(material.textures), ...materialMaps.map((map) => material[map])];
  for (const texture of textures)
    if (texture !== null) texture.asset = ids.get(texture.asset) ?? texture.asset;
  return put(draft, material);
}
