/**
 * OpenEXR files: one part of scan lines, half or float channels of any names, uncompressed or ZIP.
 * File layout: https://openexr.com/en/latest/OpenEXRFileLayout.html
 */
export interface ExrImage {
  width: number;
  height: number;
  channels: readonly ExrChannel[];
  /** Kept in the header: text as `string`, integers as `int`. */
  attributes?: Readonly<Record<string, string | number>>;
}

export interface ExrChannel {
  /** 'R', 'G', 'B' and 'A' are what viewers look for; a layer's are 'layer.R'. */
  name: string;
  type: 'half' | 'float';
  /** width x height values, rows from the top. */
  pixels: Float32Array;
}

export interface ExrOptions {
  compression?: 'none' | 'zip';
}

export const MAGIC = 20000630;
export const VERSION = 2;
export const LONG_NAMES = 0x400;
export const UNSUPPORTED_FLAGS: readonly [number, string][] = [
  [0x200, 'tiles'],
  [0x800, 'deep data'],
  [0x1000, 'several parts'],
];
export const COMPRESSIONS = ['none', 'RLE', 'ZIPS', 'ZIP', 'PIZ', 'PXR24', 'B44', 'B44A', 'DWAA', 'DWAB'];
export const LINES_PER_CHUNK: Readonly<Record<string, number>> = { none: 1, ZIPS: 1, ZIP: 16 };
export const PIXEL_TYPES = ['uint', 'half', 'float'] as const;
export const BYTES = { half: 2, float: 4 } as const;

/** Attributes that the layout itself needs; all others are the caller's. */
export const OWN_ATTRIBUTES = new Set([
  'channels',
  'compression',
  'dataWindow',
  'displayWindow',
  'lineOrder',
  'pixelAspectRatio',
  'screenWindowCenter',
  'screenWindowWidth',
]);

/** What ZIP does before zlib: the even bytes first, then the odd ones, each as its difference to the last. */
export function predict(raw: Uint8Array): Uint8Array {
  const out = new Uint8Array(raw.length);
  const half = (raw.length + 1) >> 1;
  for (let i = 0; i < raw.length; i++) out[(i & 1 ? half : 0) + (i >> 1)] = raw[i]!;
  for (let i = out.length - 1; i > 0; i--) out[i] = out[i]! - out[i - 1]! + 128;
  return out;
}

/** The inverse of predict(). */
export function unpredict(data: Uint8Array): Uint8Array {
  for (let i = 1; i < data.length; i++) data[i] = data[i]! + data[i - 1]! - 128;
  const out = new Uint8Array(data.length);
  const half = (data.length + 1) >> 1;
  for (let i = 0; i < data.length; i++) out[i] = data[(i & 1 ? half : 0) + (i >> 1)]!;
  return out;
}
