import { MathUtils, Matrix3 } from 'three/webgpu';
import { luminance } from '../../color/rec709.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import { materialMaps } from '../../scene/material-schema.ts';
import type { Asset, Document, Material, TextureRef } from '../../scene/schema.ts';
import { readTexels, type Texels } from '../../scene/texels.ts';
import { FORMAT_SHIFT, FORMATS, TEXTURE_SLOTS, UV_SHIFT, WRAPS } from './layout.ts';
import { srgbTable } from './srgb.ts';
import type { Words } from './words.ts';

/** The images of a document's materials, each read once for as long as its asset is in use. */
export class Images {
  readonly #assets: AssetLoader;
  readonly #read = new WeakMap<Asset, Map<number | null, Promise<Texels>>>();

  constructor(assets: AssetLoader) {
    this.#assets = assets;
  }

  /** @throws Error that says which asset cannot be read */
  get(asset: Asset, texture: number | null): Promise<Texels> {
    const known = this.#read.get(asset) ?? new Map<number | null, Promise<Texels>>();
    this.#read.set(asset, known);
    let texels = known.get(texture);
    if (texels === undefined) {
      texels = this.#assets.image(asset, texture).then(readTexels);
      known.set(texture, texels);
      // It may work the next time: memory may be free again.
      texels.catch(() => known.delete(texture));
    }
    return texels;
  }
}

/** The textures that a material uses: of the parameters that its model has, and its maps. */
export function texturesOf(material: Material): TextureRef[] {
  const maps = materialMaps.filter((map) => map !== 'occlusionMap').map((map) => material[map]);
  return [...Object.values(material.textures), ...maps.filter((map) => map !== null)];
}

export type Rgba = readonly [number, number, number, number];

/** A texture with the image that it shows. */
export interface Texture {
  readonly ref: TextureRef;
  readonly texels: Texels;
}

/** The textures of a scene: texels of equal images and records of equal uses are there once. */
export class TextureTable {
  /** Every image, in the order in which they lie in memory. */
  readonly images: readonly Texels[];
  readonly #images: ReadonlyMap<string, Texels>;
  readonly #uses = new Map<string, number>();

  private constructor(images: ReadonlyMap<string, Texels>) {
    this.#images = images;
    this.images = [...new Set(images.values())];
  }

  static async load(
    document: Document,
    materials: readonly Material[],
    images: Images,
  ): Promise<TextureTable> {
    const found = new Map<string, Texels>();
    for (const ref of materials.flatMap(texturesOf)) {
      const asset = document.assets[ref.asset];
      if (asset !== undefined) found.set(keyOf(ref), await images.get(asset, ref.texture));
    }
    return new TextureTable(found);
  }

  /** Null if there is no such asset. */
  find(ref: TextureRef | null | undefined): Texture | null {
    const texels = ref ? this.#images.get(keyOf(ref)) : undefined;
    return ref && texels ? { ref, texels } : null;
  }

  /** The slot of a record of this use, 0 for none. @param wordOf where an image's texels lie */
  write(words: Words, ref: TextureRef | null | undefined, wordOf: (texels: Texels) => number): number {
    const texture = this.find(ref);
    if (texture === null) return 0;
    const { texels } = texture;
    const { texture: index, asset, colorSpace, repeat, offset, rotation, wrap, uv } = texture.ref;
    const key = JSON.stringify([asset, index, colorSpace, repeat, offset, rotation, wrap, uv]);
    const known = this.#uses.get(key);
    if (known !== undefined) return known;
    const slot = words.allocate(TEXTURE_SLOTS);
    this.#uses.set(key, slot);
    const flags = WRAPS[wrap] | (FORMATS[colorSpace] << FORMAT_SHIFT) | (uv << UV_SHIFT);
    words.setUints(slot, wordOf(texels), texels.width, texels.height, flags);
    const [row0, row1] = uvRows(texture.ref);
    words.setFloats(slot + 1, ...row0);
    words.setFloats(slot + 2, ...row1);
    return slot;
  }
}

/** An image by its asset, and in a glTF file by its index. */
const keyOf = ({ asset, texture }: TextureRef): string => `${asset} ${texture}`;

/** (u', v') as rows of factors of u, v and 1: three.js's own matrix of a texture. */
export function uvRows({ repeat, offset, rotation }: TextureRef): [number[], number[]] {
  const matrix = new Matrix3().setUvTransform(...offset, ...repeat, MathUtils.degToRad(rotation), 0, 0);
  const m = matrix.elements;
  return [
    [m[0]!, m[3]!, m[6]!],
    [m[1]!, m[4]!, m[7]!],
  ];
}

/** The texel at (u, v), linear RGBA: no filter, for estimates. */
export function texelSampler({ ref, texels }: Texture): (u: number, v: number) => Rgba {
  const { bytes, width, height } = texels;
  const [[a, b, c], [d, e, f]] = uvRows(ref) as [[number, number, number], [number, number, number]];
  const linear = ref.colorSpace === 'srgb' ? srgbTable : Array.from({ length: 256 }, (_, byte) => byte / 255);
  const texel = (x: number, size: number): number =>
    Math.min(Math.floor((Number.isFinite(x) ? wrap(x, ref.wrap) : 0) * size), size - 1);
  return (u, v) => {
    const at = 4 * (texel(d * u + e * v + f, height) * width + texel(a * u + b * v + c, width));
    const [red, green, blue] = [linear[bytes[at]!]!, linear[bytes[at + 1]!]!, linear[bytes[at + 2]!]!];
    return [red, green, blue, bytes[at + 3]! / 255];
  };
}

/** The luminance of the texel at (u, v). */
export function luminanceSampler(texture: Texture): (u: number, v: number) => number {
  const texel = texelSampler(texture);
  return (u, v) => {
    const [r, g, b] = texel(u, v);
    return luminance([r, g, b]);
  };
}

function wrap(x: number, mode: TextureRef['wrap']): number {
  if (mode === 'clamp') return Math.min(Math.max(x, 0), 1);
  if (mode === 'repeat') return x - Math.floor(x);
  return 1 - Math.abs(1 - (x - 2 * Math.floor(x / 2)));
}
