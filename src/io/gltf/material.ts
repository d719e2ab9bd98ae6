/**
 * glTF materials as `principled`, or `principled-bsdf` where light goes through. Section numbers are glTF 2.0's; extensions are Khronos's. What
 * has no counterpart is told in a note.
 */
import { MathUtils } from 'three/webgpu';
import { z } from 'zod';
import { materialDefaults, textureRef } from '../../scene/material-schema.ts';
import type { Material, ScaledTextureRef, TextureRef } from '../../scene/schema.ts';
import { applyLayers, type Layers, makeUnlit } from '../material-layers.ts';
import type { Notes } from './notes.ts';
import {
  type Gltf,
  type GltfMaterial,
  type GltfTextureInfo,
  imageIndex,
  textureInfoSchema,
  transformSchema,
} from './schema.ts';
import { fromKhr, isApproximate } from './transform.ts';
import { noteMaterial } from './unread.ts';

type Rgb = [number, number, number];

/** Without a material, 3.9: the defaults of every field. */
const unnamed: GltfMaterial = {
  emissiveFactor: [0, 0, 0],
  alphaMode: 'OPAQUE',
  alphaCutoff: 0.5,
  doubleSided: false,
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
  setSpecularGlossiness(material, source.extensions, texture, notes);
  applyLayers(material, layersOf(source.extensions, texture), notes);
  noteMaterial(source.extensions, name, notes);
  if (source.extensions?.KHR_materials_unlit !== undefined) makeUnlit(material, notes);
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

/** KHR_materials_* */
function layersOf(
  extensions: GltfMaterial['extensions'],
  texture: (info: GltfTextureInfo | undefined, values: Partial<TextureRef>) => TextureRef | null,
): Layers {
  const map = textureInfoSchema.optional();
  const number = (value: number) => z.number().default(value);
  const rgb = (value: number) => z.tuple([z.number(), z.number(), z.number()]).default([value, value, value]);
  const ext = <S extends z.ZodRawShape>(name: string, shape: S) =>
    read(extensions, `KHR_materials_${name}`, shape);

  const coat = ext('clearcoat', {
    clearcoatFactor: number(0),
    clearcoatTexture: map,
    clearcoatRoughnessFactor: number(0),
    clearcoatNormalTexture: map,
  });
  const sheen = ext('sheen', {
    sheenColorFactor: rgb(0),
    sheenColorTexture: map,
    sheenRoughnessFactor: number(0),
  });
  const specular = ext('specular', {
    specularFactor: number(1),
    specularTexture: map,
    specularColorFactor: rgb(1),
  });
  const transmission = ext('transmission', { transmissionFactor: number(0), transmissionTexture: map });
  const volume = ext('volume', {
    thicknessFactor: number(0),
    attenuationColor: rgb(1),
    attenuationDistance: number(Number.MAX_VALUE),
  });
  const diffuse = ext('diffuse_transmission', {
    diffuseTransmissionFactor: number(0),
    diffuseTransmissionTexture: map,
    diffuseTransmissionColorFactor: rgb(1),
  });
  const anisotropy = ext('anisotropy', {
    anisotropyStrength: number(0),
    anisotropyRotation: number(0),
    anisotropyTexture: map,
  });
  const distance = volume?.attenuationDistance ?? Number.MAX_VALUE;
  return {
    clearcoat: {
      factor: coat?.clearcoatFactor ?? 0,
      roughness: coat?.clearcoatRoughnessFactor ?? 0,
      texture: texture(coat?.clearcoatTexture, { channel: 'r' }),
      hasNormalMap: coat?.clearcoatNormalTexture !== undefined,
    },
    sheen: {
      color: sheen?.sheenColorFactor ?? [0, 0, 0],
      roughness: sheen?.sheenRoughnessFactor ?? 0,
      texture: texture(sheen?.sheenColorTexture, { channel: 'g', colorSpace: 'srgb' }),
    },
    specular: {
      ior: ext('ior', { ior: number(1.5) })?.ior ?? 1.5,
      factor: specular?.specularFactor ?? 1,
      color: specular?.specularColorFactor ?? [1, 1, 1],
      texture: texture(specular?.specularTexture, { channel: 'a' }),
    },
    transmission: {
      factor: transmission?.transmissionFactor ?? 0,
      texture: texture(transmission?.transmissionTexture, { channel: 'r' }),
    },
    volume: {
      thickness: volume?.thicknessFactor ?? 0,
      color: volume?.attenuationColor ?? [1, 1, 1],
      distance: distance < Number.MAX_VALUE ? distance : Number.POSITIVE_INFINITY,
    },
    diffuseTransmission: {
      factor: diffuse?.diffuseTransmissionFactor ?? 0,
      color: diffuse?.diffuseTransmissionColorFactor ?? [1, 1, 1],
      texture: texture(diffuse?.diffuseTransmissionTexture, { channel: 'a' }),
    },
    anisotropy: {
      strength: anisotropy?.anisotropyStrength ?? 0,
      rotation: anisotropy?.anisotropyRotation ?? 0,
      hasTexture: anisotropy?.anisotropyTexture !== undefined,
    },
    iridescence: ext('iridescence', { iridescenceFactor: number(0) })?.iridescenceFactor ?? 0,
    dispersion: ext('dispersion', { dispersion: number(0) })?.dispersion ?? 0,
  };
}

/**
 * KHR_materials_pbrSpecularGlossiness, the older workflow, as metallic and roughness: by solving its blend of a dielectric
 * of 4 % and a metal for the metal's part, as the extension's own sample conversion does.
 */
function setSpecularGlossiness(
  material: Material,
  extensions: GltfMaterial['extensions'],
  texture: (info: GltfTextureInfo | undefined, values: Partial<TextureRef>) => TextureRef | null,
  notes: Notes,
): void {
  const found = read(extensions, 'KHR_materials_pbrSpecularGlossiness', {
    diffuseFactor: z.array(z.number()).length(4).default([1, 1, 1, 1]),
    diffuseTexture: textureInfoSchema.optional(),
    specularFactor: z.array(z.number()).length(3).default([1, 1, 1]),
    glossinessFactor: z.number().default(1),
    specularGlossinessTexture: textureInfoSchema.optional(),
  });
  if (found === null) return;
  const diffuse = found.diffuseFactor.slice(0, 3);
  const map = texture(found.diffuseTexture, { colorSpace: 'srgb' });
  setTexture(material, 'baseColor', map);
  const roughness = MathUtils.clamp(1 - found.glossinessFactor, 0, 1);
  if (found.specularGlossinessTexture) {
    notes.add(
      `${material.name}: its specular-glossiness map has no counterpart; it is taken for a dielectric`,
    );
    material.parameters = { baseColor: diffuse as Rgb, metallic: 0, roughness: 0.5 };
    return;
  }
  const brightness = ([r = 0, g = 0, b = 0]: readonly number[]) =>
    Math.sqrt(0.299 * r * r + 0.587 * g * g + 0.114 * b * b);
  const specular = found.specularFactor;
  const left = 1 - Math.max(...specular);
  const dielectric = 0.04;
  const b = (brightness(diffuse) * left) / (1 - dielectric) + brightness(specular) - 2 * dielectric;
  const root = Math.sqrt(Math.max(0, b * b - 4 * dielectric * (dielectric - brightness(specular))));
  const metallic =
    brightness(specular) < dielectric ? 0 : MathUtils.clamp((root - b) / (2 * dielectric), 0, 1);
  const baseColor = diffuse.map((value, c) => {
    const fromDiffuse = (value * left) / (1 - dielectric) / Math.max(1 - metallic, 1e-6);
    const fromSpecular = ((specular[c] ?? 0) - dielectric * (1 - metallic)) / Math.max(metallic, 1e-6);
    return MathUtils.clamp(MathUtils.lerp(fromDiffuse, fromSpecular, metallic ** 2), 0, 1);
  });
  material.parameters = { baseColor: baseColor as Rgb, metallic, roughness };
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
    notes.add(`textures[${info.index}] is in a format that is not read (PNG, JPEG, WebP, AVIF and KTX2 are)`);
    return null;
  }
  // It did not come along, which readGltf has told.
  if (gltf.images[imageIndex(found) ?? -1]?.bufferView === undefined) return null;
  const sampler = gltf.samplers[found.sampler ?? -1];
  if (sampler && sampler.wrapS !== sampler.wrapT)
    notes.add(`textures[${info.index}] wraps differently along its sides; both wrap as along the first`);
  // 9728 is NEAREST.
  if (sampler?.magFilter === 9728)
    notes.add(`textures[${info.index}] is shown smooth from near, not in squares`);
  const ref = textureRef(asset, {
    texture: info.index,
    uv: info.texCoord,
    wrap: wraps[sampler?.wrapS ?? 10497] ?? 'repeat',
    ...values,
  });
  const transform = transformSchema.safeParse(info.extensions?.KHR_texture_transform);
  if (transform.success) {
    Object.assign(ref, fromKhr(transform.data));
    if (transform.data.texCoord !== undefined) ref.uv = transform.data.texCoord;
    if (isApproximate(ref))
      notes.add(`textures[${info.index}] is both rotated and scaled unevenly, which is approximated`);
  }
  return ref;
}
