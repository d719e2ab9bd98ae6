/** What was read of a model, and how it gets into a document. */
import { keepAsset } from '../../scene/commands.ts';
import { type MemberRef, namesOf } from '../../scene/entity.ts';
import { putMaterial } from '../../scene/material-commands.ts';
import { materialMaps } from '../../scene/material-schema.ts';
import { FreeIds, FreeNames } from '../../scene/names.ts';
import type { Asset, Material } from '../../scene/schema.ts';
import type { Draft } from '../../scene/store.ts';
import { type Bounds, framed } from './framing.ts';
import type { GltfContents } from './nodes.ts';

/** All that a file brings, decoded and checked. Plain data: a worker can make it for a page. */
export interface ImportedModel {
  /** For the undo menu. */
  label: string;
  /** Null where nothing of it is needed: the objects are a document's own primitives, without textures. */
  asset: Asset | null;
  contents: GltfContents;
  /** By the number that objects have of it. */
  materials: ReadonlyMap<number | undefined, Material>;
  /** Materials that no object has: those of a file's variants. */
  spare: readonly Material[];
  /** Least and greatest corner of all that is shown, in the world; null without surfaces. */
  bounds: Bounds | null;
  /** What could not be kept. */
  notes: string[];
}

/** Puts everything into a draft of a document; returns the new lights and objects, as they are listed. */
export function addImported(
  draft: Draft,
  { contents: { objects, lights, groups, camera }, materials, spare, asset, bounds }: ImportedModel,
): MemberRef[] {
  const wasEmpty = Object.keys(draft.objects).length === 0;
  const assetId = asset === null ? '' : keepAsset(draft, asset);
  const materialIds = new Map<number | undefined, string>();
  for (const [index, material] of materials)
    materialIds.set(index, putMaterial(draft, inAsset(material, assetId)));
  for (const material of spare) putMaterial(draft, inAsset(material, assetId));
  const free = (kind: 'groups' | 'lights' | 'objects') => {
    const [ids, names] = [new FreeIds(Object.keys(draft[kind])), new FreeNames(namesOf(draft[kind]))];
    return (base: string) => ({ id: ids.take(base), name: names.take(base) });
  };
  const takeGroup = free('groups');
  const groupIds: string[] = [];
  const groupAt = (index: number | null) => (index === null ? null : (groupIds[index] ?? null));
  for (const { name: called, parent } of groups) {
    const { id, name } = takeGroup(called);
    draft.groups[id] = { name, parent: groupAt(parent) };
    groupIds.push(id);
  }
  const refs: MemberRef[] = [];
  const takeLight = free('lights');
  for (const { light, group } of lights) {
    const { id, name } = takeLight(light.name);
    draft.lights[id] = { ...structuredClone(light), name, group: groupAt(group) };
    refs.push({ kind: 'lights', id });
  }
  const takeObject = free('objects');
  for (const { object, node, primitive, shape, material, group } of objects) {
    const { id, name } = takeObject(object.name);
    draft.objects[id] = {
      ...structuredClone(object),
      name,
      group: groupAt(group),
      material: materialIds.get(material) ?? '',
      geometry: shape ? { ...shape } : { type: 'gltf', asset: assetId, node, primitive },
    };
    refs.push({ kind: 'objects', id });
  }
  // The view of a scene that somebody works on is theirs; an empty scene takes the file's, or sees all of it.
  if (wasEmpty) draft.camera = camera ?? (bounds ? framed(draft.camera, bounds) : draft.camera);
  return refs;
}

/** The id of the asset is known only when it is added. */
function inAsset(material: Material, asset: string): Material {
  const copy = structuredClone(material);
  for (const texture of Object.values(copy.textures)) texture.asset = asset;
  for (const map of materialMaps) if (copy[map] !== null) copy[map].asset = asset;
  return copy;
}
