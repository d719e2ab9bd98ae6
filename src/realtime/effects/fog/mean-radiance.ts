import { Color, HalfFloatType, type Texture } from 'three/webgpu';
import { fromHalf } from '../../../io/half.ts';

const known = new WeakMap<Texture, { version: number; mean: Color }>();

/** Of an equirectangular image of numbers, over all directions; black where it has none to read. */
export function meanRadiance(texture: Texture): Color {
  const before = known.get(texture);
  if (before?.version === texture.version) return before.mean;
  const {
    data,
    width = 0,
    height = 0,
  } = (texture.image ?? {}) as {
    data?: Uint16Array | Float32Array;
    width?: number;
    height?: number;
  };
  const mean = new Color(0, 0, 0);
  const read = texture.type === HalfFloatType ? fromHalf : (x: number) => x;
  if (data && data.length >= 4 * width * height) {
    for (let y = 0; y < height; y++) {
      // The part of the sphere that each texel of the row has.
      const [top, bottom] = [Math.cos((Math.PI * y) / height), Math.cos((Math.PI * (y + 1)) / height)];
      const weight = (top - bottom) / 2 / width;
      for (let x = 0; x < width; x++) {
        const at = 4 * (y * width + x);
        mean.r += weight * read(data[at]!);
        mean.g += weight * read(data[at + 1]!);
        mean.b += weight * read(data[at + 2]!);
      }
    }
  }
  known.set(texture, { version: texture.version, mean });
  return mean;
}
