/**
 * What glTF's material extensions and three.js's MeshPhysicalMaterial have in common, as parameters of `principled`, or
 * of `principled-bsdf` where light goes through. Extensions are Khronos's (KHR_materials_*); their parameters and
 * three.js's are the same ones under other names. What has no counterpart is told in a note.
 */

import type { Material, TextureRef } from '../scene/schema.ts';
import { reflectanceOfIor, specularOfReflectance } from '../scene/specular.ts';
import type { Notes } from './gltf/notes.ts';

type Rgb = readonly [number, number, number];
type Texture = TextureRef | null;

/** Factors at 0 are layers that are not there. */
export interface Layers {
  clearcoat: { factor: number; roughness: number; texture: Texture; hasNormalMap: boolean };
  sheen: { color: Rgb; roughness: number; texture: Texture };
  specular: { ior: number; factor: number; color: Rgb; texture: Texture };
  transmission: { factor: number; texture: Texture };
  /** A thickness of 0 is a sheet, which encloses nothing. */
  volume: { thickness: number; color: Rgb; distance: number };
  diffuseTransmission: { factor: number; color: Rgb; texture: Texture };
  anisotropy: { strength: number; rotation: number; hasTexture: boolean };
  iridescence: number;
  dispersion: number;
}

export const noLayers: Layers = {
  clearcoat: { factor: 0, roughness: 0, texture: null, hasNormalMap: false },
  sheen: { color: [0, 0, 0], roughness: 0, texture: null },
  specular: { ior: 1.5, factor: 1, color: [1, 1, 1], texture: null },
  transmission: { factor: 0, texture: null },
  volume: { thickness: 0, color: [1, 1, 1], distance: Number.POSITIVE_INFINITY },
  diffuseTransmission: { factor: 0, color: [1, 1, 1], texture: null },
  anisotropy: { strength: 0, rotation: 0, hasTexture: false },
  iridescence: 0,
  dispersion: 0,
};

export function applyLayers(material: Material, layers: Layers, notes: Notes): void {
  setClearcoat(material, layers.clearcoat, notes);
  setSheen(material, layers.sheen, notes);
  if (layers.transmission.factor > 0 || layers.diffuseTransmission.factor > 0)
    setTransmission(material, layers, notes);
  else setSpecular(material, layers.specular);
  const { color } = layers.specular;
  if (Math.max(...color) - Math.min(...color) > 1e-3)
    notes.add(`${material.name}: the colour of the specular reflection has no counterpart`);
  setAnisotropy(material, layers.anisotropy, notes);
  if (layers.iridescence > 0) notes.add(`${material.name}: iridescence has no counterpart`);
  if (layers.dispersion > 0) notes.add(`${material.name}: dispersion has no counterpart`);
}

const clamp = (x: number, min = 0, max = 1): number => Math.min(max, Math.max(min, x));

function setClearcoat(material: Material, coat: Layers['clearcoat'], notes: Notes): void {
  if (!(coat.factor > 0)) return;
  const { parameters, name } = material;
  parameters.clearcoat = coat.factor;
  if (coat.texture) material.textures.clearcoat = coat.texture;
  parameters.clearcoatGloss = coatGloss(coat.roughness);
  if (coat.roughness ** 2 > 0.1) notes.add(`${name}: the clearcoat is rougher than principled's can be`);
  if (coat.hasNormalMap) notes.add(`${name}: the clearcoat's own normal map has no counterpart`);
}

/** principled: alpha = mix(.1, .001, gloss); glTF: alpha = roughness^2. */
export const coatGloss = (roughness: number): number => clamp((0.1 - roughness ** 2) / 0.099);
export const coatRoughness = (gloss: number): number => Math.sqrt(0.1 - 0.099 * clamp(gloss));

function setSheen(material: Material, { color, texture }: Layers['sheen'], notes: Notes): void {
  const glow = Math.max(...color);
  if (!(glow > 0)) return;
  material.parameters.sheen = glow;
  // principled tints between white and the base colour's hue: by how far the sheen is from grey.
  material.parameters.sheenTint = clamp(1 - Math.min(...color) / glow);
  if (texture) material.textures.sheen = texture;
  notes.add(`${material.name}: the sheen's roughness and its own colour have no counterpart`);
}

