/** An environment's image as numbers, whatever its file was. */
import { type DataTexture, DataUtils, HalfFloatType, type Texture } from 'three/webgpu';
import type { EnvironmentMap } from './environment-map.ts';

/** The largest half float: what an image says is infinite was brighter than its format. */
const BRIGHTEST = 65_504;

/** Null of what has no RGBA texels to read. */
export function environmentTexels(texture: Texture): EnvironmentMap | null {
  const { image, type, flipY } = texture as DataTexture;
  const { data, width, height } = image as {
    data: Float32Array | Uint16Array | null;
    width: number;
    height: number;
  };
  if (!data || data.length !== 4 * width * height) return null;
  const texels = new Float32Array(data.length);
  const row = 4 * width;
  for (let y = 0; y < height; y += 1) {
    const to = (flipY ? height - 1 - y : y) * row;
    for (let i = 0; i < row; i += 1) {
      const stored = data[y * row + i] as number;
      const value = type === HalfFloatType ? DataUtils.fromHalfFloat(stored) : stored;
      texels[to + i] = value >= 0 ? (value < Number.POSITIVE_INFINITY ? value : BRIGHTEST) : 0;
    }
  }
  return { texels, width, height };
}
