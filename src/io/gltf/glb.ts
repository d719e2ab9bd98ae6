/** The GLB container: a 12 byte header, a chunk of JSON and at most one of binary data. */
import { GltfError } from './error.ts';

const magic = 0x46546c67;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

export function isGlb(bytes: Uint8Array): boolean {
  return bytes.length >= 4 && view(bytes).getUint32(0, true) === magic;
}

export function readGlb(bytes: Uint8Array, file: string): { json: Uint8Array; binary: Uint8Array | null } {
  const data = view(bytes);
  if (bytes.length < 20) throw new GltfError(file, 'the file ends within the GLB header');
  const version = data.getUint32(4, true);
  if (version !== 2) throw new GltfError(file, `GLB version ${version}; only version 2 can be read`);
  const length = data.getUint32(8, true);
  if (length > bytes.length)
    throw new GltfError(file, `truncated: the header says ${length} bytes, the file has ${bytes.length}`);
  let json: Uint8Array | null = null;
  let binary: Uint8Array | null = null;
  for (let at = 12; at + 8 <= length; ) {
    const size = data.getUint32(at, true);
    const type = data.getUint32(at + 4, true);
    const start = at + 8;
    if (start + size > length) throw new GltfError(file, `the chunk at byte ${at} reaches beyond the file`);
    if (type === jsonChunk && json === null) json = bytes.subarray(start, start + size);
    else if (type === binaryChunk && binary === null) binary = bytes.subarray(start, start + size);
    at = start + size;
  }
  if (json === null) throw new GltfError(file, 'the GLB has no JSON chunk');
  return { json, binary };
}

export function writeGlb(json: unknown, binary: Uint8Array): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textSize = padded(text.length);
  const binarySize = padded(binary.length);
  const length = 12 + 8 + textSize + (binarySize > 0 ? 8 + binarySize : 0);
  const bytes = new Uint8Array(length);
  const data = view(bytes);
  data.setUint32(0, magic, true);
  data.setUint32(4, 2, true);
  data.setUint32(8, length, true);
  data.setUint32(12, textSize, true);
  data.setUint32(16, jsonChunk, true);
  bytes.fill(0x20, 20, 20 + textSize);
  bytes.set(text, 20);
  if (binarySize > 0) {
    const at = 20 + textSize;
    data.setUint32(at, binarySize, true);
    data.setUint32(at + 4, binaryChunk, true);
    bytes.set(binary, at + 8);
  }
  return bytes;
}

/** Chunks and the parts of a buffer begin at multiples of four bytes. */
export const padded = (size: number): number => Math.ceil(size / 4) * 4;

const view = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
