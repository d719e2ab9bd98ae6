/** What is in a glTF file and not in the document that it becomes, in words for the person who brought it. */
import type { Notes } from './notes.ts';
import { type Gltf, type GltfMaterial, isSceneOfOurs } from './schema.ts';

/** Extensions of materials that are read, at least in part (docs/import.md). */
const READ_OF_MATERIALS = new Set([
  ...['anisotropy', 'clearcoat', 'diffuse_transmission', 'dispersion', 'emissive_strength', 'ior'],
  ...['iridescence', 'pbrSpecularGlossiness', 'sheen', 'specular', 'transmission', 'unlit', 'volume'],
]);

/** Of the file as a whole. */
export function noteFile(gltf: Gltf, notes: Notes): void {
  if (gltf.animations.length > 0) notes.add('its animations are not played');
  if (gltf.scenes.length > 1)
    notes.add(`it has ${gltf.scenes.length} scenes; only the one that it names is shown`);
  const cameras = gltf.nodes.filter(({ camera }) => camera !== undefined).length;
  if (cameras > 1 && !isSceneOfOurs(gltf))
    notes.add(`it has ${cameras} cameras; the view is the first one's`);
  for (const extension of gltf.extensionsRequired)
    if (!isKnown(extension))
      notes.add(`it needs the extension ${extension.slice(0, 100)}, which is not read`);
}

const KNOWN = new Set([
  ...['EXT_mesh_gpu_instancing', 'EXT_meshopt_compression', 'EXT_texture_avif', 'EXT_texture_webp'],
  ...['KHR_draco_mesh_compression', 'KHR_lights_punctual', 'KHR_materials_variants', 'KHR_mesh_quantization'],
  ...['KHR_meshopt_compression', 'KHR_node_visibility', 'KHR_texture_basisu', 'KHR_texture_transform'],
]);
const isKnown = (extension: string): boolean =>
  KNOWN.has(extension) || READ_OF_MATERIALS.has(extension.replace(/^KHR_materials_/, ''));

/** Of a material; that layers have no counterpart is told where they are mapped. */
export function noteMaterial(extensions: GltfMaterial['extensions'], name: string, notes: Notes): void {
  const has = (extension: string, field: string): boolean =>
    (extensions?.[`KHR_materials_${extension}`] as Record<string, unknown> | null | undefined)?.[field] !==
    undefined;
  if (has('clearcoat', 'clearcoatRoughnessTexture'))
    notes.add(`${name}: the texture of the clearcoat's roughness has no counterpart`);
  if (has('specular', 'specularColorTexture'))
    notes.add(`${name}: the texture of the reflection's colour has no counterpart`);
  if (has('volume', 'thicknessTexture'))
    notes.add(`${name}: the texture of its thickness is not needed: the body is as thick as it is`);
  if (has('diffuse_transmission', 'diffuseTransmissionColorTexture'))
    notes.add(`${name}: the colour texture of the light that its sheet lets through has no counterpart`);
  for (const extension of Object.keys(extensions ?? {}))
    if (!READ_OF_MATERIALS.has(extension.replace(/^KHR_materials_/, '')))
      notes.add(`${name}: ${extension.slice(0, 100)} is not read`);
}
