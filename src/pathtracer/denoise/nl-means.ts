/**
 * Non-local means: a pixel becomes the mean of those pixels about it whose surroundings look alike, as far as noise
 * lets one tell, and whose features are alike.
 *   F. Rousselle, C. Knaus, M. Zwicker, 2012, "Adaptive Rendering with Non-Local Means Filtering", ACM TOG 31(6).
 *   F. Rousselle, M. Manzi, M. Zwicker, 2013, "Robust Denoising using Feature and Color Information", CGF 32(7).
 */
import type { Pace } from '../scene/pace.ts';
import { FARTHEST, type Features, featureDistance } from './features.ts';
import type { Planes } from './planes.ts';

export interface NlMeansOptions {
  /** Pixels between the pixels that are looked at: 1 looks at all (H. Dammertz et al., 2010, "Edge-Avoiding A-Trous Wavelet Transform"). */
  readonly step: number;
  /** Steps to each side. */
  readonly radius: number;
  /** How different pixels may be, in standard deviations; more is smoother. */
  readonly strength: number;
  readonly features: Features;
  readonly pace: Pace;
  onProgress?(part: number): void;
}

/** Pixels to each side that are compared with those about another pixel. */
const PATCH = 1;
const RING = 2 * PATCH + 1;

/** Differences of pictures without noise: far below what anybody sees, and not 0. */
const LEAST_VARIANCE = 1e-12;

export async function nlMeans(planes: Planes, options: NlMeansOptions): Promise<Planes> {
  const { width, height } = planes;
  const pixels = width * height;
  const sums = {
    // A pixel is like itself.
    weight: new Float32Array(pixels).fill(1),
    channels: planes.channels.map((channel) => channel.slice()),
    variance: planes.variance.slice(),
  };
  const offsets = halfPlane(options.radius, options.step).filter(
    ([dx, dy]) => Math.abs(dx) < width && dy < height,
  );
  const rows = {
    own: Array.from({ length: RING }, () => new Float32Array(width)),
    other: Array.from({ length: RING }, () => new Float32Array(width)),
    differences: [new Float32Array(width), new Float32Array(width)] as const,
  };
  for (const [i, offset] of offsets.entries()) {
    compare(planes, options, offset, rows, sums);
    if (!options.pace.due) continue;
    options.onProgress?.(i / offsets.length);
    await options.pace.rest();
  }
  for (let pixel = 0; pixel < pixels; pixel++) {
    const scale = 1 / sums.weight[pixel]!;
    for (const channel of sums.channels) channel[pixel]! *= scale;
    sums.variance[pixel]! *= scale * scale;
  }
  return { width, height, channels: sums.channels, variance: sums.variance };
}

/** Each pair of pixels is compared once: the offsets to one half of the window. */
function halfPlane(radius: number, step: number): [dx: number, dy: number][] {
  const offsets: [number, number][] = [];
  for (let dy = 0; dy <= radius; dy++) {
    for (let dx = -radius; dx <= radius; dx++) {
      if (dy > 0 || dx > 0) offsets.push([dx * step, dy * step]);
    }
  }
  return offsets;
}

interface Rows {
  /** Sums over a patch's width of the last rows of distances. */
  readonly own: readonly Float32Array[];
  readonly other: readonly Float32Array[];
  readonly differences: readonly [Float32Array, Float32Array];
}

interface Sums {
  readonly weight: Float32Array;
  readonly channels: readonly Float32Array[];
  readonly variance: Float32Array;
}

/** Compares every pixel with the one at an offset, and gives both their share of the other. */
function compare(
  planes: Planes,
  { strength, features }: NlMeansOptions,
  [dx, dy]: readonly [number, number],
  rows: Rows,
  sums: Sums,
): void {
  const { width, height } = planes;
  const left = Math.max(0, -dx);
  const right = Math.min(width, width - dx);
  const bottom = height - dy;
  const shift = dy * width + dx;
  for (let y = 0; y < bottom + PATCH; y++) {
    const row = y % RING;
    const [own, other] = [rows.own[row]!, rows.other[row]!];
    if (y < bottom) {
      rowDifferences(planes, strength, y * width, left, right, shift, rows.differences);
      sumAlong(rows.differences[0], own, left, right);
      sumAlong(rows.differences[1], other, left, right);
    } else {
      // Beyond the rim there is nothing to compare.
      own.fill(0);
      other.fill(0);
    }
    if (y < PATCH) continue;
    const middle = y - PATCH;
    const tall = Math.min(middle + PATCH, bottom - 1) - Math.max(middle - PATCH, 0) + 1;
    if (middle === 0) clearBefore(rows, row);
    shareRow(planes, features, middle * width, left, right, shift, tall, rows, sums);
  }
}

