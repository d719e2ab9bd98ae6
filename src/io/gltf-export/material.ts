/**
 * A document's materials as glTF's: `principled` and `principled-bsdf` by the same equations by which they are imported
 * (material-layers.ts), other models as far as they are like them. What glTF cannot say is told in a note.
 */
import { resolveParameters } from '../../brdf/values.ts';
import { findModel } from '../../scene/models.ts';
import type { Document, Material, TextureRef } from '../../scene/schema.ts';
import { iorOfThesisSpecular, reflectanceOfIor, reflectanceOfSpecular } from '../../scene/specular.ts';
import type { Notes } from '../gltf/notes.ts';
import type { GltfWriter, Json } from '../gltf/writer.ts';
import { coatRoughness, indexOf } from '../material-layers.ts';
import type { Channel, TextureExport, TextureInfo } from './textures.ts';

type Rgb = [number, number, number];
const clamp = (x: number, min = 0, max = 1): number => Math.min(max, Math.max(min, x));

/** What the models have in common, by the names that principled-bsdf gives it. */
interface Values {
  baseColor: Rgb;
  metallic: number;
  roughness: number;
  anisotropic: number;
  sheen: number;
  sheenTint: number;
  clearcoat: number;
  clearcoatGloss: number;
  /** Reflectance head-on of the dielectric. */
  r0: number;
  specTrans: number;
  diffTrans: number;
  thin: boolean;
  ior: number;
  transmissionColor: Rgb;
  transmissionDepth: number;
}

const plain: Values = {
  baseColor: [0.8, 0.8, 0.8],
  metallic: 0,
  roughness: 0.5,
  anisotropic: 0,
  sheen: 0,
  sheenTint: 0,
  clearcoat: 0,
  clearcoatGloss: 1,
  r0: 0.04,
  specTrans: 0,
  diffTrans: 0,
  thin: false,
  ior: 1.5,
  transmissionColor: [1, 1, 1],
  transmissionDepth: 0,
};

/** Returns the material's index in the file. */
export async function exportMaterial(
  document: Document,
  material: Material,
  writer: GltfWriter,
  textures: TextureExport,
  notes: Notes,
): Promise<number> {
  const values = valuesOf(document, material, notes);
  const maps = new Maps(material, textures, notes);
  const extensions: Json = {};
  const extend = (extension: string, value: Json): void => {
    extensions[extension] = value;
    writer.use(extension);
  };
  const isPrincipled = material.model.startsWith('principled');
  const metallicRoughness = isPrincipled
    ? await maps.pack({ g: 'roughness', b: 'metallic' }, 'roughness and metalness')
    : null;
  const hasRoughnessMap = metallicRoughness !== null && material.textures.roughness !== undefined;
  let { roughness } = values;
  if (values.anisotropic > 0) {
    // The inverse of what the import does: alpha_x alpha_y = roughness^4, alpha_x / alpha_y = 1 / (1 - .9 anisotropic).
    const ratio = Math.sqrt(1 - 0.9 * clamp(values.anisotropic));
    const across = clamp(roughness ** 2 * (hasRoughnessMap ? 1 : ratio), 1e-6, 1);
    const along = clamp(hasRoughnessMap ? across / ratio ** 2 : roughness ** 2 / ratio, across, 1);
    if (!hasRoughnessMap) roughness = Math.sqrt(across);
    const anisotropyStrength = across < 1 ? Math.sqrt((along - across) / (1 - across)) : 0;
    extend('KHR_materials_anisotropy', { anisotropyStrength });
  }
  if (values.clearcoat > 0) {
    const texture = await maps.pack({ r: 'clearcoat' }, 'clearcoat');
    extend('KHR_materials_clearcoat', {
      clearcoatFactor: clamp(values.clearcoat),
      clearcoatRoughnessFactor: coatRoughness(values.clearcoatGloss),
      ...(texture && { clearcoatTexture: texture }),
    });
  }
  if (values.sheen > 0) {
    const tint = tinted(values.baseColor, values.sheenTint);
    const brightest = Math.max(...tint);
    extend('KHR_materials_sheen', {
      sheenColorFactor: tint.map((value) => clamp((values.sheen * value) / brightest)),
      sheenRoughnessFactor: 0.5,
    });
    notes.add(`${material.name}: the width of its sheen is glTF's own`);
  }
  if (values.specTrans > 0 || values.diffTrans > 0) await addTransmission(values, maps, extend);
  else if (Math.abs(values.r0 - 0.04) > 1e-7)
    addSpecular(values.r0, await maps.pack({ a: 'specular' }, 'specular'), extend);
  if (values.ior !== 1.5 && values.specTrans > 0) extend('KHR_materials_ior', { ior: values.ior });

  const emission = emissionOf(material);
  if (emission.strength > 1)
    extend('KHR_materials_emissive_strength', { emissiveStrength: emission.strength });
  const base = await baseTexture(material, maps);
  const { normalMap, occlusionMap, emissiveMap } = material;
  const normal = normalMap && (await textures.whole(normalMap));
  const occlusion =
    occlusionMap &&
    (await textures.packed(
      { r: { ref: occlusionMap, channel: occlusionMap.channel ?? 'r' } },
      `${material.name}: occlusion`,
    ));
  const emissive = emissiveMap && (await textures.whole(emissiveMap));
  if (material.bumpMap) notes.add(`${material.name}: glTF has no bump maps; bake it into a normal map`);
  const alpha =
    material.alphaMode === 'opaque' ? 1 : clamp(material.opacity * (material.opacityMap?.scale ?? 1));
  return writer.add('materials', {
    name: material.name,
    pbrMetallicRoughness: {
      baseColorFactor: [...values.baseColor.map((value) => clamp(value)), alpha],
      ...(base && { baseColorTexture: base }),
      metallicFactor: clamp(values.metallic),
      roughnessFactor: clamp(roughness),
      ...(metallicRoughness && { metallicRoughnessTexture: metallicRoughness }),
    },
    ...(normal && { normalTexture: { ...normal, scale: normalMap.scale } }),
    ...(occlusion && { occlusionTexture: { ...occlusion, strength: clamp(occlusionMap.scale) } }),
    ...(emission.strength > 0 && { emissiveFactor: emission.factor }),
    ...(emissive && { emissiveTexture: emissive }),
    ...(material.alphaMode !== 'opaque' && { alphaMode: material.alphaMode.toUpperCase() }),
    ...(material.alphaMode === 'mask' && { alphaCutoff: material.alphaCutoff }),
    ...(material.doubleSided && { doubleSided: true }),
    ...(Object.keys(extensions).length > 0 && { extensions }),
  });
}

