/**
 * A glTF file that has been read and checked. Whatever it was made of (GLB, JSON with embedded
 * data, JSON with files beside it), it is one GLB from here on.
 */

import { decodeDataUrl } from '../../scene/base64.ts';
import { schemaIssues, shortened } from '../../scene/error.ts';
import { type Companions, findCompanion, imageType, isAddress, pathIn } from '../meshes/companions.ts';
import { checkGltf, meshoptOf } from './check.ts';
import { GltfError } from './error.ts';
import { isGlb, padded, readGlb, writeGlb } from './glb.ts';
import type { Notes } from './notes.ts';
import { type Gltf, gltfSchema, imageIndex } from './schema.ts';

export interface GltfFile {
  name: string;
  json: Gltf;
  /** The only buffer. */
  binary: Uint8Array;
}

/**
 * Throws GltfError, and nothing else, whatever the bytes are.
 *
 * @param notes takes the images that cannot be had; without it their absence is an error
 */
export function readGltf(
  bytes: Uint8Array,
  name: string,
  companions: Companions = new Map(),
  notes: Notes | null = null,
): GltfFile {
  const glb = isGlb(bytes) ? readGlb(bytes, name) : null;
  const json = parse(glb?.json ?? bytes, name);
  const parts = json.buffers.map((buffer, i) => {
    if (buffer.uri === undefined && i === 0 && glb?.binary) return glb.binary;
    if (buffer.uri === undefined) throw new GltfError(name, `buffers[${i}]: there is no data for it`);
    return resolve(buffer.uri, `buffers[${i}]`, name, companions).bytes;
  });
  const sizes = parts.map((part, i) => {
    const claimed = json.buffers[i]?.byteLength ?? 0;
    if (claimed > part.length)
      throw new GltfError(name, `buffers[${i}]: ${claimed} bytes announced, ${part.length} are there`);
    return claimed;
  });
  checkGltf(json, sizes, name);
  return { name, ...embed(json, parts, name, companions, notes) };
}

export function gltfBytes(file: GltfFile): Uint8Array<ArrayBuffer> {
  return writeGlb(file.json, file.binary);
}

/** The encoded image of a texture. */
export function textureImage(file: GltfFile, texture: number): { bytes: Uint8Array; mediaType: string } {
  const found = file.json.textures[texture];
  if (found === undefined) throw new GltfError(file.name, `there is no textures[${texture}]`);
  const image = file.json.images[imageIndex(found) ?? -1];
  if (image?.bufferView === undefined)
    throw new GltfError(file.name, `textures[${texture}]: its image is in a format that is not read here`);
  const view = file.json.bufferViews[image.bufferView];
  if (view === undefined) throw new GltfError(file.name, `textures[${texture}]: there is no data for it`);
  const bytes = file.binary.subarray(view.byteOffset, view.byteOffset + view.byteLength);
  return { bytes, mediaType: image.mimeType ?? 'image/png' };
}

function parse(bytes: Uint8Array, name: string): Gltf {
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (cause) {
    throw new GltfError(name, 'not a glTF file: neither GLB nor JSON', { cause });
  }
  const result = gltfSchema.safeParse(json);
  if (!result.success) {
    const [issue] = schemaIssues(result.error);
    throw new GltfError(name, `not a valid glTF 2.0 file: ${issue?.path || 'content'}: ${issue?.message}`);
  }
  if (!/^2\./.test(result.data.asset.version))
    throw new GltfError(name, `glTF version ${shortened(result.data.asset.version)}; only 2.x can be read`);
  return result.data;
}

function resolve(uri: string, path: string, name: string, companions: Companions) {
  const embedded = decodeDataUrl(uri);
  if (embedded !== null) return embedded;
  if (isAddress(uri)) throw new GltfError(name, `${path}: refers to ${shortened(uri)}, which is not fetched`);
  const found = findCompanion(companions, uri);
  if (found !== null) return { bytes: found.content, mediaType: imageType(found.path) };
  throw new GltfError(
    name,
    `${path}: needs the file ${shortened(pathIn(uri))}; open or drop it together with this one, as a folder or a zip`,
  );
}

/** What a person is told of an image that is not to be had. */
function whyLost(uri: string, companions: Companions): string | null {
  if (decodeDataUrl(uri) !== null || findCompanion(companions, uri) !== null) return null;
  return isAddress(uri)
    ? `the image ${uri.slice(0, 200)} is on another server, and not fetched`
    : `the image ${pathIn(uri).slice(0, 200)} did not come along: drop the whole folder, or a zip of it, to have it`;
}

/** All buffers and image files as one buffer. */
function embed(json: Gltf, parts: Uint8Array[], name: string, companions: Companions, notes: Notes | null) {
  const bufferViews = [...json.bufferViews];
  const pieces = [...parts];
  const offsets: number[] = [];
  let length = 0;
  const append = (part: Uint8Array): void => {
    offsets.push(length);
    length += padded(part.length);
  };
  for (const part of parts) append(part);
  const images = json.images.map((image, i) => {
    if (image.uri === undefined) return image;
    const { uri, ...rest } = image;
    const lost = notes && whyLost(uri, companions);
    if (lost) {
      notes.add(lost);
      return rest;
    }
    const { bytes, mediaType } = resolve(uri, `images[${i}]`, name, companions);
    pieces.push(bytes);
    append(bytes);
    bufferViews.push({ buffer: pieces.length - 1, byteOffset: 0, byteLength: bytes.length });
    return { ...rest, mimeType: image.mimeType ?? mediaType, bufferView: bufferViews.length - 1 };
  });
  const binary = pieces.length === 1 ? (pieces[0] as Uint8Array) : new Uint8Array(length);
  if (pieces.length > 1) for (const [i, piece] of pieces.entries()) binary.set(piece, offsets[i]);
  const moved = bufferViews.map((view) => moveView(view, offsets));
  const buffers = pieces.length === 0 ? [] : [{ byteLength: binary.length }];
  return { json: { ...json, images, bufferViews: moved, buffers }, binary };
}

function moveView(
  view: Gltf['bufferViews'][number],
  offsets: readonly number[],
): Gltf['bufferViews'][number] {
  const packed = meshoptOf(view.extensions);
  if (packed === null)
    return { ...view, buffer: 0, byteOffset: view.byteOffset + (offsets[view.buffer] ?? 0) };
  const { name, value } = packed;
  const moved = { ...value, buffer: 0, byteOffset: value.byteOffset + (offsets[value.buffer] ?? 0) };
  // The view itself describes fallback data, which need not be there.
  return { ...view, buffer: 0, byteOffset: 0, extensions: { ...view.extensions, [name]: moved } };
}
