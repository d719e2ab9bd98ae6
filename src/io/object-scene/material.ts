/** Materials of a three.js scene file as `principled`; a Phong highlight becomes a microfacet one that is as wide. */

import * as THREE from 'three/webgpu';
import { materialDefaults } from '../../scene/material-schema.ts';
import type { Material, ScaledTextureRef, TextureRef } from '../../scene/schema.ts';
import { specularOfReflectance } from '../../scene/specular.ts';
import type { Notes } from '../gltf/notes.ts';
import { applyLayers, makeUnlit, noLayers } from '../material-layers.ts';
import { phongRoughness } from '../meshes/phong.ts';
import type { SourceMaterial } from './schema.ts';
import type { SceneTextures } from './textures.ts';

type Rgb = [number, number, number];
const clamp = THREE.MathUtils.clamp;
/** Files have colours as sRGB numbers. */
export const linear = (hex: number): Rgb => new THREE.Color(hex).toArray() as Rgb;

const physical = new Set(['MeshStandardMaterial', 'MeshPhysicalMaterial']);
const read = new Set([
  ...physical,
  'MeshPhongMaterial',
  'MeshLambertMaterial',
  'MeshBasicMaterial',
  'MeshToonMaterial',
]);

/** Textures of three.js's materials that have no counterpart here. */
const unread = [
  ...['clearcoatRoughnessMap', 'displacementMap', 'envMap', 'gradientMap', 'iridescenceMap', 'lightMap'],
  ...['matcap', 'sheenRoughnessMap', 'specularColorMap', 'specularMap', 'thicknessMap'],
];

export function sceneMaterial(
  source: SourceMaterial,
  index: number,
  textures: SceneTextures,
  notes: Notes,
): Material {
  const name = (source.name ?? '').slice(0, 180) || `Material ${index + 1}`;
  const map = (uuid: string | null | undefined, values: Partial<TextureRef> = {}) =>
    uuid ? textures.get(uuid, values) : null;
  const scaled = (ref: TextureRef | null, scale: number): ScaledTextureRef | null =>
    ref && { ...ref, scale: clamp(scale, -100, 100) };
  if (!read.has(source.type))
    notes.add(`${name}: ${source.type} has a shader of its own, which is not read; its colour is`);
  if (source.wireframe) notes.add(`${name}: it is shown solid, not as a wireframe`);

  const material: Material = { ...structuredClone(materialDefaults), name, model: 'principled' };
  const isPhysical = physical.has(source.type);
  const isPhong = source.type === 'MeshPhongMaterial';
  material.parameters = {
    baseColor: source.color === undefined ? [1, 1, 1] : linear(source.color),
    metallic: isPhysical ? source.metalness : 0,
    roughness: isPhysical ? source.roughness : isPhong ? clamp(phongRoughness(source.shininess), 0, 1) : 1,
  };
  const put = (parameter: string, ref: TextureRef | null): void => {
    if (ref) material.textures[parameter] = ref;
  };
  put('baseColor', map(source.map, { colorSpace: 'srgb' }));
  if (isPhysical) {
    put('roughness', map(source.roughnessMap, { channel: 'g' }));
    put('metallic', map(source.metalnessMap, { channel: 'b' }));
  }
  setSurface(material, source, map, scaled);
  if (source.type === 'MeshPhysicalMaterial') applyPhysical(material, source, map, notes);
  // Phong's specular colour is what is reflected head-on; Lambert reflects nothing.
  else if (isPhong)
    material.parameters.specular = specularOfReflectance(Math.max(...linear(source.specular ?? 0x111111)));
  else if (!isPhysical) material.parameters.specular = 0;
  if (source.type === 'MeshBasicMaterial') makeUnlit(material, notes);
  for (const field of unread) if (source[field]) notes.add(`${name}: its ${field} is not read`);
  return material;
}

type FindMap = (uuid: string | null | undefined, values?: Partial<TextureRef>) => TextureRef | null;

function setSurface(
  material: Material,
  source: SourceMaterial,
  map: FindMap,
  scaled: (ref: TextureRef | null, scale: number) => ScaledTextureRef | null,
): void {
  material.normalMap = scaled(map(source.normalMap), source.normalScale?.[0] ?? 1);
  material.bumpMap = scaled(map(source.bumpMap, { channel: 'r' }), source.bumpScale);
  material.occlusionMap = scaled(map(source.aoMap, { channel: 'r' }), source.aoMapIntensity);
  material.emissiveMap = scaled(map(source.emissiveMap, { colorSpace: 'srgb' }), 1);
  const emissive = linear(source.emissive ?? 0);
  const brightest = Math.max(...emissive);
  if (brightest > 0 && source.emissiveIntensity > 0) {
    material.emissive = emissive.map((value) => value / brightest) as Rgb;
    material.emissiveIntensity = clamp(brightest * source.emissiveIntensity, 0, 1e9);
  }
  material.doubleSided = source.side === THREE.DoubleSide;
  if (source.alphaTest > 0) {
    material.alphaMode = 'mask';
    material.alphaCutoff = clamp(source.alphaTest, 0, 1);
  } else if (source.transparent) material.alphaMode = 'blend';
  if (material.alphaMode === 'opaque') return;
  material.opacity = clamp(source.opacity, 0, 1);
  // three.js takes green from a map of its own, and alpha from the colour's.
  const own = map(source.alphaMap, { channel: 'g' });
  material.opacityMap = scaled(own ?? map(source.map, { channel: 'a' }), 1);
}

function applyPhysical(material: Material, source: SourceMaterial, map: FindMap, notes: Notes): void {
  const sheen = linear(source.sheenColor ?? 0).map((value) => value * source.sheen) as Rgb;
  applyLayers(
    material,
    {
      ...noLayers,
      clearcoat: {
        factor: source.clearcoat,
        roughness: source.clearcoatRoughness,
        texture: map(source.clearcoatMap, { channel: 'r' }),
        hasNormalMap: Boolean(source.clearcoatNormalMap),
      },
      sheen: {
        color: sheen,
        roughness: source.sheenRoughness,
        texture: map(source.sheenColorMap, { channel: 'g', colorSpace: 'srgb' }),
      },
      specular: {
        // three.js writes reflectivity, of which its MeshPhysicalMaterial makes the index.
        ior: source.ior ?? (1 + 0.4 * source.reflectivity) / (1 - 0.4 * source.reflectivity),
        factor: source.specularIntensity,
        color: linear(source.specularColor),
        texture: map(source.specularIntensityMap, { channel: 'a' }),
      },
      transmission: { factor: source.transmission, texture: map(source.transmissionMap, { channel: 'r' }) },
      volume: {
        thickness: source.thickness,
        color: linear(source.attenuationColor),
        distance: source.attenuationDistance ?? Number.POSITIVE_INFINITY,
      },
      anisotropy: {
        strength: source.anisotropy,
        rotation: source.anisotropyRotation,
        hasTexture: Boolean(source.anisotropyMap),
      },
      iridescence: source.iridescence,
      dispersion: source.dispersion,
    },
    notes,
  );
}