function valuesOf(document: Document, material: Material, notes: Notes): Values {
  const { name } = material;
  const model = findModel(document, material.model);
  const p = model ? resolveParameters(model.file, material.parameters) : {};
  const lose = (parameter: string, what: string): void => {
    const value = p[parameter];
    if (typeof value === 'number' ? value > 0 : Array.isArray(value) && Math.max(...value) > 0)
      notes.add(`${name}: ${what} has no counterpart in glTF`);
  };
  const known = { ...plain, ...(p as Partial<Values>) };
  switch (material.model) {
    case 'principled':
    case 'principled-thesis': {
      lose('subsurface', 'subsurface');
      lose('specularTint', 'the tint of its reflection');
      if (material.model === 'principled-thesis')
        notes.add(`${name}: principled-thesis is written as principled, which it is nearly`);
      const specular = Number(p.specular);
      const r0 =
        material.model === 'principled'
          ? reflectanceOfSpecular(specular)
          : reflectanceOfIor(iorOfThesisSpecular(specular));
      return { ...known, r0, ior: 1.5 };
    }
    case 'principled-bsdf':
      lose('scatter', 'scattering inside');
      lose('specularTint', 'the tint of its reflection');
      return { ...known, r0: reflectanceOfIor(known.ior) };
    case 'dielectric':
      lose('scatter', 'scattering inside');
      return { ...known, baseColor: [1, 1, 1], specTrans: 1 };
    case 'lambert':
      return { ...plain, baseColor: p.albedo as Rgb, roughness: 1, r0: 0 };
    case 'cook-torrance': {
      notes.add(
        `${name}: cook-torrance is written as glTF's material, whose distribution of facets is another`,
      );
      const ior = Number(p.ior);
      // Beckmann's root mean square slope is GGX's alpha, which is the square of the roughness.
      const roughness = Math.sqrt(clamp(Number(p.roughness)));
      return {
        ...plain,
        baseColor: p.albedo as Rgb,
        metallic: known.metallic,
        roughness,
        r0: reflectanceOfIor(ior),
      };
    }
    default: {
      notes.add(
        `${name}: glTF cannot describe the model ${material.model}; it is written in its colour alone. Fit principled to it before, to keep its look`,
      );
      const color = Object.values(p).find((value): value is Rgb => Array.isArray(value));
      return { ...plain, baseColor: color ? (color.map((value) => clamp(value)) as Rgb) : plain.baseColor };
    }
  }
}

