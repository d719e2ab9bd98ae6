/** Pictures of a pattern: bytes, the same for everyone who shows it. */
import { linearToSrgb } from '../../color/srgb.ts';
import { DocumentError } from '../error.ts';
import type { Asset } from '../schema.ts';
import { COLOR, NORMALS, SURFACE } from './asset.ts';
import type { Point } from './kind.ts';
import { kindOf, type Pattern, readPatternAsset } from './pattern.ts';

export interface PatternImage {
  /** RGBA, opaque; row 0 is v = 0. */
  readonly data: Uint8Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
}

/**
 * Mean of the roughness in a picture of the surface, 0..1, so that there is as much room above it as patterns need: a
 * material whose roughness is to be r on average has r / MEAN_ROUGHNESS for its parameter.
 */
export const MEAN_ROUGHNESS = 0.8;

/** What is computed once for the pictures of a pattern: size x size values each. */
interface Fields {
  readonly colors: readonly [Float32Array, Float32Array, Float32Array];
  readonly height: Float32Array;
  readonly roughness: Float32Array;
}

/** @throws DocumentError with the field that is wrong, or that says which pictures there are */
export function drawPatternAsset(asset: Asset, texture: number | null): PatternImage {
  const pattern = readPatternAsset(asset);
  if (texture !== null && texture > SURFACE)
    throw new DocumentError(asset.name, [{ path: '', message: `a pattern has no picture ${texture}` }]);
  return drawPattern(pattern, texture);
}

/** A material asks for one picture of a pattern after the other. */
let last: { readonly text: string; readonly fields: Fields } | null = null;

/** @param texture as in a texture's reference */
export function drawPattern(pattern: Pattern, texture: number | null): PatternImage {
  const text = JSON.stringify(pattern);
  const fields = last?.text === text ? last.fields : computeFields(pattern);
  last = { text, fields };
  const { size } = pattern;
  const data = new Uint8Array(4 * size * size).fill(255);
  switch (texture ?? COLOR) {
    case COLOR:
      drawColor(fields, pattern, data);
      break;
    case NORMALS:
      drawNormals(fields, pattern, data);
      break;
    default:
      drawSurface(fields, data);
  }
  return { data, width: size, height: size };
}

/** Each texel has what is in its middle. */
function computeFields(pattern: Pattern): Fields {
  const { size } = pattern;
  const sample = kindOf(pattern.pattern).sampler(pattern as never);
  const field = () => new Float32Array(size * size);
  const [red, green, blue, height, roughness] = [field(), field(), field(), field(), field()];
  const point: Point = { red: 0, green: 0, blue: 0, height: 0, roughness: 0 };
  for (let i = 0; i < size * size; i++) {
    sample(((i % size) + 0.5) / size, (Math.floor(i / size) + 0.5) / size, point);
    red[i] = point.red;
    green[i] = point.green;
    blue[i] = point.blue;
    height[i] = point.height;
    roughness[i] = point.roughness;
  }
  return { colors: [red, green, blue], height, roughness };
}

function drawColor({ colors }: Fields, { color }: Pattern, data: Uint8Array): void {
  for (const [c, values] of colors.entries()) {
    const scale = scaleTo(values, color[c as 0]);
    for (const [i, value] of values.entries()) data[4 * i + c] = byte(linearToSrgb(clipped(value * scale)));
  }
}

function drawSurface({ height, roughness }: Fields, data: Uint8Array): void {
  const scale = scaleTo(roughness, MEAN_ROUGHNESS);
  for (let i = 0; i < height.length; i++) {
    data[4 * i] = byte(height[i]!);
    data[4 * i + 1] = byte(clipped(roughness[i]! * scale));
  }
}

function drawNormals({ height }: Fields, pattern: Pattern, data: Uint8Array): void {
  const { size, relief } = pattern;
  // Central differences over two texels, in widths of the picture.
  const steepness = (kindOf(pattern.pattern).depth(pattern as never) * relief * size) / 2;
  for (let y = 0; y < size; y++) {
    const [row, above, below] = [y * size, ((y + 1) % size) * size, ((y + size - 1) % size) * size];
    for (let x = 0; x < size; x++) {
      const [right, left] = [(x + 1) % size, (x + size - 1) % size];
      const dx = steepness * (height[row + right]! - height[row + left]!);
      const dy = steepness * (height[above + x]! - height[below + x]!);
      const length = Math.sqrt(dx * dx + dy * dy + 1);
      const at = 4 * (row + x);
      data[at] = byte(0.5 - 0.5 * (dx / length));
      data[at + 1] = byte(0.5 - 0.5 * (dy / length));
      data[at + 2] = byte(0.5 + 0.5 / length);
    }
  }
}

const byte = (value: number): number => Math.round(255 * value);
const clipped = (value: number): number => Math.min(1, Math.max(0, value));

/** Far less than a byte's step. */
const TOLERANCE = 1e-5;
const MOST_STEPS = 30;

/**
 * What values are multiplied by so that their mean is `mean` after what is more than 1 is clipped. Newton's method: the mean
 * bends one way only, so that it comes from below and does not overshoot.
 */
function scaleTo(values: Float32Array, mean: number): number {
  let scale = 0;
  for (let step = 0; step < MOST_STEPS; step++) {
    let now = 0;
    let slope = 0;
    for (const value of values) {
      if (value * scale < 1) slope += Math.max(0, value);
      now += clipped(value * scale);
    }
    const missing = mean * values.length - now;
    if (slope <= 0 || Math.abs(missing) < TOLERANCE * values.length) break;
    scale += missing / slope;
  }
  return scale;
}
