import { unzlibSync } from 'fflate';
import { ByteReader } from './bytes.ts';
import {
  BYTES,
  COMPRESSIONS,
  type ExrChannel,
  type ExrImage,
  LINES_PER_CHUNK,
  MAGIC,
  OWN_ATTRIBUTES,
  PIXEL_TYPES,
  UNSUPPORTED_FLAGS,
  unpredict,
  VERSION,
} from './exr-format.ts';
import { fromHalf } from './half.ts';

/** Throws a ByteError, which names the file and the byte, for a file that is broken or not of this kind. */
export function decodeExr(file: Uint8Array, fileName: string): ExrImage {
  const input = new ByteReader(file, fileName);
  const { width, height, top, channels, compression, attributes } = readHeader(input);
  const linesPerChunk = LINES_PER_CHUNK[compression] as number;
  const bytesPerLine = channels.reduce((sum, { type }) => sum + width * BYTES[type], 0);
  const chunkCount = Math.ceil(height / linesPerChunk);
  // zlib shrinks by 1032 at most, so a tiny file cannot ask for gigabytes.
  if (chunkCount * 16 > file.length || bytesPerLine * height > file.length * 1032) {
    throw input.error(`the file is too short for ${width} x ${height} pixels`);
  }
  const image = channels.map((channel) => ({ ...channel, pixels: new Float32Array(width * height) }));
  const seen = new Uint8Array(chunkCount);
  const offsets = Array.from({ length: chunkCount }, () => input.uint64());
  for (const offset of offsets) {
    input.seek(offset);
    const line = input.int32() - top;
    const index = line / linesPerChunk;
    if (!Number.isInteger(index) || index < 0 || index >= chunkCount || seen[index]) {
      throw input.error(`a chunk starts at line ${line + top}, which no chunk or another one does`);
    }
    seen[index] = 1;
    const lines = Math.min(linesPerChunk, height - line);
    unpackLines(image, width, line, lines, readChunk(input, bytesPerLine * lines, compression));
  }
  return { width, height, channels: image, attributes };
}

interface Header {
  width: number;
  height: number;
  top: number;
  channels: { name: string; type: 'half' | 'float' }[];
  compression: string;
  attributes: Record<string, string | number>;
}

function readHeader(input: ByteReader): Header {
  if (input.int32() !== MAGIC) throw input.error('not an OpenEXR file');
  const version = input.int32();
  if ((version & 0xff) !== VERSION) throw input.error(`version ${version & 0xff} of the format; expected 2`);
  for (const [flag, what] of UNSUPPORTED_FLAGS) {
    if (version & flag) throw input.error(`a file of ${what}; expected one part of scan lines`);
  }
  const header: Header = { width: 0, height: 0, top: 0, channels: [], compression: '', attributes: {} };
  for (let name = input.cString(); name !== ''; name = input.cString()) {
    const type = input.cString();
    const size = input.int32();
    const end = input.position + size;
    input.need(size);
    readAttribute(input, header, name, type, size);
    input.seek(end);
  }
  for (const [name, missing] of [
    ['channels', header.channels.length === 0],
    ['dataWindow', header.width === 0],
    ['compression', header.compression === ''],
  ]) {
    if (missing) throw input.error(`the header has no ${name}`);
  }
  return header;
}

function readAttribute(input: ByteReader, header: Header, name: string, type: string, size: number): void {
  if (name === 'channels') {
    header.channels = readChannels(input);
  } else if (name === 'compression') {
    const index = input.uint8();
    header.compression = COMPRESSIONS[index] ?? `number ${index}`;
    if (!Object.hasOwn(LINES_PER_CHUNK, header.compression)) {
      throw input.error(`compression ${header.compression} is not supported; expected none, ZIPS or ZIP`);
    }
  } else if (name === 'dataWindow') {
    const [left, top, right, bottom] = [input.int32(), input.int32(), input.int32(), input.int32()] as const;
    if (right < left || bottom < top) throw input.error('the dataWindow is empty');
    Object.assign(header, { width: right - left + 1, height: bottom - top + 1, top });
  } else if (!OWN_ATTRIBUTES.has(name)) {
    if (type === 'int' && size === 4) header.attributes[name] = input.int32();
    if (type === 'string') header.attributes[name] = input.utf8(size);
  }
}

function readChannels(input: ByteReader): Header['channels'] {
  const channels: Header['channels'] = [];
  for (let name = input.cString(); name !== ''; name = input.cString()) {
    const number = input.int32();
    const type = PIXEL_TYPES[number];
    if (type !== 'half' && type !== 'float') {
      throw input.error(`channel ${name} has pixel type ${type ?? number}; expected half or float`);
    }
    input.int32();
    if (input.int32() !== 1 || input.int32() !== 1) throw input.error(`channel ${name} is subsampled`);
    channels.push({ name, type });
  }
  return channels;
}

function readChunk(input: ByteReader, expected: number, compression: string): Uint8Array {
  const size = input.int32();
  if (size < 0 || size > expected)
    throw input.error(`a chunk of ${size} bytes; expected at most ${expected}`);
  const data = input.bytes(size);
  if (size === expected) return data;
  if (compression === 'none') throw input.error(`a chunk of ${size} bytes; expected ${expected}`);
  let raw: Uint8Array;
  try {
    raw = unzlibSync(data, { out: new Uint8Array(expected) });
  } catch (cause) {
    throw input.error('a chunk that is no zlib stream', cause);
  }
  if (raw.length !== expected)
    throw input.error(`a chunk unpacks to ${raw.length} bytes; expected ${expected}`);
  return unpredict(raw);
}

function unpackLines(
  channels: readonly ExrChannel[],
  width: number,
  from: number,
  count: number,
  raw: Uint8Array,
): void {
  const view = new DataView(raw.buffer, raw.byteOffset, raw.byteLength);
  let at = 0;
  for (let y = from; y < from + count; y++) {
    for (const { type, pixels } of channels) {
      for (let x = 0; x < width; x++) {
        pixels[y * width + x] =
          type === 'half' ? fromHalf(view.getUint16(at, true)) : view.getFloat32(at, true);
        at += BYTES[type];
      }
    }
  }
}
