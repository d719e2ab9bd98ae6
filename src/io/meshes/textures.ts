/** Images of a model file on their way into a GLB, where each is once, and what materials say of them. */
import { textureRef } from '../../scene/material-schema.ts';
import type { TextureRef } from '../../scene/schema.ts';
import type { Notes } from '../gltf/notes.ts';
import type { GltfWriter } from '../gltf/writer.ts';
import { type Companions, findCompanion, imageType, UNKNOWN_TYPE } from './companions.ts';
import { pngOfTga } from './tga.ts';

export class TextureWriter {
  readonly #writer: GltfWriter;
  readonly #companions: Companions;
  readonly #notes: Notes;
  readonly #textures = new Map<string, number | null>();

  constructor(writer: GltfWriter, companions: Companions, notes: Notes) {
    this.#writer = writer;
    this.#companions = companions;
    this.#notes = notes;
  }

  /** A texture that is a file; null, with a note, if the file did not come along. The asset is named later. */
  file(name: string, values: Partial<TextureRef>): TextureRef | null {
    let texture = this.#textures.get(name);
    if (texture === undefined) {
      const found = findCompanion(this.#companions, name);
      if (found === null)
        this.#notes.add(
          `the image ${name.slice(0, 200)} did not come along: drop the whole folder, or a zip of it, to have it`,
        );
      texture = found && this.#read(found.path, found.content);
      this.#textures.set(name, texture);
    }
    return texture === null ? null : textureRef('', { ...values, texture });
  }

  #read(path: string, content: Uint8Array): number | null {
    const type = imageType(path);
    if (type !== UNKNOWN_TYPE) return this.#add(path, content, type);
    const png = /\.tga$/i.test(path) ? pngOfTga(content) : null;
    if (png) return this.#add(path, png, 'image/png');
    this.#notes.add(
      `the image ${path.slice(-200)} is in a format that is not read (PNG, JPEG, WebP, AVIF, KTX2 and TGA are)`,
    );
    return null;
  }

  /** The same for an image whose bytes are at hand; `key` tells it from others. */
  bytes(key: string, bytes: Uint8Array, mediaType: string, values: Partial<TextureRef>): TextureRef {
    const texture = this.#textures.get(key) ?? this.#add(key, bytes, mediaType);
    this.#textures.set(key, texture);
    return textureRef('', { ...values, texture });
  }

  #add(name: string, bytes: Uint8Array, mediaType: string): number {
    return this.#writer.add('textures', { source: this.#writer.image(bytes, mediaType, name.slice(-200)) });
  }
}
