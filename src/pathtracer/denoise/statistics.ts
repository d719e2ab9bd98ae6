/** What pixels about a pixel say of it. */
import { type Features, featureDistance } from './features.ts';
import type { Planes } from './planes.ts';

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Means over squares of 2 radius + 1 pixels, smaller at the rim. */
export function boxMean(values: Float32Array, { width, height }: Size, radius: number): Float32Array {
  const rows = alongLines(values, height, width, width, 1, radius);
  return alongLines(rows, width, height, 1, width, radius);
}

function alongLines(
  values: Float32Array,
  lines: number,
  length: number,
  lineStep: number,
  step: number,
  radius: number,
): Float32Array {
  const out = new Float32Array(values.length);
  for (let line = 0; line < lines; line++) {
    const start = line * lineStep;
    for (let i = 0; i < length; i++) {
      const [from, to] = [Math.max(0, i - radius), Math.min(length - 1, i + radius)];
      let sum = 0;
      for (let k = from; k <= to; k++) sum += values[start + k * step]!;
      out[start + i * step] = sum / (to - from + 1);
    }
  }
  return out;
}

const SPREAD_RADIUS = 2;

/** With the variance of the pixels about it where a pixel has too few samples to have one of its own. */
export function usableVariance(planes: Planes, count: Float64Array): Planes {
  if (count.every((n) => n >= 2)) return planes;
  const spread = new Float32Array(count.length);
  for (const channel of planes.channels) {
    const mean = boxMean(channel, planes, SPREAD_RADIUS);
    const squares = boxMean(
      channel.map((x) => x * x),
      planes,
      SPREAD_RADIUS,
    );
    for (let pixel = 0; pixel < spread.length; pixel++)
      spread[pixel]! += Math.max(0, squares[pixel]! - mean[pixel]! ** 2);
  }
  return { ...planes, variance: planes.variance.map((x, pixel) => (count[pixel]! < 2 ? spread[pixel]! : x)) };
}

/** Of one degree of freedom: the noise of R, G and B goes together. */
const CHI_SQUARED_MEDIAN = 0.455;
/** Distance of features (featureDistance()) up to which pixels show the same surface. */
const ALIKE = 0.5;
/** Relative variances below this are the rounding of float32 sums. */
const ROUNDING = 1e-6;

/**
 * How much smaller the noise is than the variances say, 1 at most: samples are spread more evenly than independent
 * ones. Neighbours with alike features differ by noise alone in most places; the median does not mind the others.
 */
export function noiseScale({ width, channels, variance }: Planes, features: Features): number {
  const ratios: number[] = [];
  const [a, b, c] = channels as [Float32Array, Float32Array, Float32Array];
  for (let p = 0; p + 1 < variance.length; p++) {
    const q = p + 1;
    const expected = variance[p]! + variance[q]!;
    if (
      q % width === 0 ||
      expected <= ROUNDING * (a[p]! + b[p]! + c[p]!) ** 2 ||
      featureDistance(features, p, q) > ALIKE
    )
      continue;
    ratios.push(((a[p]! - a[q]!) ** 2 + (b[p]! - b[q]!) ** 2 + (c[p]! - c[q]!) ** 2) / expected);
  }
  ratios.sort((x, y) => x - y);
  return Math.min(1, (ratios[ratios.length >> 1] ?? CHI_SQUARED_MEDIAN) / CHI_SQUARED_MEDIAN);
}