/** Reflectance head-on; an ior of 0 stands for 1 (KHR_materials_ior). */
const reflectance = (ior: number): number => (ior > 0 ? reflectanceOfIor(ior) : 1);
/** The index of refraction that reflects as much head-on. */
export const indexOf = (r0: number): number => {
  const root = Math.sqrt(clamp(r0, 0, 0.999));
  return (1 + root) / (1 - root);
};

function setSpecular(material: Material, { ior, factor, color, texture }: Layers['specular']): void {
  // principled: R0 = .08 specular.
  const r0 = Math.min(1, reflectance(ior) * Math.max(...color)) * factor;
  if (Math.abs(r0 - 0.04) > 1e-6) material.parameters.specular = specularOfReflectance(r0);
  if (texture) material.textures.specular = texture;
}

function setTransmission(material: Material, layers: Layers, notes: Notes): void {
  const { transmission, volume, diffuseTransmission, specular } = layers;
  const { parameters, name } = material;
  material.model = 'principled-bsdf';
  parameters.specTrans = clamp(transmission.factor);
  if (transmission.texture) material.textures.specTrans = transmission.texture;
  const r0 = reflectance(specular.ior) * specular.factor;
  parameters.ior = specular.factor === 1 && specular.ior > 0 ? specular.ior : indexOf(r0);
  if (specular.factor !== 1 || specular.texture)
    notes.add(`${name}: the strength of its reflection became its index of refraction`);
  const thin = !(volume.thickness > 0);
  parameters.thin = thin;
  if (!thin && Number.isFinite(volume.distance) && volume.distance > 0) {
    parameters.transmissionColor = [...volume.color];
    parameters.transmissionDepth = volume.distance;
  }
  if (diffuseTransmission.factor > 0) {
    parameters.diffTrans = clamp(diffuseTransmission.factor);
    if (diffuseTransmission.texture) material.textures.diffTrans = diffuseTransmission.texture;
    parameters.thin = true;
    notes.add(`${name}: light that its sheet lets through diffusely has the base colour`);
  }
  notes.add(
    `${name}: light goes through it in the path traced picture; the interactive one shows its reflection`,
  );
}

function setAnisotropy(
  material: Material,
  { strength, rotation, hasTexture }: Layers['anisotropy'],
  notes: Notes,
): void {
  if (!(strength > 0)) return;
  const { parameters, name } = material;
  // glTF: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha.
  // principled: alpha_x / alpha_y = 1 / (1 - .9 anisotropic), alpha_x alpha_y = roughness^4.
  const across = Math.max(Number(parameters.roughness) ** 2, 1e-3);
  const along = across + (1 - across) * Math.min(strength, 1) ** 2;
  parameters.anisotropic = clamp((1 - across / along) / 0.9);
  if (material.textures.roughness === undefined) parameters.roughness = (across * along) ** 0.25;
  if (rotation !== 0) notes.add(`${name}: the rotation of the anisotropy has no counterpart`);
  if (hasTexture) notes.add(`${name}: the anisotropy's texture has no counterpart`);
}

/** A surface that looks the same in any light: what it shows becomes light of its own. */
export function makeUnlit(material: Material, notes: Notes): void {
  const { parameters, textures } = material;
  const color = (parameters.baseColor ?? [1, 1, 1]) as Rgb;
  const brightest = Math.max(...color, 1e-6);
  material.emissive = color.map((value) => clamp(value / brightest)) as [number, number, number];
  material.emissiveIntensity = brightest;
  const { baseColor } = textures;
  material.emissiveMap = baseColor ? { ...baseColor, scale: 1 } : null;
  material.parameters = { baseColor: [0, 0, 0], metallic: 0, roughness: 1, specular: 0 };
  material.textures = {};
  notes.add(`${material.name}: it is unlit, so its colour is light that it emits`);
}
