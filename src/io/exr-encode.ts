import { zlibSync } from 'fflate';
import { ByteWriter } from './bytes.ts';
import {
  COMPRESSIONS,
  type ExrChannel,
  type ExrImage,
  type ExrOptions,
  LONG_NAMES,
  MAGIC,
  OWN_ATTRIBUTES,
  PIXEL_TYPES,
  predict,
  VERSION,
} from './exr-format.ts';
import { toHalf } from './half.ts';

export function encodeExr(image: ExrImage, { compression = 'zip' }: ExrOptions = {}): Uint8Array {
  const { width, height } = image;
  const channels = [...image.channels].sort((a, b) => (a.name < b.name ? -1 : 1));
  checkImage(image);
  const out = new ByteWriter();
  writeHeader(out, image, channels, compression);

  const linesPerChunk = compression === 'zip' ? 16 : 1;
  const chunkCount = Math.ceil(height / linesPerChunk);
  const table = out.length;
  for (let i = 0; i < chunkCount; i++) out.uint64(0);
  for (let i = 0; i < chunkCount; i++) {
    const y = i * linesPerChunk;
    const raw = packLines(channels, width, y, Math.min(height, y + linesPerChunk));
    const packed = compression === 'zip' ? zlibSync(predict(raw)) : raw;
    // A chunk that does not get smaller is stored as it is; that is how readers tell the two apart.
    const data = packed.length < raw.length ? packed : raw;
    out.setUint64(table + i * 8, out.length);
    out.int32(y);
    out.int32(data.length);
    out.bytes(data);
  }
  return out.finish();
}

function checkImage({ width, height, channels, attributes = {} }: ExrImage): void {
  const isName = (name: string) => /^[^\0]{1,255}$/.test(name);
  const names = new Set(channels.map(({ name }) => name));
  if (names.size !== channels.length) throw new RangeError('EXR channels need different names');
  for (const { name, pixels } of channels) {
    if (!isName(name)) throw new RangeError(`'${name}' cannot name a channel`);
    if (pixels.length !== width * height) {
      throw new RangeError(`channel ${name} has ${pixels.length} pixels, not ${width} x ${height}`);
    }
  }
  for (const [name, value] of Object.entries(attributes)) {
    if (OWN_ATTRIBUTES.has(name) || !isName(name)) throw new RangeError(`'${name}' cannot name an attribute`);
    if (typeof value === 'number' && value !== (value | 0)) {
      throw new RangeError(`attribute ${name}: ${value} is not a 32-bit integer`);
    }
  }
}

function writeHeader(
  out: ByteWriter,
  { width, height, attributes = {} }: ExrImage,
  channels: readonly ExrChannel[],
  compression: 'none' | 'zip',
): void {
  const longNames = [...Object.keys(attributes), ...channels.map(({ name }) => name)].some(
    (n) => n.length > 31,
  );
  const attribute = (name: string, type: string, write: () => void) => {
    out.cString(name);
    out.cString(type);
    const sizeAt = out.length;
    out.int32(0);
    write();
    out.setInt32(sizeAt, out.length - sizeAt - 4);
  };
  const window = () => {
    for (const edge of [0, 0, width - 1, height - 1]) out.int32(edge);
  };

  out.int32(MAGIC);
  out.int32(VERSION | (longNames ? LONG_NAMES : 0));
  attribute('channels', 'chlist', () => {
    for (const { name, type } of channels) {
      out.cString(name);
      out.int32(PIXEL_TYPES.indexOf(type));
      out.int32(0);
      out.int32(1);
      out.int32(1);
    }
    out.uint8(0);
  });
  attribute('compression', 'compression', () =>
    out.uint8(COMPRESSIONS.indexOf(compression === 'zip' ? 'ZIP' : 'none')),
  );
  attribute('dataWindow', 'box2i', window);
  attribute('displayWindow', 'box2i', window);
  attribute('lineOrder', 'lineOrder', () => out.uint8(0));
  attribute('pixelAspectRatio', 'float', () => out.float32(1));
  attribute('screenWindowCenter', 'v2f', () => {
    out.float32(0);
    out.float32(0);
  });
  attribute('screenWindowWidth', 'float', () => out.float32(1));
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'number') attribute(name, 'int', () => out.int32(value));
    else attribute(name, 'string', () => out.utf8(value));
  }
  out.uint8(0);
}

/** The lines of a chunk one by one, in each the channels one by one. */
function packLines(channels: readonly ExrChannel[], width: number, from: number, to: number): Uint8Array {
  const out = new ByteWriter();
  for (let y = from; y < to; y++) {
    for (const { type, pixels } of channels) {
      for (const value of pixels.subarray(y * width, (y + 1) * width)) {
        if (type === 'half') out.uint16(toHalf(value));
        else out.float32(value);
      }
    }
  }
  return out.finish();
}
