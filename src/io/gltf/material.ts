/**
 * glTF materials as `principled`. Section numbers are glTF 2.0's; extensions are Khronos's. What
 * has no counterpart is told in a note.
 */
import { MathUtils } from 'three/webgpu';
import { z } from 'zod';
import { materialDefaults, textureRef } from '../../scene/material-schema.ts';
import type { Material, ScaledTextureRef, TextureRef } from '../../scene/schema.ts';
import { imageIndex } from './file.ts';
import type { Notes } from './notes.ts';
import {
  type Gltf,
  type GltfMaterial,
  type GltfTextureInfo,
  textureInfoSchema,
  transformSchema,
} from './schema.ts';

type Rgb = [number, number, number];

/** Without a material, 3.9: the defaults of every field. */
const unnamed: GltfMaterial = {
  emissiveFactor: [0, 0, 0],
  alphaMode: 'OPAQUE',
  alphaCutoff: 0.5,
  doubleSided: false,
};

const unmapped: Readonly<Record<string, string>> = {
  KHR_materials_transmission: 'transmission',
  KHR_materials_volume: 'volume',
  KHR_materials_iridescence: 'iridescence',
  KHR_materials_dispersion: 'dispersion',
  KHR_materials_diffuse_transmission: 'diffuse transmission',
  KHR_materials_unlit: 'unlit shading',
  KHR_materials_pbrSpecularGlossiness: 'the specular-glossiness workflow',
};

/** `asset` is the id of the file among the document's assets. */
export function convertMaterial(
  gltf: Gltf,
  index: number | undefined,
  asset: string,
  notes: Notes,
): Material {
  const source = (index === undefined ? undefined : gltf.materials[index]) ?? unnamed;
  const name =
    (source.name ?? '').slice(0, 180) || (index === undefined ? 'Default' : `Material ${index + 1}`);
  const texture = (info: GltfTextureInfo | undefined, values: Partial<TextureRef>): TextureRef | null =>
    info === undefined ? null : convertTexture(gltf, info, asset, values, notes);
  const scaled = (info: GltfTextureInfo | undefined, scale: number, values: Partial<TextureRef>) => {
    const ref = texture(info, values);
    return ref === null
      ? null
      : ({ ...ref, scale: MathUtils.clamp(scale, -100, 100) } satisfies ScaledTextureRef);
  };

  const pbr = source.pbrMetallicRoughness;
  const [r, g, b, alpha] = pbr?.baseColorFactor ?? [1, 1, 1, 1];
  const material: Material = {
    ...structuredClone(materialDefaults),
    name,
    model: 'principled',
    parameters: {
      baseColor: [r, g, b],
      metallic: pbr?.metallicFactor ?? 1,
      roughness: pbr?.roughnessFactor ?? 1,
    },
    normalMap: scaled(source.normalTexture, source.normalTexture?.scale ?? 1, {}),
    occlusionMap: scaled(source.occlusionTexture, source.occlusionTexture?.strength ?? 1, { channel: 'r' }),
    emissiveMap: scaled(source.emissiveTexture, 1, { colorSpace: 'srgb' }),
    opacityMap:
      source.alphaMode === 'OPAQUE'
        ? null
        : scaled(pbr?.baseColorTexture, 1, { colorSpace: 'srgb', channel: 'a' }),
    alphaMode: ({ OPAQUE: 'opaque', MASK: 'mask', BLEND: 'blend' } as const)[source.alphaMode],
    alphaCutoff: MathUtils.clamp(source.alphaCutoff, 0, 1),
    opacity: source.alphaMode === 'OPAQUE' ? 1 : MathUtils.clamp(alpha, 0, 1),
    doubleSided: source.doubleSided,
  };
  setTexture(material, 'baseColor', texture(pbr?.baseColorTexture, { colorSpace: 'srgb' }));
  setTexture(material, 'metallic', texture(pbr?.metallicRoughnessTexture, { channel: 'b' }));
  setTexture(material, 'roughness', texture(pbr?.metallicRoughnessTexture, { channel: 'g' }));
  setEmission(material, source);
  setExtensions(material, source, texture, notes);
  for (const [extension, what] of Object.entries(unmapped))
    if (source.extensions?.[extension] !== undefined) notes.add(`${name}: ${what} has no counterpart`);
  return material;
}

