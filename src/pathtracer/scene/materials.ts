import { resolveParameters } from '../../brdf/values.ts';
import { createEvaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import { highlightAlpha } from '../../material/generic-sampler.ts';
import type { Material, ScaledTextureRef } from '../../scene/schema.ts';
import { parameterSlots } from '../kernel.ts';
import { CHANNEL_SHIFT, CHANNELS, MATERIAL, MATERIAL_FLAGS, MATERIAL_SLOTS } from './layout.ts';
import type { Texels } from './texels.ts';
import { luminance, type Texture, type TextureTable } from './textures.ts';
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
  if (luminance(...radiance) === 0) return null;
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

/** Writes the materials, one behind the other. @returns the first one's slot */
export function writeMaterials(
  words: Words,
  materials: readonly UsedMaterial[],
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
): number {
  const first = words.allocate(materials.length * MATERIAL_SLOTS);
  for (const [i, used] of materials.entries())
    writeMaterial(words, first + i * MATERIAL_SLOTS, used, textures, wordOf);
  return first;
}

function writeMaterial(
  words: Words,
  slot: number,
  { material, model, modelIndex }: UsedMaterial,
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
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
    (luminance(...radiance) > 0 ? MATERIAL_FLAGS.emits : 0);
  const parameters = writeParameters(words, material, model, textures, wordOf);
  words.setUints(slot + MATERIAL.model, modelIndex, flags, parameters, parameterSlots(model));
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
  words.setUints(slot + MATERIAL.channels, CHANNELS[opacityMap?.channel ?? 'a']);
}

function writeParameters(
  words: Words,
  { parameters, textures: refs }: Material,
  model: Model,
  textures: TextureTable,
  wordOf: (texels: Texels) => number,
): number {
  const values = resolveParameters(model.file, parameters);
  const first = words.allocate(parameterSlots(model));
  for (const [i, { name, type }] of model.parameters.entries()) {
    const value = values[name] ?? 0;
    words.setFloats(first + i, ...(typeof value === 'object' ? value : [Number(value)]));
    const texture = textures.write(words, refs[name], wordOf);
    if (texture === 0) continue;
    const channel = type === 'color' ? CHANNELS.rgb : CHANNELS[refs[name]?.channel ?? 'r'];
    words.setUint(first + i, 3, (texture | (channel << CHANNEL_SHIFT)) >>> 0);
  }
  if (!model.hasSampling)
    words.setFloats(first + model.parameters.length, highlightAlpha(createEvaluator(model, parameters)));
  return first;
}
