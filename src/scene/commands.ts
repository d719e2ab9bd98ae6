/**
 * What a person can do to a document, each as one undo step with a label. Plain changes of
 * one field need no command of their own: `setField` makes them. Commands for materials and
 * models are in material-commands.ts, for all that is selected in selection-commands.ts, for groups in
 * group-commands.ts.
 */
import type { z } from 'zod';
import { entity, namesOf } from './entity.ts';
import { DocumentError, type Path, pathText } from './error.ts';
import { type AddableGeometry, geometryDefaults, geometryNames, geometryShapes } from './geometry-schema.ts';
import { type LightType, lightDefaults, lightShapes } from './light-schema.ts';
import { putMaterial } from './material-commands.ts';
import { freeId, freeName } from './names.ts';
import { freePlace, lightPlace, lightTarget } from './placement.ts';
import { type Asset, type Geometry, type Light, objectDefaults } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';
import { assetsOf } from './validate.ts';

/** What has a name of its own that can be changed. */
export type Named = 'lights' | 'objects' | 'groups' | 'materials' | 'assets';

/** Adds a light near what the camera looks at, beside the lights that are there; returns its id. */
export function addLight(store: DocumentStore, type: LightType, values: Partial<Light> = {}): string {
  const { lights } = store.document;
  const defaults = lightDefaults[type];
  const id = freeId(type, lights);
  store.edit(`Add ${defaults.name.toLowerCase()}`, (draft) => {
    const name = freeName(values.name ?? defaults.name, namesOf(lights));
    const place: { position?: number[]; target?: number[] } = {};
    if ('position' in defaults) place.position = lightPlace(store.document, defaults.position);
    if ('target' in defaults) place.target = lightTarget(store.document, defaults.target);
    draft.lights[id] = { ...structuredClone(defaults), ...place, ...values, name, type } as Light;
  });
  return id;
}

/**
 * Adds a primitive with a material (a new one if none is given), on the floor where there is room for it;
 * returns the object's id.
 */
export function addObject(
  store: DocumentStore,
  type: AddableGeometry,
  material?: string,
  name = geometryNames[type],
): string {
  const { objects } = store.document;
  const id = freeId(geometryNames[type], objects);
  store.edit(`Add ${geometryNames[type].toLowerCase()}`, (draft) => {
    const object = {
      ...structuredClone(objectDefaults),
      name: freeName(name, namesOf(objects)),
      geometry: structuredClone(geometryDefaults[type]),
    };
    object.position = freePlace(store.document, object);
    draft.objects[id] = { ...object, material: material ?? putMaterial(draft, { name }) };
  });
  return id;
}

/** Puts a file (base64) into a draft; the same bytes are kept once. Returns the asset's id. */
export function putAsset(draft: Draft, name: string, mediaType: string, data: string): string {
  return keepAsset(draft, { name: name.slice(0, 200), mediaType, data });
}

/** The same for an asset that is in use already: what was decoded of this very object stays decoded. */
export function keepAsset(draft: Draft, asset: Asset): string {
  for (const [id, { mediaType, data }] of Object.entries(draft.assets))
    if (mediaType === asset.mediaType && data === asset.data) return id;
  const id = freeId(asset.name.replace(/\.[A-Za-z0-9]+$/, ''), draft.assets);
  draft.assets[id] = asset;
  return id;
}

/** Removes the materials and assets that nothing uses. */
export function removeUnused(store: DocumentStore): void {
  store.edit('Remove unused materials and files', (draft) => {
    const objects = Object.values(draft.objects);
    const materials = new Set(objects.map((object) => object.material));
    if (draft.view.term !== null) materials.add(draft.view.term.material);
    for (const id of Object.keys(draft.materials)) if (!materials.has(id)) delete draft.materials[id];
    const assets = new Set<string>();
    for (const { geometry } of objects) if (geometry.type === 'gltf') assets.add(geometry.asset);
    for (const material of Object.values(draft.materials))
      for (const [, asset] of assetsOf(material)) assets.add(asset);
    const { source } = draft.environment;
    if (source.type === 'hdr') assets.add(source.asset);
    for (const model of Object.values(draft.models)) if ('measured' in model) assets.add(model.measured);
    for (const id of Object.keys(draft.assets)) if (!assets.has(id)) delete draft.assets[id];
  });
}

export function rename(store: DocumentStore, collection: Named, id: string, name: string): void {
  const { name: old } = entity(store.document, collection, id);
  store.edit(`Rename ${old} to ${name}`, (draft) => {
    entity(draft, collection, id).name = name;
  });
}

/**
 * Sets the field at a path, such as `['lights', 'key', 'intensity']`. Edits of the same field
 * in a row are one undo step until `store.endMerge()`.
 */
export function setField(store: DocumentStore, path: Path, value: unknown, label?: string): void {
  const merge = pathText(path);
  store.edit(
    label ?? `Change ${fieldLabel(path)}`,
    (draft) => {
      let holder: unknown = draft;
      for (const key of path.slice(0, -1)) holder = own(holder, key, path);
      const last = path.at(-1);
      if (last === undefined) return;
      own(holder, last, path);
      (holder as Record<string | number, unknown>)[last] = value;
    },
    { merge },
  );
}

function own(holder: unknown, key: string | number, path: Path): unknown {
  if (typeof holder !== 'object' || holder === null || !Object.hasOwn(holder, key))
    throw new DocumentError('scene', [{ path: pathText(path), message: 'does not exist' }]);
  return (holder as Record<string | number, unknown>)[key];
}

/** The last name in a path, as words: `widthSegments` is "width segments". */
function fieldLabel(path: Path): string {
  const name = path.findLast((key) => typeof key === 'string') ?? 'scene';
  return name.replace(/([a-z])([A-Z])/g, '$1 $2').toLowerCase();
}

/**
 * What two types have in common stays as it was, as far as the new type allows. The fineness of
 * a mesh does not: how many segments are enough depends on the shape.
 */
function carried(from: object, to: object, shape: Readonly<Record<string, z.ZodType>>): object {
  const result: Record<string, unknown> = { ...structuredClone(to) };
  for (const [key, value] of Object.entries(from)) {
    const wanted = key !== 'type' && !/segments$/i.test(key) && Object.hasOwn(result, key);
    if (wanted && shape[key]?.safeParse(value).success) result[key] = structuredClone(value);
  }
  return result;
}

/** Another type of light in the same place. */
export function setLightType(store: DocumentStore, id: string, type: LightType): void {
  const light = entity(store.document, 'lights', id);
  store.edit(`Make ${light.name} a ${lightDefaults[type].name.toLowerCase()}`, (draft) => {
    draft.lights[id] = carried(light, lightDefaults[type], lightShapes[type]) as Light;
  });
}

/** Another primitive in the same place. */
export function setGeometryType(store: DocumentStore, id: string, type: AddableGeometry): void {
  const { name, geometry } = entity(store.document, 'objects', id);
  store.edit(`Make ${name} a ${geometryNames[type].toLowerCase()}`, (draft) => {
    entity(draft, 'objects', id).geometry = carried(
      geometry,
      geometryDefaults[type],
      geometryShapes[type],
    ) as Geometry;
  });
}
