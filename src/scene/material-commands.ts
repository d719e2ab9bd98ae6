/** Commands for materials, their models and textures; each is one undo step with a label. */

import type { Parameter, ParameterValue } from '../brdf/model.ts';
import { checkValue } from '../brdf/values.ts';
import { carriedLook } from './carried-look.ts';
import { entity, namesOf } from './entity.ts';
import { DocumentError, pathText } from './error.ts';
import { materialDefaults, modelNamePattern, type TextureRef } from './material-schema.ts';
import { findModel, modelNames } from './models.ts';
import { freeId, freeName } from './names.ts';
import type { Document, Material } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';

/** Puts a new material into a draft: for recipes that add more than a material. */
export function putMaterial(draft: Draft, values: Partial<Material>): string {
  const material = { ...structuredClone(materialDefaults), ...values };
  material.name = freeName(material.name, namesOf(draft.materials));
  const id = freeId(material.name, draft.materials);
  draft.materials[id] = material;
  return id;
}

/** Returns the new material's id. */
export function addMaterial(store: DocumentStore, model = materialDefaults.model): string {
  let id = '';
  store.edit('Add material', (draft) => {
    id = putMaterial(draft, { model, name: model });
  });
  return id;
}

/** Takes materials out of a draft. Objects that have them get the first other one, or a new one. */
export function removeMaterials(draft: Draft, ids: readonly string[]): void {
  if (ids.length === 0) return;
  for (const id of ids) delete draft.materials[id];
  const gone = new Set(ids);
  if (draft.view.term && gone.has(draft.view.term.material)) draft.view.term = null;
  const users = Object.values(draft.objects).filter((object) => gone.has(object.material));
  if (users.length === 0) return;
  const heir = Object.keys(draft.materials)[0] ?? putMaterial(draft, {});
  for (const object of users) object.material = heir;
}

export function assignMaterial(store: DocumentStore, objects: readonly string[], material: string): void {
  const { name } = entity(store.document, 'materials', material);
  store.edit(`Assign ${name}`, (draft) => {
    for (const id of objects) entity(draft, 'objects', id).material = material;
  });
}

/** Gives objects copies of their materials, which no other object has: one of each. Returns the copies' ids. */
export function giveOwnMaterials(store: DocumentStore, objects: readonly string[]): string[] {
  const { document } = store;
  const own = [...new Set(objects.map((id) => entity(document, 'objects', id).material))];
  const [first] = own;
  const copies = new Map<string, string>();
  const what =
    own.length === 1 && first ? entity(document, 'materials', first).name : `${own.length} materials`;
  store.edit(`Own copy of ${what}`, (draft) => {
    for (const id of own)
      copies.set(id, putMaterial(draft, structuredClone(entity(document, 'materials', id))));
    for (const id of objects) {
      const object = entity(draft, 'objects', id);
      object.material = copies.get(object.material) ?? object.material;
    }
  });
  return [...copies.values()];
}

/** Another model: what it can show of the look stays, see carriedLook(). */
export function setMaterialModel(store: DocumentStore, id: string, model: string): void {
  const material = entity(store.document, 'materials', id);
  const next = findModel(store.document, model);
  const look = carriedLook(findModel(store.document, material.model), next, material);
  store.edit(`Model of ${material.name}: ${model}`, (draft) => {
    Object.assign(entity(draft, 'materials', id), { model, ...structuredClone(look) });
    if (draft.view.term?.material === id && !next?.terms.includes(draft.view.term.name))
      draft.view.term = null;
  });
}

function parameterOf(document: Document, id: string, name: string): Parameter {
  const material = entity(document, 'materials', id);
  const parameter = findModel(document, material.model)?.parameters.find((p) => p.name === name);
  if (parameter === undefined)
    throw new DocumentError('scene', [
      {
        path: pathText(['materials', id, 'parameters', name]),
        message: `${material.model} has no such parameter`,
      },
    ]);
  return parameter;
}

/** Sets a model's parameter; null takes the model's default again. */
export function setParameter(
  store: DocumentStore,
  material: string,
  name: string,
  value: ParameterValue | null,
): void {
  const parameter = parameterOf(store.document, material, name);
  const checked =
    value === null ? null : checkValue(store.document.materials[material]!.model, parameter, value);
  const label = value === null ? `Reset ${name}` : `Change ${name}`;
  store.edit(
    label,
    (draft) => {
      const { parameters } = entity(draft, 'materials', material);
      if (checked === null) delete parameters[name];
      else parameters[name] = typeof checked === 'object' ? [...checked] : checked;
    },
    { merge: `materials.${material}.parameters.${name}` },
  );
}

/** Sets several of a model's parameters in one step; the others stay. */
export function setParameters(
  store: DocumentStore,
  material: string,
  label: string,
  values: Readonly<Record<string, ParameterValue>>,
): void {
  const { model, name } = entity(store.document, 'materials', material);
  const checked = Object.entries(values).map(
    ([key, value]) => [key, checkValue(model, parameterOf(store.document, material, key), value)] as const,
  );
  store.edit(`${name}: ${label}`, (draft) => {
    const { parameters } = entity(draft, 'materials', material);
    for (const [key, value] of checked) parameters[key] = typeof value === 'object' ? [...value] : value;
  });
}

/** Sets or, with null, takes away the texture of a model's parameter. */
export function setTexture(
  store: DocumentStore,
  material: string,
  name: string,
  texture: TextureRef | null,
): void {
  parameterOf(store.document, material, name);
  store.edit(texture === null ? `Remove texture of ${name}` : `Texture of ${name}`, (draft) => {
    const { textures } = entity(draft, 'materials', material);
    if (texture === null) delete textures[name];
    else textures[name] = texture;
  });
}

/**
 * Adds a .brdf file's text under a name that no model has yet; returns that name. Throws
 * DocumentError with the file, line and fault if the model does not compile.
 */
export function addModel(store: DocumentStore, fileName: string, source: string): string {
  const name = modelNameFor(store, fileName);
  store.edit(`Add model ${name}`, (draft) => {
    draft.models[name] = { source };
  });
  return name;
}

/** A free name for the model of a file. */
export function modelNameFor(store: DocumentStore, fileName: string): string {
  const base = fileName
    .replace(/^.*[/\\]/, '')
    .replace(/\.[A-Za-z0-9]+$/, '')
    .replace(/[^A-Za-z0-9 ._-]/g, '-')
    .slice(0, 48);
  return freeName(modelNamePattern.test(base) ? base : 'model', modelNames(store.document));
}

/** Refused, with the materials' paths, while materials have the model. */
export function removeModel(store: DocumentStore, name: string): void {
  entity(store.document, 'models', name);
  store.edit(`Delete model ${name}`, (draft) => {
    delete draft.models[name];
  });
}
