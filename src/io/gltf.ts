/**
 * glTF and GLB into a document: the file becomes one asset, each surface of each node an
 * object, materials become `principled`, punctual lights become lights. Everything is read,
 * checked and decoded before there is a recipe to apply: a broken file changes nothing.
 */
import { z } from 'zod';
import { type AssetLoader, messageOf } from '../scene/assets.ts';
import { encodeBase64 } from '../scene/base64.ts';
import { keepAsset } from '../scene/commands.ts';
import { putMaterial } from '../scene/material-commands.ts';
import { materialDefaults, materialMaps } from '../scene/material-schema.ts';
import { freeId, freeName } from '../scene/names.ts';
import { type Asset, type Material, maxAssetBytes } from '../scene/schema.ts';
import type { Draft } from '../scene/store.ts';
import { GltfError } from './gltf/error.ts';
import { type GltfFile, gltfBytes, readGltf } from './gltf/file.ts';
import { convertMaterial } from './gltf/material.ts';
import { convertNodes, type GltfContents } from './gltf/nodes.ts';
import { Notes } from './gltf/notes.ts';
import type { Gltf } from './gltf/schema.ts';
import type { Companions } from './meshes/companions.ts';
import type { Converted } from './meshes/converted.ts';

export { GltfError } from './gltf/error.ts';

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
  /** What could not be kept. */
  notes: string[];
}

export interface ImportOptions {
  /** The files that came with it, by path: buffers, images and material files. */
  companions?: Companions;
  /** How much of the decoding is done, 0 to 1. */
  onProgress?(fraction: number): void;
}

/** @throws GltfError, which names the file and what in it is wrong */
export async function importGltf(
  bytes: Uint8Array,
  fileName: string,
  assets: AssetLoader,
  { companions, onProgress }: ImportOptions = {},
): Promise<ImportedModel> {
  const file = readGltf(bytes, fileName, companions);
  const notes = new Notes();
  const contents = convertNodes(file.json, notes);
  const spare = variantMaterials(file.json, contents, notes);
  const convert = (index: number | undefined) => convertMaterial(file.json, index, fileName, notes);
  const imported = await finish(file, contents, convert, spare, assets, notes, onProgress);
  if (contents.lights.length > 0)
    notes.add(
      'its lights are in candela and lux: if the picture is too bright or too dark, change the exposure',
    );
  return { ...imported, notes: notes.list };
}

/** The same for a file of another format, once it has become a GLB. */
export async function importConverted(
  { glb, materials, lights, camera }: Converted,
  fileName: string,
  assets: AssetLoader,
  notes: Notes,
  onProgress?: (fraction: number) => void,
): Promise<ImportedModel> {
  const file = readGltf(glb, fileName);
  const contents = { ...convertNodes(file.json, notes), lights, camera };
  const plain: Material = {
    ...structuredClone(materialDefaults),
    name: fileName.replace(/\.[A-Za-z0-9]+$/, '').slice(0, 180) || 'Material',
    parameters: { baseColor: [0.8, 0.8, 0.8] },
  };
  const convert = (index: number | undefined) => structuredClone(materials[index ?? -1] ?? plain);
  const imported = await finish(file, contents, convert, [], assets, notes, onProgress);
  return { ...imported, notes: notes.list };
}

async function finish(
  file: GltfFile,
  contents: GltfContents,
  convert: (index: number | undefined) => Material,
  spareIndices: readonly number[],
  assets: AssetLoader,
  notes: Notes,
  onProgress: (fraction: number) => void = () => {},
): Promise<Omit<ImportedModel, 'notes'>> {
  const { name } = file;
  if (contents.objects.length + contents.lights.length === 0)
    throw new GltfError(name, 'the file has no surfaces and no lights');
  const content = gltfBytes(file);
  if (content.length > maxAssetBytes)
    throw new GltfError(
      name,
      `${content.length} bytes are more than the ${maxAssetBytes} that a scene's file may have`,
    );
  const asset: Asset = {
    name: name.slice(-200),
    mediaType: 'model/gltf-binary',
    data: encodeBase64(content),
  };
  const used = new Set(contents.objects.map(({ material }) => material));
  const steps = contents.objects.length + used.size + spareIndices.length;
  let done = 0;
  const step = () => onProgress(++done / steps);
  for (const { node, primitive } of contents.objects) {
    await assets.gltfGeometry(asset, node, primitive);
    step();
  }
  const read = async (index: number | undefined): Promise<Material> => {
    const material = await withReadableTextures(convert(index), asset, assets, notes);
    step();
    return material;
  };
  const materials = new Map<number | undefined, Material>();
  for (const index of used) materials.set(index, await read(index));
  const spare: Material[] = [];
  for (const index of spareIndices) spare.push(await read(index));
  return { label: `Import ${name}`, asset, contents, materials, spare };
}

/** KHR_materials_variants: the materials that the variants of what is shown have, and its objects do not. */
function variantMaterials(gltf: Gltf, { objects }: GltfContents, notes: Notes): number[] {
  const root = z
    .looseObject({ variants: z.array(z.looseObject({ name: z.string() })) })
    .safeParse(gltf.extensions?.KHR_materials_variants);
  if (!root.success) return [];
  const mappings = z.looseObject({
    mappings: z.array(z.looseObject({ material: z.int().min(0) })),
  });
  const found = new Set<number>();
  for (const { node, primitive } of objects) {
    const mesh = gltf.meshes[gltf.nodes[node]?.mesh ?? -1];
    const variants = mappings.safeParse(mesh?.primitives[primitive]?.extensions?.KHR_materials_variants);
    for (const { material } of variants.data?.mappings ?? [])
      if (material < gltf.materials.length) found.add(material);
  }
  for (const { material } of objects) if (material !== undefined) found.delete(material);
  const names = root.data.variants.map(({ name }) => name).join(', ');
  notes.add(
    `it has the variants ${names.slice(0, 300)}: objects have the file's first materials, the others are among the scene's materials`,
  );
  return [...found];
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

/** Puts everything into a draft of a document; returns the ids of the new objects. */
export function addImported(
  draft: Draft,
  { contents: { objects, lights, camera }, materials, spare, asset }: ImportedModel,
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
