/** What says that two pixels show the same surface: normal, distance, albedo and coverage. */
import type { FilmPlanes, Planes } from './planes.ts';

/**
 * Of every pixel, together for the sake of the cache: normal (3), distance, albedo (3), coverage, and the tolerances of
 * these four, which are squares and are added up of two pixels.
 */
export type Features = Float32Array;

const STRIDE = 12;

/** Distances from which on pixels have nothing to do with each other. */
export const FARTHEST = 8;

/** The largest of the squared differences in units of their tolerances; FARTHEST or more where it does not matter. */
export function featureDistance(features: Features, p: number, q: number): number {
  const i = STRIDE * p;
  const j = STRIDE * q;
  const n0 = features[i]! - features[j]!;
  const n1 = features[i + 1]! - features[j + 1]!;
  const n2 = features[i + 2]! - features[j + 2]!;
  const normal = (n0 * n0 + n1 * n1 + n2 * n2) / (features[i + 8]! + features[j + 8]!);
  if (normal >= FARTHEST) return normal;
  const z = features[i + 3]! - features[j + 3]!;
  const depth = (z * z) / (features[i + 9]! + features[j + 9]!);
  if (depth >= FARTHEST) return depth;
  const a0 = features[i + 4]! - features[j + 4]!;
  const a1 = features[i + 5]! - features[j + 5]!;
  const a2 = features[i + 6]! - features[j + 6]!;
  const albedo = (a0 * a0 + a1 * a1 + a2 * a2) / (features[i + 10]! + features[j + 10]!);
  const c = features[i + 7]! - features[j + 7]!;
  const coverage = (c * c) / (features[i + 11]! + features[j + 11]!);
  return Math.max(normal, depth, albedo, coverage);
}

/** Tolerances: a tenth of a radian and of the hits, a hundredth of the distance; more where surfaces bend or lean. */
const NORMAL_TOLERANCE = 0.1 ** 2;
const DEPTH_TOLERANCE = 0.01 ** 2;
const COVERAGE_TOLERANCE = 0.1 ** 2;
/** Light is without the albedo's pattern: its edges are there only to keep materials apart. */
const ALBEDO_TOLERANCE = 0.005;
/** Of a distance in m^2: where nothing was hit, all are 0. */
const LEAST_TOLERANCE = 1e-12;

/** @param albedo null where it is what is to be filtered: it then makes no difference */
export function featuresOf(
  { normal, depth, alpha }: FilmPlanes,
  albedo: Planes | null,
  count: Float64Array,
): Features {
  const { width, height } = normal;
  const slopes = {
    normal: slope(normal.channels, width, height),
    depth: slope([depth], width, height),
    albedo: albedo && slope(albedo.channels, width, height),
  };
  const features = new Float32Array(STRIDE * width * height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const at = STRIDE * pixel;
    for (let c = 0; c < 3; c++) {
      features[at + c] = normal.channels[c]![pixel]!;
      features[at + 4 + c] = albedo?.channels[c]?.[pixel] ?? 0;
    }
    const [z, covered] = [depth[pixel]!, alpha[pixel]!];
    features[at + 3] = z;
    features[at + 7] = covered;
    features[at + 8] = NORMAL_TOLERANCE + slopes.normal[pixel]! + normal.variance[pixel]!;
    features[at + 9] = LEAST_TOLERANCE + DEPTH_TOLERANCE * z * z + slopes.depth[pixel]!;
    features[at + 10] =
      ALBEDO_TOLERANCE + 0.5 * (slopes.albedo?.[pixel] ?? 0) + (albedo?.variance[pixel] ?? 0);
    features[at + 11] = COVERAGE_TOLERANCE + (covered * (1 - covered)) / Math.max(1, count[pixel]! - 1);
  }
  return features;
}

/**
 * The squared length of the gradient per pixel, by the smaller of the differences to both sides: a plane that is seen
 * at an angle has one, an edge does not.
 */
function slope(channels: readonly Float32Array[], width: number, height: number): Float32Array {
  return new Float32Array(width * height).map((_, pixel) => {
    const x = pixel % width;
    const y = (pixel - x) / width;
    let sum = 0;
    for (const channel of channels) {
      const at = channel[pixel]!;
      const difference = (isInside: boolean, other: number) =>
        isInside ? Math.abs(channel[other]! - at) : Number.POSITIVE_INFINITY;
      const dx = Math.min(difference(x > 0, pixel - 1), difference(x + 1 < width, pixel + 1));
      const dy = Math.min(difference(y > 0, pixel - width), difference(y + 1 < height, pixel + width));
      sum += (Number.isFinite(dx) ? dx * dx : 0) + (Number.isFinite(dy) ? dy * dy : 0);
    }
    return sum;
  });
}
