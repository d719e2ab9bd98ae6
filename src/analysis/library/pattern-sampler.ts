/** Looks at a picture of a pattern in a small picture of a ball: blurred as much as a pixel of the ball has of it. */
import { srgbToLinear } from '../../color/srgb.ts';
import { decodeBase64 } from '../../scene/base64.ts';
import { COLOR } from '../../scene/pattern/asset.ts';
import { drawPattern } from '../../scene/pattern/draw.ts';
import { readPattern } from '../../scene/pattern/pattern.ts';
import type { TextureRef } from '../../scene/schema.ts';
import type { Rgb } from '../plots/curve.ts';
import type { Vec3 } from '../vector.ts';

/** Where a material shows a pattern. */
export interface PatternUse {
  /** A parameter of the model, or `normalMap`. */
  readonly place: string;
  /** The asset's data. */
  readonly data: string;
  readonly ref: Pick<TextureRef, 'texture' | 'channel' | 'repeat' | 'offset' | 'rotation'>;
  /** Of normals. */
  readonly scale: number;
}

export interface PatternSampler {
  readonly mean: Rgb;
  /** Linear. @param n of a ball whose poles are above and below, as three.js lays textures on one */
  at(n: Vec3): Rgb;
}

/** Texels of a side: a small picture shows no more. */
const MOST_SIDE = 256;

/** @param radius of the ball, in pixels @throws DocumentError */
export function patternSampler({ data, ref, place }: PatternUse, radius: number): PatternSampler {
  const pattern = readPattern(decodeBase64(data), place);
  const isColor = (ref.texture ?? COLOR) === COLOR;
  let side = Math.min(pattern.size, MOST_SIDE);
  const bytes = drawPattern({ ...pattern, size: side }, ref.texture).data;
  let texels = new Float32Array(3 * side * side);
  for (let i = 0; i < side * side; i++)
    for (let c = 0; c < 3; c++) {
      const value = bytes[4 * i + c]! / 255;
      texels[3 * i + c] = isColor ? srgbToLinear(value) : value;
    }
  const { repeat, offset } = ref;
  // Where the ball is nearest: half a turn is pi radii of pixels.
  const texelsPerPixel = (side * Math.max(Math.abs(repeat[0]) / 2, Math.abs(repeat[1]))) / (Math.PI * radius);
  for (let left = texelsPerPixel; left >= 1.5 && side % 2 === 0; left /= 2) {
    texels = halved(texels, side);
    side /= 2;
  }
  const angle = (ref.rotation * Math.PI) / 180;
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  const texel = (x: number, y: number, c: number): number => {
    const wrapped = (i: number) => ((i % side) + side) % side;
    return texels[3 * (wrapped(y) * side + wrapped(x)) + c]!;
  };
  const sum = [0, 0, 0];
  for (const [i, value] of texels.entries()) sum[i % 3]! += value / (side * side);
  return {
    mean: sum as unknown as Rgb,
    at([nx, ny, nz]) {
      const u = Math.atan2(nz, -nx) / (2 * Math.PI);
      const v = 0.5 + Math.asin(Math.min(1, Math.max(-1, ny))) / Math.PI;
      const x = side * (repeat[0] * (cosine * u + sine * v) + offset[0]) - 0.5;
      const y = side * (repeat[1] * (cosine * v - sine * u) + offset[1]) - 0.5;
      const [left, low] = [Math.floor(x), Math.floor(y)];
      const [fx, fy] = [x - left, y - low];
      const between = (c: number): number =>
        (texel(left, low, c) * (1 - fx) + texel(left + 1, low, c) * fx) * (1 - fy) +
        (texel(left, low + 1, c) * (1 - fx) + texel(left + 1, low + 1, c) * fx) * fy;
      return [between(0), between(1), between(2)];
    },
  };
}

function halved(texels: Float32Array, side: number): Float32Array<ArrayBuffer> {
  const half = side / 2;
  const out = new Float32Array(3 * half * half);
  for (let y = 0; y < half; y++)
    for (let x = 0; x < half; x++)
      for (let c = 0; c < 3; c++) {
        const at = 3 * (2 * y * side + 2 * x) + c;
        const below = at + 3 * side;
        out[3 * (y * half + x) + c] =
          (texels[at]! + texels[at + 3]! + texels[below]! + texels[below + 3]!) / 4;
      }
  return out;
}
