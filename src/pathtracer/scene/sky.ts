import { type DataTexture, MathUtils } from 'three/webgpu';
import { luminance } from '../../color/rec709.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import {
  computeEnvironment,
  type EnvironmentMap,
  environmentScale,
  isComputed,
} from '../../scene/environment-map.ts';
import { environmentTexels } from '../../scene/environment-texels.ts';
import type { Asset, Document, EnvironmentSource } from '../../scene/schema.ts';
import { PathTracerError } from './error.ts';
import { SKY_SLOTS } from './layout.ts';
import { colorOf } from './lights.ts';
import type { Pace } from './pace.ts';
import type { Words } from './words.ts';

type Rgb = [number, number, number];

export type SkyMap = EnvironmentMap;

/** Loads environments, the last one again for nothing. */
export class SkyMaps {
  readonly #assets: AssetLoader;
  #source: EnvironmentSource | null = null;
  #asset: Asset | null = null;
  #map: SkyMap | null = null;

  constructor(assets: AssetLoader) {
    this.#assets = assets;
  }

  /** Null where the document has none. @throws Error that says which asset cannot be read */
  async get({ environment, assets }: Document): Promise<SkyMap | null> {
    const { source } = environment;
    if (source.type === 'none') return null;
    if (source.type === 'constant')
      return { texels: new Float32Array([...source.color, 1]), width: 1, height: 1 };
    const asset = source.type === 'hdr' ? (assets[source.asset] ?? null) : null;
    if (source.type === 'hdr' && asset === null) return null;
    const same = asset === null ? sameSource(source, this.#source) : asset === this.#asset;
    if (this.#map !== null && same) return this.#map;
    this.#map = isComputed(source) ? await computeEnvironment(source) : await this.#load(source, asset);
    [this.#source, this.#asset] = [source, asset];
    return this.#map;
  }

  async #load(source: EnvironmentSource, asset: Asset | null): Promise<SkyMap> {
    const texture =
      source.type === 'preset'
        ? await this.#assets.preset(source.name)
        : await this.#assets.environment(asset as Asset);
    const map = readSkyMap(texture);
    texture.dispose();
    return map;
  }
}

const sameSource = (a: EnvironmentSource, b: EnvironmentSource | null): boolean =>
  JSON.stringify(a) === JSON.stringify(b);

export function readSkyMap(texture: DataTexture): SkyMap {
  const map = environmentTexels(texture);
  if (map === null)
    throw new PathTracerError(`${texture.name}: the environment is not an image of RGBA texels`);
  return map;
}

/** The radiance that ambient and hemisphere lights bring from above and below the horizon. */
export function uniformSky(document: Document): { upper: Rgb; lower: Rgb } {
  const [upper, lower]: [Rgb, Rgb] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (const light of Object.values(document.lights)) {
    if (!light.visible || (light.type !== 'ambient' && light.type !== 'hemisphere')) continue;
    const color = colorOf(light);
    // Like three.js's, the light's temperature colours the sky, not the ground.
    const ground = light.type === 'hemisphere' ? light.groundColor : color;
    for (let i = 0; i < 3; i += 1) {
      upper[i] = upper[i]! + light.luminance * color[i]!;
      lower[i] = lower[i]! + light.luminance * ground[i]!;
    }
  }
  return { upper, lower };
}

/** The density of directions in proportion to their light: piecewise constant over the map's (u, v). */
export interface SkyDistribution {
  readonly width: number;
  readonly height: number;
  /** height + 1 values from 0 to 1. */
  readonly marginal: Float32Array;
  /** width + 1 values from 0 to 1 for each row. */
  readonly conditional: Float32Array;
  /** The same as `marginal` of the irradiance on level ground: nothing below the horizon. */
  readonly level: Float32Array;
  /** Of the luminance times the cosine of the latitude over (u, v). */
  readonly integral: number;
}

const MOST_COLUMNS = 1024;
const MOST_ROWS = 512;
/** So many that the cosine of the latitude hardly changes within one. Even, so that the horizon is between two. */
const LEAST_ROWS = 64;

export async function skyDistribution(
  map: SkyMap | null,
  intensity: number,
  { upper, lower }: { upper: Rgb; lower: Rgb },
  pace: Pace,
): Promise<SkyDistribution> {
  const lit = intensity > 0 ? map : null;
  const width = lit === null ? 1 : Math.min(lit.width, MOST_COLUMNS);
  const height = Math.max(LEAST_ROWS, 2 * Math.ceil(Math.min(lit?.height ?? 1, MOST_ROWS) / 2));
  const conditional = new Float32Array((width + 1) * height);
  const rows = new Float64Array(height);
  const levelRows = new Float64Array(height);
  const cells = new Float64Array(width);
  const mean = lit === null ? null : meanLuminance(lit, width, height);
  for (let y = 0; y < height; y += 1) {
    const uniform = luminance(2 * y < height ? lower : upper);
    for (let x = 0; x < width; x += 1) cells[x] = uniform + (mean === null ? 0 : intensity * mean(x, y));
    // The mean of the cosine over the row's latitudes.
    const [south, north] = [y, y + 1].map((edge) => Math.sin(Math.PI * (edge / height - 0.5))) as [
      number,
      number,
    ];
    const cosine = ((north - south) * height) / Math.PI;
    const sum = accumulate(cells, conditional.subarray(y * (width + 1), (y + 1) * (width + 1)));
    rows[y] = (sum / width) * cosine;
    levelRows[y] = 2 * y < height ? 0 : sum * (north * north - south * south);
    if (pace.due) await pace.rest();
  }
  const marginal = new Float32Array(height + 1);
  const integral = accumulate(rows, marginal) / height;
  const level = new Float32Array(height + 1);
  accumulate(levelRows, level);
  return { width, height, marginal, conditional, level, integral };
}

/** Writes the distribution function of weights, from 0 to 1; evenly rising if they are all 0. @returns their sum */
function accumulate(weights: Float64Array, cdf: Float32Array): number {
  let total = 0;
  for (const weight of weights) total += weight;
  let sum = 0;
  for (let i = 0; i < weights.length; i += 1) {
    sum += total > 0 ? (weights[i] as number) / total : 1 / weights.length;
    cdf[i + 1] = Math.min(sum, 1);
  }
  cdf[weights.length] = 1;
  return total;
}

/**
 * The mean of the map's luminance over a cell, of the map as it is read between its texels: a cell next to a bright
 * texel is not dark.
 */
function meanLuminance(
  { texels, width, height }: SkyMap,
  columns: number,
  rows: number,
): (x: number, y: number) => number {
  const gray = new Float32Array(width * height);
  for (let i = 0; i < gray.length; i += 1)
    gray[i] = luminance([texels[4 * i]!, texels[4 * i + 1]!, texels[4 * i + 2]!]);
  // Two points a texel, a quarter in from its edges, give a linear function's mean between texels.
  const across = 2 * Math.ceil(width / columns);
  const down = 2 * Math.ceil(height / rows);
  return (x, y) => {
    let sum = 0;
    for (let j = 0; j < down; j += 1) {
      const v = ((y + (j + 0.5) / down) * height) / rows - 0.5;
      const [v0, tv] = [Math.floor(v), v - Math.floor(v)];
      const below = Math.min(Math.max(v0, 0), height - 1) * width;
      const above = Math.min(Math.max(v0 + 1, 0), height - 1) * width;
      for (let i = 0; i < across; i += 1) {
        const u = ((x + (i + 0.5) / across) * width) / columns - 0.5;
        const [u0, tu] = [Math.floor(u), u - Math.floor(u)];
        const left = (u0 + width) % width;
        const right = (u0 + 1) % width;
        sum +=
          (1 - tv) * ((1 - tu) * gray[below + left]! + tu * gray[below + right]!) +
          tv * ((1 - tu) * gray[above + left]! + tu * gray[above + right]!);
      }
    }
    return sum / (across * down);
  };
}

/** Where a sky's larger parts lie in the scene's memory, as words. */
export interface SkyPlaces {
  readonly texels: number;
  readonly marginal: number;
  readonly conditional: number;
}

/** Writes the sky's record. @returns its slot */
export function writeSky(
  words: Words,
  { environment }: Document,
  map: SkyMap | null,
  distribution: SkyDistribution,
  places: SkyPlaces,
): number {
  const slot = words.allocate(SKY_SLOTS);
  const hasHorizon = environment.source.type === 'sky';
  if (map !== null) words.setUints(slot, map.width, map.height, places.texels / 4, Number(hasHorizon));
  words.setUints(slot + 1, distribution.width, distribution.height, places.marginal, places.conditional);
  const angle = MathUtils.degToRad(environment.rotation);
  words.setFloats(
    slot + 2,
    environmentScale(environment),
    Math.cos(angle),
    Math.sin(angle),
    distribution.integral,
  );
  return slot;
}
