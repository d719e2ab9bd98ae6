/**
 * The grain of what has one: a pattern with the entry's colour for its mean, so that what is known of the colour stays true.
 * What is seen in the patterns is by eye.
 */
import { COLOR_NAMES } from '../../scene/carried-look.ts';
import { materialDefaults, textureRef } from '../../scene/material-schema.ts';
import { COLOR, NORMALS, type PatternName, SURFACE } from '../../scene/pattern/asset.ts';
import { MEAN_ROUGHNESS } from '../../scene/pattern/draw.ts';
import { patternAsset } from '../../scene/pattern/pattern.ts';
import type { Asset, Material } from '../../scene/schema.ts';
import type { Rgb } from '../plots/curve.ts';
import { type LibraryEntry, materialOf } from './entry.ts';

interface Grain {
  readonly pattern: PatternName;
  /** What is not the pattern's default. */
  readonly settings: Readonly<Record<string, number | Rgb>>;
  /** Pictures from pole to pole of a ball, and across a square. */
  readonly repeat: number;
  /** Pictures are so many times as long as they are wide. */
  readonly length?: number;
  /** What of it the material takes. */
  readonly takes: readonly ('color' | 'roughness' | 'normals')[];
  /**
   * For models that share the light between base and gloss: the base's share. White stone needs more than a flat white, since
   * its ground is brighter than its mean.
   */
  readonly base?: number;
}

const wood = (settings: Grain['settings'], takes: Grain['takes'] = ['color', 'roughness']): Grain => ({
  pattern: 'wood',
  settings,
  repeat: 1,
  length: 2,
  takes,
});
const cloth = (settings: Grain['settings'], repeat = 2): Grain => ({
  pattern: 'weave',
  settings,
  repeat,
  takes: ['color', 'normals'],
});
const cast = (settings: Grain['settings'], takes: Grain['takes'] = ['color', 'normals']): Grain => ({
  pattern: 'concrete',
  settings,
  repeat: 1,
  takes,
});
const BRUSHED: Grain = { pattern: 'brushed', settings: { contrast: 0.6 }, repeat: 2, takes: ['roughness'] };