function setTexture(material: Material, parameter: string, texture: TextureRef | null): void {
  if (texture !== null) material.textures[parameter] = texture;
}

/** The document keeps hue and strength apart; glTF's factor is both. */
function setEmission(material: Material, { emissiveFactor, extensions }: GltfMaterial): void {
  const strength = read(extensions, 'KHR_materials_emissive_strength', {
    emissiveStrength: z.number().default(1),
  });
  const brightest = Math.max(...emissiveFactor);
  if (!(brightest > 0)) return;
  material.emissive = emissiveFactor.map((value) => MathUtils.clamp(value / brightest, 0, 1)) as Rgb;
  material.emissiveIntensity = MathUtils.clamp(brightest * (strength?.emissiveStrength ?? 1), 0, 1e9);
}

function setExtensions(
  material: Material,
  { extensions }: GltfMaterial,
  texture: (info: GltfTextureInfo | undefined, values: Partial<TextureRef>) => TextureRef | null,
  notes: Notes,
): void {
  const { parameters, name } = material;
  const map = textureInfoSchema.optional();

  const coat = read(extensions, 'KHR_materials_clearcoat', {
    clearcoatFactor: z.number().default(0),
    clearcoatTexture: map,
    clearcoatRoughnessFactor: z.number().default(0),
    clearcoatNormalTexture: map,
  });
  if (coat !== null && coat.clearcoatFactor > 0) {
    parameters.clearcoat = coat.clearcoatFactor;
    setTexture(material, 'clearcoat', texture(coat.clearcoatTexture, { channel: 'r' }));
    // principled: alpha = mix(.1, .001, gloss); glTF: alpha = roughness^2.
    const alpha = coat.clearcoatRoughnessFactor ** 2;
    parameters.clearcoatGloss = MathUtils.clamp((0.1 - alpha) / 0.099, 0, 1);
    if (alpha > 0.1) notes.add(`${name}: the clearcoat is rougher than principled's can be`);
    if (coat.clearcoatNormalTexture) notes.add(`${name}: the clearcoat's own normal map has no counterpart`);
  }

  const sheen = read(extensions, 'KHR_materials_sheen', {
    sheenColorFactor: z.tuple([z.number(), z.number(), z.number()]).default([0, 0, 0]),
    sheenColorTexture: map,
  });
  const glow = Math.max(...(sheen?.sheenColorFactor ?? [0]));
  if (sheen !== null && glow > 0) {
    parameters.sheen = glow;
    // principled tints between white and the base colour's hue: by how far the sheen is from grey.
    parameters.sheenTint = MathUtils.clamp(1 - Math.min(...sheen.sheenColorFactor) / glow, 0, 1);
    setTexture(material, 'sheen', texture(sheen.sheenColorTexture, { channel: 'g', colorSpace: 'srgb' }));
    notes.add(`${name}: the sheen's roughness and its own colour have no counterpart`);
  }

  const { ior } = read(extensions, 'KHR_materials_ior', { ior: z.number().default(1.5) }) ?? { ior: 1.5 };
  const specular = read(extensions, 'KHR_materials_specular', {
    specularFactor: z.number().default(1),
    specularTexture: map,
    specularColorFactor: z.array(z.number()).default([1, 1, 1]),
  });
  // principled: R0 = .08 specular; R0 = ((n - 1) / (n + 1))^2. An ior of 0 stands for R0 = 1.
  const reflectance = (ior > 0 ? ((ior - 1) / (ior + 1)) ** 2 : 1) * (specular?.specularFactor ?? 1);
  if (Math.abs(reflectance - 0.04) > 1e-6) parameters.specular = reflectance / 0.08;
  setTexture(material, 'specular', texture(specular?.specularTexture, { channel: 'a' }));
  if (specular?.specularColorFactor.some((value) => value !== 1))
    notes.add(`${name}: the colour of the specular reflection has no counterpart`);

  setAnisotropy(material, extensions, notes);
}

