/** Textures of a three.js scene file: images inside it, or files that came along. */
import { MathUtils } from 'three/webgpu';
import { decodeDataUrl } from '../../scene/base64.ts';
import type { TextureRef } from '../../scene/schema.ts';
import type { Notes } from '../gltf/notes.ts';
import { isAddress } from '../meshes/companions.ts';
import type { TextureWriter } from '../meshes/textures.ts';
import { encodePng } from '../png.ts';
import type { SourceImage, SourceScene, SourceTexture } from './schema.ts';

/** three.js's numbers for what lies beyond an image's edge. */
const wraps: Readonly<Record<number, TextureRef['wrap']>> = { 1000: 'repeat', 1001: 'clamp', 1002: 'mirror' };

export class SceneTextures {
  readonly #textures: ReadonlyMap<string, SourceTexture>;
  readonly #images: ReadonlyMap<string, SourceImage>;
  readonly #writer: TextureWriter;
  readonly #notes: Notes;

  constructor({ textures, images }: SourceScene, writer: TextureWriter, notes: Notes) {
    this.#textures = new Map(textures.map((texture) => [texture.uuid, texture]));
    this.#images = new Map(images.map((image) => [image.uuid, image]));
    this.#writer = writer;
    this.#notes = notes;
  }

  /** Null, with a note, where the texture cannot be had. */
  get(uuid: string, values: Partial<TextureRef>): TextureRef | null {
    const texture = this.#textures.get(uuid);
    const image = this.#images.get(texture?.image ?? '');
    if (!texture || !image) {
      this.#notes.add('a texture is not in the file');
      return null;
    }
    if (texture.wrap[0] !== texture.wrap[1])
      this.#notes.add('a texture wraps differently along its sides; both wrap as along the first');
    const place = { ...placeOf(texture), uv: texture.channel, wrap: wraps[texture.wrap[0]] ?? 'clamp' };
    return this.#image(image, { ...values, ...place });
  }

  #image({ uuid, url }: SourceImage, values: Partial<TextureRef>): TextureRef | null {
    if (typeof url === 'string') {
      const embedded = decodeDataUrl(url);
      if (embedded) return this.#writer.bytes(uuid, embedded.bytes, embedded.mediaType, values);
      if (!isAddress(url)) return this.#writer.file(url, values);
      this.#notes.add(`the image ${url.slice(0, 200)} is on another server, and not fetched`);
      return null;
    }
    if (!Array.isArray(url)) {
      const { data, width, height, type } = url;
      const isBytes = /^Uint8(Clamped)?Array$/.test(type) && data.length === 4 * width * height;
      if (isBytes)
        return this.#writer.bytes(
          uuid,
          encodePng(Uint8Array.from(data as number[]), width, height),
          'image/png',
          values,
        );
    }
    this.#notes.add('a texture of numbers that are not 8-bit RGBA, or of several images, is not read');
    return null;
  }
}

/**
 * three.js turns about a centre of the texture's own, here it is the origin: the offset takes that in. And an image that
 * is not flipped has its first row at v = 0: here that is at v = 1, so v is turned upside down after all else.
 */
function placeOf({ repeat, offset, center, rotation, flipY }: SourceTexture) {
  const [[sx, sy], [cx, cy]] = [repeat, center];
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  const x = offset[0] + cx - sx * (cos * cx + sin * cy);
  const y = offset[1] + cy - sy * (-sin * cx + cos * cy);
  const limited = (value: number) => MathUtils.clamp(value, -1e4, 1e4);
  return {
    repeat: [limited(sx), limited(flipY ? sy : -sy)] as [number, number],
    offset: [limited(x), limited(flipY ? y : 1 - y)] as [number, number],
    rotation: MathUtils.radToDeg(rotation) % 360,
  };
}
