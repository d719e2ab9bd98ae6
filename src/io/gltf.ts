/**
 * glTF and GLB into a document: the file becomes one asset, each surface of each node an
 * object, materials become `principled`, punctual lights become lights. Everything is read,
 * checked and decoded before there is a recipe to apply: a broken file changes nothing.
 */
import * as THREE from 'three/webgpu';
import { z } from 'zod';
import { type AssetLoader, messageOf } from '../scene/assets.ts';
import { encodeBase64 } from '../scene/base64.ts';
import { materialDefaults, materialMaps } from '../scene/material-schema.ts';
import { createPrimitive, type Primitive } from '../scene/mirror/geometry.ts';
import { type Asset, type Material, maxAssetBytes, type SceneObject } from '../scene/schema.ts';
import type { ImportedModel } from './gltf/add.ts';
import { GltfError } from './gltf/error.ts';
import { type GltfFile, gltfBytes, readGltf } from './gltf/file.ts';
import { convertMaterial } from './gltf/material.ts';
import { convertNodes, type GltfContents, type GltfObject } from './gltf/nodes.ts';
import { Notes } from './gltf/notes.ts';
import type { Gltf } from './gltf/schema.ts';
import { noteFile } from './gltf/unread.ts';
import type { Companions } from './meshes/companions.ts';
import type { Converted } from './meshes/converted.ts';

export { addImported, type ImportedModel } from './gltf/add.ts';
export { GltfError } from './gltf/error.ts';

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
  const notes = new Notes();
  const file = readGltf(bytes, fileName, companions, notes);
  const contents = convertNodes(file, fileName, notes);
  noteFile(file.json, notes);
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
  { glb, materials, lights, primitives, camera }: Converted,
  fileName: string,
  assets: AssetLoader,
  notes: Notes,
  onProgress?: (fraction: number) => void,
): Promise<ImportedModel> {
  const file = readGltf(glb, fileName);
  const contents = { ...convertNodes(file, fileName, notes, { lights, primitives }), camera };
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
  const asset: Asset | null = isNeeded(file, contents)
    ? { name: name.slice(-200), mediaType: 'model/gltf-binary', data: encodeBase64(content) }
    : null;
  const used = new Set(contents.objects.map(({ material }) => material));
  const steps = contents.objects.length + used.size + spareIndices.length;
  let done = 0;
  const step = () => onProgress(++done / steps);
  const box = new THREE.Box3();
  const primitives = new Map<Primitive, THREE.BufferGeometry>();
  const geometryOf = async ({ node, primitive, shape }: GltfObject) => {
    if (shape === null) return asset && assets.gltfGeometry(asset, node, primitive);
    const geometry = primitives.get(shape) ?? createPrimitive(shape);
    primitives.set(shape, geometry);
    return geometry;
  };
  for (const found of contents.objects) {
    const geometry = await geometryOf(found);
    if (geometry && found.object.visible) box.union(worldBox(geometry, found.object));
    step();
  }
  const read = async (index: number | undefined): Promise<Material> => {
    const converted = convert(index);
    const material = asset ? await withReadableTextures(converted, asset, assets, notes) : converted;
    step();
    return material;
  };
  const materials = new Map<number | undefined, Material>();
  for (const index of used) materials.set(index, await read(index));
  const spare: Material[] = [];
  for (const index of spareIndices) spare.push(await read(index));
  const bounds = box.isEmpty() ? null : { min: box.min.toArray(), max: box.max.toArray() };
  return { label: `Import ${name}`, asset, contents, materials, spare, bounds };
}

/** A file of a document's own primitives alone would be a burden to it: a link has little room. */
function isNeeded({ json }: GltfFile, { objects }: GltfContents): boolean {
  return json.images.length > 0 || objects.some(({ shape }) => shape === null);
}

function worldBox(
  geometry: THREE.BufferGeometry,
  { position, rotation, scale }: Pick<SceneObject, 'position' | 'rotation' | 'scale'>,
): THREE.Box3 {
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  const turn = new THREE.Euler(...(rotation.map(THREE.MathUtils.degToRad) as [number, number, number]));
  const matrix = new THREE.Matrix4().compose(
    new THREE.Vector3(...position),
    new THREE.Quaternion().setFromEuler(turn),
    new THREE.Vector3(...scale),
  );
  return (geometry.boundingBox ?? new THREE.Box3()).clone().applyMatrix4(matrix);
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