function setAnisotropy(material: Material, extensions: GltfMaterial['extensions'], notes: Notes): void {
  const found = read(extensions, 'KHR_materials_anisotropy', {
    anisotropyStrength: z.number().default(0),
    anisotropyRotation: z.number().default(0),
    anisotropyTexture: textureInfoSchema.optional(),
  });
  if (found === null || !(found.anisotropyStrength > 0)) return;
  const { parameters, name } = material;
  // glTF: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha.
  // principled: alpha_x / alpha_y = 1 / (1 - .9 anisotropic), alpha_x alpha_y = roughness^4.
  const across = Math.max(Number(parameters.roughness) ** 2, 1e-3);
  const along = MathUtils.lerp(across, 1, Math.min(found.anisotropyStrength, 1) ** 2);
  parameters.anisotropic = MathUtils.clamp((1 - across / along) / 0.9, 0, 1);
  if (material.textures.roughness === undefined) parameters.roughness = (across * along) ** 0.25;
  if (found.anisotropyRotation !== 0) notes.add(`${name}: the rotation of the anisotropy has no counterpart`);
  if (found.anisotropyTexture) notes.add(`${name}: the anisotropy's texture has no counterpart`);
}

function read<S extends z.ZodRawShape>(extensions: GltfMaterial['extensions'], name: string, shape: S) {
  const value = extensions?.[name];
  if (value === undefined) return null;
  const result = z.looseObject(shape).safeParse(value);
  return result.success ? result.data : null;
}

const wraps: Readonly<Record<number, TextureRef['wrap']>> = {
  10497: 'repeat',
  33648: 'mirror',
  33071: 'clamp',
};

function convertTexture(
  gltf: Gltf,
  info: GltfTextureInfo,
  asset: string,
  values: Partial<TextureRef>,
  notes: Notes,
): TextureRef | null {
  const found = gltf.textures[info.index];
  if (found === undefined || imageIndex(found) === undefined) {
    notes.add(`textures[${info.index}] is in a format that is not read (PNG, JPEG, WebP and AVIF are)`);
    return null;
  }
  const sampler = gltf.samplers[found.sampler ?? -1];
  if (sampler && sampler.wrapS !== sampler.wrapT)
    notes.add(`textures[${info.index}] wraps differently along its sides; both wrap as along the first`);
  const ref = textureRef(asset, {
    texture: info.index,
    uv: info.texCoord,
    wrap: wraps[sampler?.wrapS ?? 10497] ?? 'repeat',
    ...values,
  });
  const transform = transformSchema.safeParse(info.extensions?.KHR_texture_transform);
  if (transform.success) setTransform(ref, transform.data, `textures[${info.index}]`, notes);
  return ref;
}

/**
 * KHR_texture_transform has v downwards and rotates what has been scaled; here v is upwards
 * and what has been rotated is scaled. With p = (u, 1 - v):
 * p' = R S p + offset becomes a rotation by the opposite angle and the offset below.
 */
function setTransform(
  ref: TextureRef,
  t: z.output<typeof transformSchema>,
  name: string,
  notes: Notes,
): void {
  const [sx, sy] = t.scale;
  const [ox, oy] = t.offset;
  const [cos, sin] = [Math.cos(t.rotation), Math.sin(t.rotation)];
  ref.repeat = [sx, sy];
  ref.rotation = MathUtils.radToDeg(-t.rotation) % 360;
  ref.offset = [sin * sy + ox, 1 - cos * sy - oy];
  if (t.texCoord !== undefined) ref.uv = t.texCoord;
  if (sx !== sy && sin !== 0) notes.add(`${name} is both rotated and scaled unevenly, which is approximated`);
}
