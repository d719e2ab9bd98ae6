/** What was read of a model, and how it gets into a document. */
import { keepAsset } from '../../scene/commands.ts';
import { putMaterial } from '../../scene/material-commands.ts';
import { materialMaps } from '../../scene/material-schema.ts';
import { freeId, freeName } from '../../scene/names.ts';
import type { Asset, Material } from '../../scene/schema.ts';
import type { Draft } from '../../scene/store.ts';
import { type Bounds, framed } from './framing.ts';
import type { GltfContents } from './nodes.ts';

/** All that a file brings, decoded and checked. Plain data: a worker can make it for a page. */
export interface ImportedModel {
  /** For the undo menu. */
  label: string;
  asset: Asset;
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

/** Puts everything into a draft of a document; returns the ids of the new objects. */
export function addImported(
  draft: Draft,
  { contents: { objects, lights, camera }, materials, spare, asset, bounds }: ImportedModel,
): string[] {
  const wasEmpty = Object.keys(draft.objects).length === 0;
  const assetId = keepAsset(draft, asset);
  const materialIds = new Map<number | undefined, string>();
  for (const [index, material] of materials)
    materialIds.set(index, putMaterial(draft, inAsset(material, assetId)));
  for (const material of spare) putMaterial(draft, inAsset(material, assetId));
  const names = new Set(Object.values(draft.objects).map(({ name }) => name));
  const ids = objects.map(({ object, node, primitive, material }) => {
    const id = freeId(object.name, draft.objects);
    const name = freeName(object.name, names);
    names.add(name);
    const geometry = { type: 'gltf' as const, asset: assetId, node, primitive };
    draft.objects[id] = {
      ...structuredClone(object),
      name,
      material: materialIds.get(material) ?? '',
      geometry,
    };
    return id;
  });
  for (const light of lights) {
    const name = freeName(
      light.name,
      Object.values(draft.lights).map((other) => other.name),
    );
    draft.lights[freeId(light.name, draft.lights)] = { ...structuredClone(light), name };
  }
  // The view of a scene that somebody works on is theirs; an empty scene takes the file's, or sees all of it.
  if (wasEmpty) draft.camera = camera ?? (bounds ? framed(draft.camera, bounds) : draft.camera);
  return ids;
}

/** The id of the asset is known only when it is added. */
function inAsset(material: Material, asset: string): Material {
  const copy = structuredClone(material);
  for (const texture of Object.values(copy.textures)) texture.asset = asset;
  for (const map of materialMaps) if (copy[map] !== null) copy[map].asset = asset;
  return copy;
}
