/** The light of the sky on level ground, and directions from which it comes, each with the same part of its luminance. */
import { type AmbientLight, Color, type HemisphereLight, type Scene, Vector3 } from 'three/webgpu';
import { luminance } from '../../color/rec709.ts';
import type { EnvironmentMap } from '../../scene/environment-map.ts';
import { environmentTexels } from '../../scene/environment-texels.ts';
import { levelRadiance } from '../../scene/level-irradiance.ts';

type Rgb = [number, number, number];

export interface SkyDirection {
  /** To the sky; a unit vector. */
  readonly direction: Vector3;
  /** The colour of its light; its luminance is 1. */
  readonly color: Rgb;
}

export class SkyLight {
  /** On level ground without objects, linear Rec. 709. */
  readonly irradiance = new Color(0, 0, 0);
  #key: readonly unknown[] = [];
  #map: EnvironmentMap | null = null;
  #scale = 1;
  /** Of lights that are the same from everywhere above: radiance. */
  #even: Rgb = [0, 0, 0];
  #rotation = 0;
  #rows: Float64Array = new Float64Array(0);
  /** Those that have been asked for, until something changes. */
  #directions: (SkyDirection | null)[] = [];

  /**
   * Looks at a scene's environment, ambient and hemisphere lights.
   *
   * @param hasHorizon whether the environment is a sky that is computed
   * @returns whether any has changed
   */
  update(scene: Scene, hasHorizon: boolean): boolean {
    const { environment, environmentIntensity, environmentRotation } = scene;
    const even = new Color(0, 0, 0);
    scene.traverseVisible((object) => {
      const light = object as Partial<AmbientLight & HemisphereLight>;
      if (!light.isAmbientLight && !light.isHemisphereLight) return;
      // As irradiance: pi times the radiance.
      even.add(new Color().copy(light.color as Color).multiplyScalar((light.intensity as number) / Math.PI));
    });
    const image = [environment, environment?.version, hasHorizon];
    const key = [...image, environmentIntensity, environmentRotation.y, even.r, even.g, even.b];
    if (key.length === this.#key.length && key.every((value, i) => value === this.#key[i])) return false;
    const isSameImage = image.every((value, i) => value === this.#key[i]);
    this.#key = key;
    if (!isSameImage) this.#map = environment && environmentTexels(environment);
    this.#scale = environmentIntensity;
    this.#rotation = environmentRotation.y;
    this.#even = even.toArray() as Rgb;
    const mean = this.#map ? levelRadiance(this.#map, hasHorizon) : [0, 0, 0];
    const [r, g, b] = this.#even.map((x, c) => Math.PI * (x + this.#scale * mean[c]!)) as Rgb;
    this.irradiance.setRGB(r, g, b);
    this.#rows = this.#rowsCdf();
    this.#directions = [];
    return true;
  }

  /** The i-th of a sequence of directions of which any number is spread evenly over the light; null where there is none. */
  direction(i: number): SkyDirection | null {
    const known = this.#directions[i];
    if (known !== undefined) return known;
    const found = this.#find(i);
    this.#directions[i] = found;
    return found;
  }

  #find(i: number): SkyDirection | null {
    const total = this.#rows.at(-1) ?? 0;
    if (!(total > 0)) return null;
    // M. Roberts, 2018, "The Unreasonable Effectiveness of Quasirandom Sequences": R2.
    const u = (0.5 + i * 0.7548776662466927) % 1;
    const v = (0.5 + i * 0.5698402909980532) % 1;
    const height = this.#rows.length;
    const y = lowerBound(this.#rows, v * total);
    const below = y > 0 ? this.#rows[y - 1]! : 0;
    const part = (v * total - below) / Math.max(this.#rows[y]! - below, 1e-300);
    // Within the upper half, rows are bands of elevation; even steps of sin^2 of it are even steps of irradiance.
    const [low, high] = [y, y + 1].map((edge) => Math.sin((Math.PI * edge) / (2 * height)) ** 2) as [
      number,
      number,
    ];
    const sine = Math.sqrt(low + part * (high - low));
    const { column, columns, color } = this.#column(y, u);
    const longitude = ((column + 0.5) / columns - 0.5) * 2 * Math.PI;
    const cosine = Math.sqrt(1 - sine * sine);
    const [x, z] = [Math.cos(longitude) * cosine, Math.sin(longitude) * cosine];
    const [c, s] = [Math.cos(this.#rotation), Math.sin(this.#rotation)];
    const direction = new Vector3(c * x + s * z, Math.max(sine, 1e-3), c * z - s * x).normalize();
    const bright = luminance(color);
    return { direction, color: color.map((value) => value / bright) as Rgb };
  }

  /** By elevation, from the horizon up: what comes from each row of the upper half and those below it. */
  #rowsCdf(): Float64Array {
    const height = this.#upperRows;
    const cdf = new Float64Array(height);
    let sum = 0;
    for (let y = 0; y < height; y++) {
      const [low, high] = [y, y + 1].map((edge) => Math.sin((Math.PI * edge) / (2 * height)) ** 2) as [
        number,
        number,
      ];
      const luminances = this.#luminances(y);
      sum += ((high - low) * luminances.reduce((a, b) => a + b, 0)) / luminances.length;
      cdf[y] = sum;
    }
    return cdf;
  }

  /** Rows above the horizon: of an image with an odd number of rows the middle one counts whole. */
  get #upperRows(): number {
    return this.#map === null ? 1 : Math.ceil(this.#map.height / 2);
  }

  #texel(x: number, row: number): Rgb {
    const map = this.#map;
    if (map === null) return this.#even;
    const at = this.#rowStart(row) + 4 * x;
    return [0, 1, 2].map((c) => this.#even[c]! + this.#scale * map.texels[at + c]!) as Rgb;
  }

  #rowStart(row: number): number {
    const { width = 1, height = 1 } = this.#map ?? {};
    return 4 * width * (height - this.#upperRows + row);
  }

  /** Of each texel of a row. */
  #luminances(row: number): Float64Array {
    const { texels, width } = this.#map ?? { texels: null, width: 1 };
    const found = new Float64Array(width).fill(luminance(this.#even));
    if (texels === null) return found;
    for (let x = 0, at = this.#rowStart(row); x < width; x++, at += 4)
      found[x]! += this.#scale * luminance([texels[at]!, texels[at + 1]!, texels[at + 2]!]);
    return found;
  }

  /** A place in a row by its luminance: the middle of the first column is 0. */
  #column(row: number, u: number): { column: number; columns: number; color: Rgb } {
    const luminances = this.#luminances(row);
    let left = u * luminances.reduce((a, b) => a + b, 0);
    let column = 0;
    while (column < luminances.length - 1 && left >= luminances[column]!) {
      left -= luminances[column]!;
      column += 1;
    }
    const part = Math.min(left / Math.max(luminances[column]!, 1e-300), 1);
    return { column: column - 0.5 + part, columns: luminances.length, color: this.#texel(column, row) };
  }
}

/** The first place whose value is more than x. */
function lowerBound(cdf: Float64Array, x: number): number {
  let [low, high] = [0, cdf.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (cdf[middle]! > x) high = middle;
    else low = middle + 1;
  }
  return low;
}