/** By the ids of the library's entries. */
const GRAINS: Readonly<Record<string, Grain>> = {
  pine: wood({ rings: 9, figure: 2.2, latewood: 0.3, contrast: 0.55, fibre: 0.35, pores: 0, seed: 3 }),
  oak: wood({ rings: 16, figure: 2.6, latewood: 0.45, contrast: 0.3, fibre: 0.5, pores: 0.55, seed: 7 }),
  walnut: wood({ rings: 10, figure: 5, latewood: 0.5, contrast: 0.4, fibre: 0.45, pores: 0.4, seed: 2 }),
  cherry: wood({ rings: 12, figure: 4, latewood: 0.4, contrast: 0.18, fibre: 0.35, pores: 0.05, seed: 5 }, [
    'color',
  ]),
  mahogany: wood({ rings: 7, figure: 2, latewood: 0.6, contrast: 0.15, fibre: 0.8, pores: 0.5, seed: 4 }, [
    'color',
  ]),
  ebony: wood({ rings: 18, figure: 2, latewood: 0.6, contrast: 0.12, fibre: 0.6, pores: 0.3, seed: 6 }),
  cork: {
    pattern: 'granite',
    settings: {
      grains: 36,
      secondShare: 0.45,
      secondColor: [0.27, 0.145, 0.065],
      thirdShare: 0.07,
      thirdColor: [0.06, 0.03, 0.015],
      variation: 0.5,
    },
    repeat: 1,
    takes: ['color', 'normals'],
  },
  marble: {
    pattern: 'marble',
    settings: { strength: 0.75, seed: 1 },
    repeat: 1,
    takes: ['color'],
    base: 0.92,
  },
  alabaster: {
    pattern: 'marble',
    settings: { veins: 1, width: 0.6, strength: 0.35, clouds: 0.35, veinColor: [0.5, 0.36, 0.22], seed: 8 },
    repeat: 1,
    takes: ['color'],
  },
  jade: {
    pattern: 'marble',
    settings: { veins: 2, width: 0.8, strength: 0.5, clouds: 0.5, veinColor: [0.22, 0.42, 0.22], seed: 5 },
    repeat: 1,
    takes: ['color'],
  },
  granite: {
    pattern: 'granite',
    settings: { grains: 48, secondColor: [0.26, 0.17, 0.14], thirdShare: 0.25 },
    repeat: 1,
    takes: ['color'],
  },
  asphalt: {
    pattern: 'granite',
    settings: {
      grains: 110,
      secondColor: [0.12, 0.12, 0.12],
      thirdShare: 0.25,
      thirdColor: [0.025, 0.025, 0.026],
      variation: 0.6,
      relief: 2,
    },
    repeat: 1,
    takes: ['color', 'normals'],
  },
  concrete: cast({}),
  limestone: cast({ stains: 2, contrast: 0.25, layers: 0.5, grit: 0.6, pits: 0.15, pitSize: 0.25, seed: 2 }),
  sandstone: cast({ stains: 2, contrast: 0.4, layers: 0.9, grit: 0.9, pits: 0, seed: 3 }),
  slate: cast({ stains: 2, contrast: 0.25, layers: 0.85, grit: 0.4, pits: 0, relief: 1.5, seed: 4 }),
  basalt: cast({ stains: 4, contrast: 0.2, grit: 0.8, pits: 0.8, pitSize: 0.2, seed: 5 }),
  terracotta: cast({ stains: 2, contrast: 0.2, grit: 0.5, pits: 0.12, pitSize: 0.15, seed: 6 }),
  brick: cast({ stains: 4, contrast: 0.35, grit: 1, pits: 0.5, pitSize: 0.3, seed: 7 }),
  denim: cloth({
    repeats: 10,
    over: 2,
    under: 1,
    weftColor: [0.14, 0.18, 0.26],
    irregularity: 0.8,
    fibre: 0.8,
  }),
  linen: cloth({ repeats: 12, weftColor: [0.38, 0.33, 0.24], thickness: 0.6, irregularity: 0.9, fibre: 0.6 }),
  canvas: cloth({
    repeats: 9,
    weftColor: [0.36, 0.33, 0.27],
    thickness: 0.95,
    irregularity: 0.5,
    fibre: 0.6,
    seed: 2,
  }),
  'cotton-red': cloth({
    repeats: 11,
    weftColor: [0.36, 0.03, 0.035],
    irregularity: 0.3,
    fibre: 0.3,
    seed: 3,
  }),
  wool: cloth({
    repeats: 6,
    over: 2,
    under: 2,
    weftColor: [0.07, 0.07, 0.074],
    thickness: 1,
    irregularity: 0.7,
    fibre: 1,
    seed: 4,
  }),
  leather: {
    pattern: 'leather',
    settings: { cushions: 24, relief: 0.5 },
    repeat: 2,
    takes: ['color', 'normals'],
  },
  'silver-brushed': BRUSHED,
  'brass-brushed': BRUSHED,
  'aluminium-brushed': BRUSHED,
  'steel-brushed': BRUSHED,
  'iron-ground': BRUSHED,
};

export interface LibraryFile {
  readonly material: Material;
  readonly models: Readonly<Record<string, never>>;
  readonly assets: Readonly<Record<string, Asset>>;
}

const ASSET = 'pattern';

/**
 * A material of the library with what it needs.
 *
 * @param isBall a ball's texture is twice as long around it as from pole to pole
 */
export function fileOf(entry: LibraryEntry, isBall = true): LibraryFile {
  const material: Material = { ...structuredClone(materialDefaults), ...materialOf(entry) };
  const grain = Object.hasOwn(GRAINS, entry.id) ? GRAINS[entry.id] : undefined;
  if (!grain) return { material, models: {}, assets: {} };
  const { pattern, settings, repeat, length = 1, takes, base } = grain;
  const { parameters } = material;
  const name = COLOR_NAMES.find((known) => Object.hasOwn(parameters, known));
  let color = parameters[name ?? ''] as Rgb;
  if (base !== undefined) {
    const more = Number(parameters.kd) / base;
    color = [color[0] * more, color[1] * more, color[2] * more];
    parameters.kd = base;
  }
  const asset = patternAsset({ pattern, ...settings, color });
  const ref = (texture: number) =>
    textureRef(ASSET, { texture, repeat: [(isBall ? 2 : 1) * repeat * length, repeat] });
  if (name !== undefined && takes.includes('color')) {
    parameters[name] = [1, 1, 1];
    material.textures[name] = { ...ref(COLOR), colorSpace: 'srgb' };
  }
  if (takes.includes('roughness')) {
    parameters.roughness = Number((Number(parameters.roughness) / MEAN_ROUGHNESS).toFixed(4));
    material.textures.roughness = { ...ref(SURFACE), channel: 'g' };
  }
  if (takes.includes('normals')) material.normalMap = { ...ref(NORMALS), scale: 1 };
  return { material, models: {}, assets: { [ASSET]: asset } };
}
