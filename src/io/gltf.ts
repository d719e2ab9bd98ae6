/**
 * glTF and GLB into a document: the file becomes one asset, each surface of each node an
 * object, materials become `principled`, punctual lights become lights. Everything is read,
 * checked and decoded before there is a recipe to apply: a broken file changes nothing.
 */
import { type AssetLoader, messageOf } from '../scene/assets.ts';
import { encodeBase64 } from '../scene/base64.ts';
import { keepAsset } from '../scene/commands.ts';
import { putMaterial } from '../scene/material-commands.ts';
import { materialMaps } from '../scene/material-schema.ts';
import { freeId, freeName } from '../scene/names.ts';
import { type Asset, type Material, maxAssetBytes } from '../scene/schema.ts';
import type { Draft } from '../scene/store.ts';
import { GltfError } from './gltf/error.ts';
import { type Companions, gltfBytes, readGltf } from './gltf/file.ts';
import { convertMaterial } from './gltf/material.ts';
import { convertNodes, type GltfContents } from './gltf/nodes.ts';
import { Notes } from './gltf/notes.ts';

export { GltfError } from './gltf/error.ts';

export interface GltfImport {
  /** For the undo menu. */
  label: string;
  /** Adds everything to a draft of a document; returns the ids of the new objects. */
  recipe(draft: Draft): string[];
  /** What could not be kept. */
  notes: string[];
}

/**
 * `companions` are the files that came with it, by path: buffers and images of a .gltf file.
 * Throws GltfError, which names the file and what in it is wrong.
 */
export async function importGltf(
  bytes: Uint8Array,
  fileName: string,
  assets: AssetLoader,
  companions?: Companions,
): Promise<GltfImport> {
  const file = readGltf(bytes, fileName, companions);
  const notes = new Notes();
  const contents = convertNodes(file.json, notes);
  if (contents.objects.length + contents.lights.length === 0)
    throw new GltfError(fileName, 'the file has no surfaces and no lights');
  const content = gltfBytes(file);
  if (content.length > maxAssetBytes)
    throw new GltfError(
      fileName,
      `${content.length} bytes are more than the ${maxAssetBytes} that a scene's file may have`,
    );
  const asset: Asset = {
    name: fileName.slice(-200),
    mediaType: 'model/gltf-binary',
    data: encodeBase64(content),
  };
  for (const { node, primitive } of contents.objects) await assets.gltfGeometry(asset, node, primitive);
  const materials = new Map<number | undefined, Material>();
  for (const { material } of contents.objects)
    if (!materials.has(material)) {
      const converted = convertMaterial(file.json, material, asset.name, notes);
      materials.set(material, await withReadableTextures(converted, asset, assets, notes));
    }
  if (contents.lights.length > 0)
    notes.add(
      'its lights are in candela and lux: if the picture is too bright or too dark, change the exposure',
    );
  return {
    label: `Import ${fileName}`,
    recipe: (draft) => addContents(draft, contents, materials, asset),
    notes: notes.list,
  };
}

/** A texture that cannot be decoded is left out: the rest of the file is still worth having. */
async function withReadableTextures(
  material: Material,
  asset: Asset,
  assets: AssetLoader,
  notes: Notes,
): Promise<Material> {
  const readable = async (texture: number | null): Promise<boolean> => {
    try {
      await assets.image(asset, texture);
      return true;
    } catch (error) {
      notes.add(messageOf(error));
      return false;
    }
  };
  for (const [name, { texture }] of Object.entries(material.textures))
    if (!(await readable(texture))) delete material.textures[name];
  for (const map of materialMaps) {
    const texture = material[map];
    if (texture !== null && !(await readable(texture.texture))) material[map] = null;
  }
  return material;
}

function addContents(
  draft: Draft,
  { objects, lights, camera }: GltfContents,
  materials: ReadonlyMap<number | undefined, Material>,
  asset: Asset,
): string[] {
  const wasEmpty = Object.keys(draft.objects).length === 0;
  const assetId = keepAsset(draft, asset);
  const materialIds = new Map<number | undefined, string>();
  for (const [index, material] of materials)
    materialIds.set(index, putMaterial(draft, inAsset(material, assetId)));
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
  // The view of a scene that somebody works on is theirs; an empty scene takes the file's.
  if (camera !== null && wasEmpty) draft.camera = camera;
  return ids;
}

/** The id of the asset is known only when it is added. */
function inAsset(material: Material, asset: string): Material {
  const copy = structuredClone(material);
  for (const texture of Object.values(copy.textures)) texture.asset = asset;
  for (const map of materialMaps) if (copy[map] !== null) copy[map].asset = asset;
  return copy;
}
