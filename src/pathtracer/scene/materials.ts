import type { ParameterValue } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import { luminance } from '../../color/rec709.ts';
import type { Model } from '../../glsl/model.ts';
import type { Material, ScaledTextureRef } from '../../scene/schema.ts';
import type { Texels } from '../../scene/texels.ts';
import type { TabulatedMaterial } from './generic-table.ts';
import {
  CHANNEL_SHIFT,
  CHANNELS,
  GENERIC_TABLE,
  MATERIAL,
  MATERIAL_FLAGS,
  MATERIAL_SLOTS,
} from './layout.ts';
import { type Rgba, type Texture, type TextureTable, texelSampler } from './textures.ts';
import type { Words } from './words.ts';

type Rgb = [number, number, number];

/** A material with what it is made of. */
export interface UsedMaterial {
  readonly material: Material;
  readonly model: Model;
  /** Its model's place among the scene's. */
  readonly modelIndex: number;
}

/** What a surface emits. */
export interface Emission {
  /** In nits times colour. */
  readonly radiance: Rgb;
  /** Multiplies it. */
  readonly map: Texture | null;
  readonly doubleSided: boolean;
}

/** Null if the material does not shine. */
export function emissionOf({ material, model }: UsedMaterial, textures: TextureTable): Emission | null {
  const radiance = radianceOf(material);
  if (luminance(radiance) === 0) return null;
  return { radiance, map: textures.find(material.emissiveMap), doubleSided: showsBacks(material, model) };
}

/** Light inside a transparent body meets its surface from behind. */
function showsBacks({ doubleSided }: Material, { file }: Model): boolean {
  return doubleSided || file.transmission !== null;
}

function radianceOf({ emissive, emissiveIntensity, emissiveMap }: Material): Rgb {
  const strength = Math.max(0, emissiveIntensity * (emissiveMap?.scale ?? 1));
  return emissive.map((component) => component * strength) as Rgb;
}

/**
 * Writes the materials, one behind the other.
 *
 * @param tableSlots of the generic sampler's tables, 0 for none
 * @returns the first one's slot
 */
export function writeMaterials(
  words: Words,
  materials: readonly UsedMaterial[],
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
  tableSlots: readonly number[],
): number {
  const first = words.allocate(materials.length * MATERIAL_SLOTS);
  for (const [i, used] of materials.entries())
    writeMaterial(words, first + i * MATERIAL_SLOTS, used, textures, wordOf, tableSlots[i] ?? 0);
  return first;
}

function writeMaterial(
  words: Words,
  slot: number,
  { material, model, modelIndex }: UsedMaterial,
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
  tableSlot: number,
): void {
  const { alphaMode, opacity, opacityMap, alphaCutoff, normalMap, bumpMap, emissiveMap } = material;
  const use = (ref: ScaledTextureRef | null): number => textures.write(words, ref, wordOf);
  const radiance = radianceOf(material);
  const opaque = alphaMode === 'opaque';
  // As three.js has it: a cutoff of 0 cuts nothing off.
  const masked = alphaMode === 'mask' && alphaCutoff > 0;
  const flags =
    (showsBacks(material, model) ? MATERIAL_FLAGS.doubleSided : 0) |
    (model.file.transmission ? MATERIAL_FLAGS.transmits : 0) |
    (masked ? MATERIAL_FLAGS.mask : 0) |
    (alphaMode === 'blend' ? MATERIAL_FLAGS.blend : 0) |
    (luminance(radiance) > 0 ? MATERIAL_FLAGS.emits : 0);
  const parameters = writeParameters(words, material, model, textures, wordOf);
  words.setUints(slot + MATERIAL.model, modelIndex, flags, parameters, model.parameters.length);
  words.setFloats(
    slot + MATERIAL.emission,
    ...radiance,
    opaque ? 1 : Math.min(Math.max(opacity * (opacityMap?.scale ?? 1), 0), 1),
  );
  words.setFloats(
    slot + MATERIAL.scales,
    masked ? alphaCutoff : 0,
    normalMap?.scale ?? 1,
    bumpMap?.scale ?? 1,
  );
  words.setUints(
    slot + MATERIAL.textures,
    use(normalMap),
    // With a normal map three.js does not look at it.
    normalMap === null ? use(bumpMap) : 0,
    use(emissiveMap),
    opaque ? 0 : use(opacityMap),
  );
  words.setUints(slot + MATERIAL.channels, CHANNELS[opacityMap?.channel ?? 'a'], tableSlot);
}

/** The material at some places of its textures, which lie evenly over them. */
export function tabulatedMaterial(
  { material: { parameters, textures: refs }, model }: UsedMaterial,
  textures: TextureTable,
): TabulatedMaterial {
  const values = resolveParameters(model.file, parameters);
  const textured = model.parameters.flatMap(({ name }) => {
    const texture = textures.find(refs[name]);
    return texture ? [{ name, texel: texelSampler(texture), channel: refs[name]?.channel ?? 'r' }] : [];
  });
  const places = Array.from({ length: GENERIC_TABLE.points }, (_, i) => {
    // A Fibonacci lattice.
    const u = (i + 0.5) / GENERIC_TABLE.points;
    const v = (i * ((Math.sqrt(5) - 1) / 2) + 0.5) % 1;
    const here = textured.map(({ name, texel, channel }) => {
      const value = values[name] ?? 0;
      return [name, textureTimes(value, texel(u, v), CHANNELS[channel])] as const;
    });
    return { ...values, ...Object.fromEntries(here) };
  });
  return { model, places, isTextured: textured.length > 0 };
}

/** A parameter's value where its texture has this texel, as kernel/surface.glsl reads it. */
function textureTimes(value: ParameterValue, [r, g, b, a]: Rgba, channel: number): ParameterValue {
  if (typeof value === 'object') return [value[0] * r, value[1] * g, value[2] * b];
  const product = Number(value) * ([r, g, b, a][channel] ?? 1);
  return typeof value === 'boolean' ? product > 0.5 : product;
}

function writeParameters(
  words: Words,
  { parameters, textures: refs }: Material,
  model: Model,
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
): number {
  const values = resolveParameters(model.file, parameters);
  const first = words.allocate(model.parameters.length);
  for (const [i, { name, type }] of model.parameters.entries()) {
    const value = values[name] ?? 0;
    words.setFloats(first + i, ...(typeof value === 'object' ? value : [Number(value)]));
    const texture = textures.write(words, refs[name], wordOf);
    if (texture === 0) continue;
    const channel = type === 'color' ? CHANNELS.rgb : CHANNELS[refs[name]?.channel ?? 'r'];
    words.setUint(first + i, 3, (texture | (channel << CHANNEL_SHIFT)) >>> 0);
  }
  return first;
}
