/**
 * Textures of a document as glTF wants them. An image that has its values in the channels that glTF reads goes as the file
 * that it is; otherwise a new one is put together of the channels.
 */
import type { AssetLoader } from '../../scene/assets.ts';
import { decodeBase64 } from '../../scene/base64.ts';
import { isPattern } from '../../scene/pattern/asset.ts';
import type { Document, TextureRef } from '../../scene/schema.ts';
import { readTexels, type Texels } from '../../scene/texels.ts';
import { readGltf, textureImage } from '../gltf/file.ts';
import type { Notes } from '../gltf/notes.ts';
import { isApproximate, isPlain, toKhr } from '../gltf/transform.ts';
import type { GltfWriter, Json } from '../gltf/writer.ts';
import { encodePng } from '../png.ts';

export type Channel = 'r' | 'g' | 'b' | 'a';
export type TextureInfo = Json & { index: number };
/** What each channel of a packed image holds; what is left out is white. */
export type Packing = Partial<Record<Channel, { ref: TextureRef; channel: Channel }>>;

const WRAPS = { repeat: 10497, mirror: 33648, clamp: 33071 } as const;
const EXTENSIONS: Readonly<Record<string, string>> = {
  'image/webp': 'EXT_texture_webp',
  'image/avif': 'EXT_texture_avif',
  'image/ktx2': 'KHR_texture_basisu',
};
const OFFSETS: Readonly<Record<Channel, number>> = { r: 0, g: 1, b: 2, a: 3 };

/** What two uses of images have in common where they lie alike. */
const placeOf = ({ repeat, offset, rotation, wrap, uv }: TextureRef): string =>
  JSON.stringify([repeat, offset, rotation, wrap, uv]);
const imageOf = ({ asset, texture }: TextureRef): string => JSON.stringify([asset, texture]);

export const sameImage = (a: TextureRef, b: TextureRef): boolean =>
  imageOf(a) === imageOf(b) && placeOf(a) === placeOf(b);

export class TextureExport {
  readonly #images = new Map<string, { index: number; mediaType: string }>();
  readonly #textures = new Map<string, number>();

  constructor(
    readonly document: Document,
    readonly assets: AssetLoader,
    readonly writer: GltfWriter,
    readonly notes: Notes,
  ) {}

  /** The image as it is. */
  async whole(ref: TextureRef): Promise<TextureInfo> {
    const key = imageOf(ref);
    let image = this.#images.get(key);
    if (image === undefined) {
      const { bytes, mediaType, name } = await this.#file(ref);
      image = { index: this.writer.image(bytes, mediaType, name), mediaType };
      this.#images.set(key, image);
    }
    return this.#info(image, ref);
  }

  /** Null, with a note, if the parts do not lie alike on the surface. @param what it is, for the note */
  async packed(parts: Packing, what: string): Promise<TextureInfo | null> {
    const entries = Object.entries(parts) as [Channel, { ref: TextureRef; channel: Channel }][];
    const [first] = entries;
    if (first === undefined) return null;
    const { ref } = first[1];
    // As it is where every channel is the one that glTF reads, of one image.
    if (entries.every(([to, part]) => part.channel === to && sameImage(part.ref, ref)))
      return this.whole(ref);
    if (entries.some(([, part]) => placeOf(part.ref) !== placeOf(ref))) {
      this.notes.add(
        `${what}: its textures lie differently on the surface, which glTF cannot say; they are left out`,
      );
      return null;
    }
    const key = JSON.stringify(entries.map(([to, part]) => [to, imageOf(part.ref), part.channel]));
    let image = this.#images.get(key);
    if (image === undefined) {
      image = {
        index: this.writer.image(await this.#pack(entries), 'image/png', what),
        mediaType: 'image/png',
      };
      this.#images.set(key, image);
    }
    return this.#info(image, ref);
  }

  async #pack(entries: readonly [Channel, { ref: TextureRef; channel: Channel }][]): Promise<Uint8Array> {
    const images = new Map<string, Texels>();
    for (const [, { ref }] of entries) {
      const asset = this.document.assets[ref.asset];
      if (asset && !images.has(imageOf(ref)))
        images.set(imageOf(ref), readTexels(await this.assets.image(asset, ref.texture)));
    }
    const width = Math.max(...[...images.values()].map((image) => image.width));
    const height = Math.max(...[...images.values()].map((image) => image.height));
    const pixels = new Uint8Array(4 * width * height).fill(255);
    for (const [to, { ref, channel }] of entries) {
      const image = images.get(imageOf(ref));
      if (image === undefined) continue;
      for (let y = 0; y < height; y++) {
        // Texels come with the bottom row first, PNGs with the top one.
        const row = Math.floor(((height - 1 - y) * image.height) / height) * image.width;
        for (let x = 0; x < width; x++) {
          const at = row + Math.floor((x * image.width) / width);
          pixels[4 * (y * width + x) + OFFSETS[to]] = image.bytes[4 * at + OFFSETS[channel]]!;
        }
      }
    }
    return encodePng(pixels, width, height);
  }

  async #file({
    asset: id,
    texture,
  }: TextureRef): Promise<{ bytes: Uint8Array; mediaType: string; name: string }> {
    const asset = this.document.assets[id];
    if (asset === undefined) throw new Error(`there is no asset ${id}`);
    if (isPattern(asset)) {
      // glTF has no patterns: their picture goes.
      const { bytes, width, height } = readTexels(await this.assets.image(asset, texture));
      return {
        bytes: encodePng(flipped(bytes, width), width, height),
        mediaType: 'image/png',
        name: asset.name,
      };
    }
    const bytes = decodeBase64(asset.data);
    if (texture === null) return { bytes, mediaType: asset.mediaType, name: asset.name };
    return { ...textureImage(readGltf(bytes, asset.name), texture), name: `${asset.name} ${texture}` };
  }

  #info({ index: source, mediaType }: { index: number; mediaType: string }, ref: TextureRef): TextureInfo {
    const key = `${source} ${ref.wrap}`;
    let index = this.#textures.get(key);
    if (index === undefined) {
      const wrap = WRAPS[ref.wrap];
      const sampler = this.writer.add('samplers', { wrapS: wrap, wrapT: wrap });
      const extension = EXTENSIONS[mediaType];
      if (extension !== undefined) this.writer.use(extension);
      const image = extension === undefined ? { source } : { extensions: { [extension]: { source } } };
      index = this.writer.add('textures', { sampler, ...image });
      this.#textures.set(key, index);
    }
    if (isApproximate(ref))
      this.notes.add('a texture is both rotated and scaled unevenly, which is approximated');
    if (!isPlain(ref)) this.writer.use('KHR_texture_transform');
    return {
      index,
      ...(ref.uv > 0 && { texCoord: ref.uv }),
      ...(!isPlain(ref) && { extensions: { KHR_texture_transform: toKhr(ref) } }),
    };
  }
}

/** Texels come with the bottom row first, PNGs with the top one. */
function flipped(texels: Uint8Array, width: number): Uint8Array {
  const rows = new Uint8Array(texels.length);
  for (let at = 0; at < texels.length; at += 4 * width)
    rows.set(texels.subarray(at, at + 4 * width), texels.length - 4 * width - at);
  return rows;
}
