/** Truevision TGA, which textures of older OBJ models are in, as PNG. Format: Truevision, "TGA File Format Specification", 1991. */
import { TGALoader } from 'three/addons/loaders/TGALoader.js';
import { encodePng } from '../png.ts';

const HEADER = 18;
/** Texels: what a GPU takes as one texture. */
const MOST = 2 ** 26;

/** Null for what is no such image. */
export function pngOfTga(bytes: Uint8Array): Uint8Array | null {
  if (bytes.length < HEADER) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const [width, height] = [view.getUint16(12, true), view.getUint16(14, true)];
  // A run of 128 texels takes a byte and one texel: less than this cannot be all of it.
  if (width * height > MOST || width * height > 128 * bytes.length) return null;
  try {
    const image = new TGALoader().parse(bytes.slice().buffer);
    return image.data instanceof Uint8Array ? encodePng(image.data, width, height) : null;
  } catch {
    return null;
  }
}
