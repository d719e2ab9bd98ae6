/** Commands by which materials of a library, and variations, come into a document; each is one undo step. */
import type { ParameterValue } from '../brdf/model.ts';
import { entity } from './entity.ts';
import { putMaterial } from './material-commands.ts';
import { materialDefaults, materialMaps } from './material-schema.ts';
import { findModel } from './models.ts';
import { isPattern } from './pattern/asset.ts';
import type { Material } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';
import { assetsOf } from './validate.ts';

/** What of a material is its look: not its textures, transparency and light of its own. */
export interface MaterialLook {
  readonly model: string;
  readonly parameters: Readonly<Record<string, ParameterValue>>;
  readonly multipleScattering: boolean;
}

export interface GiveOptions {
  /** Puts the material into the draft; returns its id. */
  put(draft: Draft): string;
  /** Whether a material that no object has any more was only tried, and may go with this step. */
  isTry?(material: Material, draft: Draft): boolean;
}

/** Gives objects a material from elsewhere. Without objects it is only added. Returns its id. */
export function giveMaterial(
  store: DocumentStore,
  title: string,
  objects: readonly string[],
  { put, isTry }: GiveOptions,
): string {
  let id = '';
  store.edit(objects.length > 0 ? `Assign ${title}` : `Add ${title}`, (draft) => {
    id = put(draft);
    const before = new Set(objects.map((object) => entity(draft, 'objects', object).material));
    for (const object of objects) entity(draft, 'objects', object).material = id;
    for (const old of before) {
      const material = draft.materials[old];
      const isUsed = Object.values(draft.objects).some((object) => object.material === old);
      if (!material || isUsed || !isTry?.(material, draft)) continue;
      delete draft.materials[old];
      dropPatterns(draft, assetIds(material));
      if (draft.view.term?.material === old) draft.view.term = null;
    }
  });
  return id;
}

const assetIds = (material: Material): string[] => assetsOf(material).map(([, id]) => id);

/** The patterns among what a material has no longer, where no other has them: a pattern alone is nothing that a person made. */
function dropPatterns(draft: Draft, gone: readonly string[]): void {
  const used = new Set(Object.values(draft.materials).flatMap(assetIds));
  for (const id of gone) if (!used.has(id) && isPattern(draft.assets[id])) delete draft.assets[id];
}

/** The material of these values that is there already, or a new one. */
export function putMaterialOnce(draft: Draft, values: Partial<Material>): string {
  const wanted = JSON.stringify(sorted({ ...materialDefaults, ...values }));
  const known = Object.entries(draft.materials).find(
    ([, material]) => JSON.stringify(sorted(material)) === wanted,
  );
  return known?.[0] ?? putMaterial(draft, values);
}

/** With the keys in one order, so that texts can be compared. */
export function sorted(value: unknown): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) return value.map(sorted);
  return Object.fromEntries(
    Object.entries(value)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([key, entry]) => [key, sorted(entry)]),
  );
}

/** Gives materials another look. Textures that multiplied the old values go: a look is the whole value. */
export function setLook(
  store: DocumentStore,
  materials: readonly string[],
  label: string,
  look: MaterialLook,
  options: { readonly merge?: string } = {},
): void {
  store.edit(
    label,
    (draft) => {
      for (const id of materials) putLook(draft, id, look);
    },
    options,
  );
}

export function putLook(draft: Draft, id: string, look: MaterialLook): void {
  const material = entity(draft, 'materials', id);
  material.model = look.model;
  material.parameters = structuredClone(look.parameters) as Material['parameters'];
  const before = assetIds(material);
  material.textures = {};
  // Normals of a pattern belong to the look that goes.
  for (const map of materialMaps)
    if (isPattern(draft.assets[material[map]?.asset ?? ''])) material[map] = null;
  dropPatterns(draft, before);
  material.multipleScattering = look.multipleScattering;
  const terms = findModel(draft, look.model)?.terms ?? [];
  if (draft.view.term?.material === id && !terms.includes(draft.view.term.name)) draft.view.term = null;
}

/** Sets all of a material's parameters at once, to the model's defaults where no value is named; those are not stored. */
export function setValues(
  store: DocumentStore,
  id: string,
  label: string,
  values: Readonly<Record<string, ParameterValue>>,
  merge?: string,
): void {
  const { name, model } = entity(store.document, 'materials', id);
  const parameters = findModel(store.document, model)?.parameters ?? [];
  const isStored = (name: string, usual: ParameterValue) =>
    values[name] !== undefined && JSON.stringify(values[name]) !== JSON.stringify(usual);
  const stored = parameters.filter((parameter) => isStored(parameter.name, parameter.default));
  store.edit(
    `${name}: ${label}`,
    (draft) => {
      entity(draft, 'materials', id).parameters = Object.fromEntries(
        stored.map((parameter) => [parameter.name, structuredClone(values[parameter.name])]),
      ) as Material['parameters'];
    },
    { ...(merge !== undefined && { merge }) },
  );
}