/** The ring still has rows of the offset before. */
function clearBefore({ own, other }: Rows, row: number): void {
  for (let i = 0; i < RING; i++) {
    const age = (row - i + RING) % RING;
    if (age <= PATCH) continue;
    own[i]!.fill(0);
    other[i]!.fill(0);
  }
}

/**
 * Squared differences of two pixels beyond what their noise explains, in units of their variances: Rousselle et al.
 * 2012, eq. (4). Taking the smaller variance of the two for the other one keeps a pixel that is far too bright, which
 * has a large one, out of its neighbours.
 */
function rowDifferences(
  { channels, variance }: Planes,
  strength: number,
  start: number,
  left: number,
  right: number,
  shift: number,
  [own, other]: readonly [Float32Array, Float32Array],
): void {
  const [a, b, c] = channels as [Float32Array, Float32Array, Float32Array];
  const scale = strength * strength;
  for (let x = left; x < right; x++) {
    const p = start + x;
    const q = p + shift;
    const d0 = a[p]! - a[q]!;
    const d1 = b[p]! - b[q]!;
    const d2 = c[p]! - c[q]!;
    const squared = d0 * d0 + d1 * d1 + d2 * d2;
    const vp = variance[p]!;
    const vq = variance[q]!;
    const least = vp < vq ? vp : vq;
    const unit = 1 / (LEAST_VARIANCE + scale * (vp + vq));
    own[x] = (squared - vp - least) * unit;
    other[x] = (squared - vq - least) * unit;
  }
}

/** Sums over a patch's width. */
function sumAlong(values: Float32Array, out: Float32Array, left: number, right: number): void {
  for (let x = left; x < right; x++) {
    let sum = values[x]!;
    for (let i = 1; i <= PATCH; i++) {
      if (x - i >= left) sum += values[x - i]!;
      if (x + i < right) sum += values[x + i]!;
    }
    out[x] = sum;
  }
}

function shareRow(
  { channels, variance }: Planes,
  features: Features,
  start: number,
  left: number,
  right: number,
  shift: number,
  tall: number,
  rows: Rows,
  sums: Sums,
): void {
  const [a, b, c] = channels as [Float32Array, Float32Array, Float32Array];
  const [sumA, sumB, sumC] = sums.channels as [Float32Array, Float32Array, Float32Array];
  const [own0, own1, own2] = rows.own as [Float32Array, Float32Array, Float32Array];
  const [other0, other1, other2] = rows.other as [Float32Array, Float32Array, Float32Array];
  const { weight, variance: sumV } = sums;
  for (let x = left; x < right; x++) {
    const p = start + x;
    const q = p + shift;
    const wide = (x - left < PATCH ? x - left : PATCH) + (right - 1 - x < PATCH ? right - 1 - x : PATCH) + 1;
    const area = 1 / (wide * tall);
    const dp = (own0[x]! + own1[x]! + own2[x]!) * area;
    const dq = (other0[x]! + other1[x]! + other2[x]!) * area;
    if (dp >= FARTHEST && dq >= FARTHEST) continue;
    const apart = featureDistance(features, p, q);
    if (apart >= FARTHEST) continue;
    const wp = falloff(dp > apart ? dp : apart);
    const wq = falloff(dq > apart ? dq : apart);
    weight[p]! += wp;
    weight[q]! += wq;
    sumA[p]! += wp * a[q]!;
    sumB[p]! += wp * b[q]!;
    sumC[p]! += wp * c[q]!;
    sumA[q]! += wq * a[p]!;
    sumB[q]! += wq * b[p]!;
    sumC[q]! += wq * c[p]!;
    sumV[p]! += wp * wp * variance[q]!;
    sumV[q]! += wq * wq * variance[p]!;
  }
}

/** (1 - d / 8)^8, about exp(-d), of d >= 0. */
export function falloff(distance: number): number {
  const base = 1 - distance / FARTHEST;
  if (base <= 0) return 0;
  if (base >= 1) return 1;
  const squared = base * base;
  const fourth = squared * squared;
  return fourth * fourth;
}
