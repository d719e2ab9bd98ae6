/** An image decoded by sharp, under the name by which three.js and its loaders know decoded images. */
export class NodeImageBitmap {
  constructor(
    readonly width: number,
    readonly height: number,
    readonly data: Uint8Array,
  ) {}
  close(): void {}
}

/** Decodes a PNG, JPEG or WebP file to 8-bit RGBA, rows from the top. */
export async function decodeImage(file: Uint8Array): Promise<NodeImageBitmap> {
  const { default: sharp } = await import('sharp');
  const decoded = await sharp(file)
    .ensureAlpha()
    .toColourspace('srgb')
    .raw()
    .toBuffer({ resolveWithObject: true });
  const { data, info } = decoded;
  return new NodeImageBitmap(
    info.width,
    info.height,
    new Uint8Array(data.buffer, data.byteOffset, data.length),
  );
}

export function flipRows(pixels: Uint8Array, rowBytes: number): Uint8Array {
  const flipped = new Uint8Array(pixels.length);
  for (let at = 0; at < pixels.length; at += rowBytes) {
    flipped.set(pixels.subarray(at, at + rowBytes), pixels.length - rowBytes - at);
  }
  return flipped;
}