/** White that turns into a colour's hue, as principled has it. */
function tinted(color: Rgb, amount: number): Rgb {
  const luminance = 0.3 * color[0] + 0.6 * color[1] + 0.1 * color[2];
  if (!(luminance > 1e-10)) return [1, 1, 1];
  return color.map((value) => 1 - amount + (amount * value) / luminance) as Rgb;
}

type Extend = (extension: string, value: Json) => void;

/** Up to 4 % the strength of glTF's reflection says it, beyond that the index of refraction. */
function addSpecular(r0: number, texture: TextureInfo | null, extend: Extend): void {
  if (r0 > 0.04) extend('KHR_materials_ior', { ior: indexOf(r0) });
  if (r0 < 0.04 || texture)
    extend('KHR_materials_specular', {
      specularFactor: Math.min(1, r0 / 0.04),
      ...(texture && { specularTexture: texture }),
    });
}

async function addTransmission(values: Values, maps: Maps, extend: Extend): Promise<void> {
  if (values.specTrans > 0) {
    const texture = await maps.pack({ r: 'specTrans' }, 'transmission');
    extend('KHR_materials_transmission', {
      transmissionFactor: clamp(values.specTrans),
      ...(texture && { transmissionTexture: texture }),
    });
  }
  if (values.diffTrans > 0 && values.thin)
    extend('KHR_materials_diffuse_transmission', {
      diffuseTransmissionFactor: clamp(values.diffTrans),
      diffuseTransmissionColorFactor: values.baseColor,
    });
  if (values.thin) return;
  extend('KHR_materials_volume', {
    // What has a true body needs no thickness but that it has one.
    thicknessFactor: 1,
    ...(values.transmissionDepth > 0 && {
      attenuationColor: values.transmissionColor,
      attenuationDistance: values.transmissionDepth,
    }),
  });
}

function emissionOf({ emissive, emissiveIntensity, emissiveMap }: Material): {
  factor: number[];
  strength: number;
} {
  const strength = emissiveIntensity * (emissiveMap?.scale ?? 1);
  if (!(Math.max(...emissive) > 0)) return { factor: [0, 0, 0], strength: 0 };
  // Up to 1 the factor alone says it.
  return strength > 1
    ? { factor: [...emissive], strength }
    : { factor: emissive.map((value) => value * strength), strength };
}

/** Colour and opacity are one texture in glTF. */
async function baseTexture(material: Material, maps: Maps): Promise<TextureInfo | null> {
  const { opacityMap } = material;
  const color =
    material.textures[
      material.model === 'lambert' || material.model === 'cook-torrance' ? 'albedo' : 'baseColor'
    ];
  return maps.colorAndOpacity(color ?? null, material.alphaMode === 'opaque' ? null : opacityMap);
}

class Maps {
  constructor(
    readonly material: Material,
    readonly textures: TextureExport,
    readonly notes: Notes,
  ) {}

  /** The textures of parameters in the channels that glTF reads. */
  pack(parameters: Partial<Record<Channel, string>>, what: string): Promise<TextureInfo | null> {
    const parts = Object.entries(parameters).flatMap(([to, parameter]) => {
      const ref = this.material.textures[parameter];
      return ref ? [[to, { ref, channel: ref.channel ?? (to as Channel) }] as const] : [];
    });
    return this.textures.packed(Object.fromEntries(parts), `${this.material.name}: ${what}`);
  }

  async colorAndOpacity(color: TextureRef | null, opacity: TextureRef | null): Promise<TextureInfo | null> {
    const what = `${this.material.name}: colour and opacity`;
    const alpha = opacity && { a: { ref: opacity, channel: opacity.channel ?? ('a' as const) } };
    if (color === null) return alpha ? this.textures.packed(alpha, what) : null;
    if (color.colorSpace === 'linear')
      this.notes.add(`${this.material.name}: its colour texture is linear, which glTF takes for sRGB`);
    const rgb = (['r', 'g', 'b'] as const).map(
      (to) => [to, { ref: color, channel: color.channel ?? to }] as const,
    );
    return this.textures.packed({ ...Object.fromEntries(rgb), ...alpha }, what);
  }
}
