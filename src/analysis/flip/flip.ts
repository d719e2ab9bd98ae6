/**
 * FLIP: how different a person finds two pictures when flipping between them, for each pixel 0 to 1.
 *
 * P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, 2020, "FLIP: A Difference
 * Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3 (2), for pictures as a screen shows
 * them (LDR-FLIP).
 */

import { inverse, type Triple, transform } from '../../color/matrix.ts';
import { WHITE_XYZ, XYZ_TO_RGB } from '../../color/rec709.ts';
import { srgbToLinear } from '../../color/srgb.ts';
import { convolve, featureFilters, type Plane, sensitivityFilters } from './filters.ts';

/** A screen of 3840 pixels and 0.7 m width seen from 0.7 m: the paper's default. */
export const PIXELS_PER_DEGREE = (0.7 * 3840) / 0.7 / (180 / Math.PI);

/** Section 4.1.3: exponent of the colour difference, and the knee of its map to 0..1. */
const COLOR_EXPONENT = 0.7;
const [KNEE_AT, KNEE_TO] = [0.4, 0.95];
/** Section 4.2.2. */
const FEATURE_EXPONENT = 0.5;

/** A picture of 8-bit sRGB, RGBA without regard to A. */
export interface ScreenImage {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array | Uint8ClampedArray;
}

export interface FlipMap extends Plane {
  readonly mean: number;
}

export function flip(
  reference: ScreenImage,
  test: ScreenImage,
  pixelsPerDegree = PIXELS_PER_DEGREE,
): FlipMap {
  const { width, height } = reference;
  if (test.width !== width || test.height !== height)
    throw new RangeError(
      `${test.width} x ${test.height} pixels cannot be compared with ${width} x ${height}`,
    );
  const [a, b] = [opponentPlanes(reference), opponentPlanes(test)];
  const color = colorDifference(a, b, pixelsPerDegree);
  const feature = featureDifference(a[0], b[0], pixelsPerDegree);
  // Eq. 6 of the paper's section 4.3.
  const values = color.map((difference, i) => difference ** (1 - feature[i]!));
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return { width, height, values, mean };
}

const LINEAR = Float32Array.from({ length: 256 }, (_, byte) => srgbToLinear(byte / 255));

const RGB_TO_XYZ = inverse(XYZ_TO_RGB);
const RELATIVE = RGB_TO_XYZ.map((row, i) =>
  row.map((x) => x / WHITE_XYZ[i]!),
) as unknown as typeof RGB_TO_XYZ;
const FROM_RELATIVE = inverse(RELATIVE);

/** The channels of YCxCz, in which the paper filters: opponent colours that are linear in the light. */
type Planes = readonly [y: Plane, cx: Plane, cz: Plane];

function opponentPlanes({ width, height, pixels }: ScreenImage): Planes {
  const plane = (): Plane => ({ width, height, values: new Float32Array(width * height) });
  const planes = [plane(), plane(), plane()] as const;
  const [y, cx, cz] = planes;
  for (let i = 0; i < width * height; i++) {
    const rgb: Triple = [LINEAR[pixels[4 * i]!]!, LINEAR[pixels[4 * i + 1]!]!, LINEAR[pixels[4 * i + 2]!]!];
    const [xn, yn, zn] = transform(RELATIVE, rgb);
    y.values[i] = 116 * yn - 16;
    cx.values[i] = 500 * (xn - yn);
    cz.values[i] = 200 * (yn - zn);
  }
  return planes;
}

function colorDifference(a: Planes, b: Planes, pixelsPerDegree: number): Float32Array {
  const filters = sensitivityFilters(pixelsPerDegree);
  const seen = (planes: Planes) =>
    planes.map((plane, channel) => {
      const out = new Float32Array(plane.values.length);
      for (const { weight, kernel } of filters[channel]!) {
        const { values } = convolve(plane, kernel, kernel);
        for (let i = 0; i < out.length; i++) out[i]! += weight * values[i]!;
      }
      return out;
    });
  const [seenA, seenB] = [seen(a), seen(b)];
  const at = ([y, cx, cz]: Float32Array[], i: number) => perceived([y![i]!, cx![i]!, cz![i]!]);
  return new Float32Array(seenA[0]!.length).map((_, i) => remapped(hyab(at(seenA, i), at(seenB, i))));
}

/** L*a*b* of a colour of YCxCz that a screen could show, with chroma by lightness (Hunt effect): eq. 2. */
function perceived([y, cx, cz]: Triple): Triple {
  const yn = (y + 16) / 116;
  const rgb = transform(FROM_RELATIVE, [yn + cx / 500, yn, yn - cz / 200]);
  return huntLab(rgb.map((value) => Math.min(1, Math.max(0, value))) as unknown as Triple);
}

function huntLab(rgb: Triple): Triple {
  const [x, y, z] = transform(RELATIVE, rgb);
  const [fx, fy, fz] = [labCurve(x), labCurve(y), labCurve(z)];
  const lightness = 116 * fy - 16;
  return [lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)];
}

/** CIE 15:2018, eq. 8.6 ff. */
function labCurve(t: number): number {
  const delta = 6 / 29;
  return t > delta ** 3 ? Math.cbrt(t) : t / (3 * delta * delta) + 4 / 29;
}

/** S. Abasi, M. Amani Tehran and M. D. Fairchild, 2020: city block in lightness, Euclidean in chroma. */
function hyab(a: Triple, b: Triple): number {
  return Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);
}

/** Green against blue is the largest difference that a screen can show. */
const LARGEST = hyab(huntLab([0, 1, 0]), huntLab([0, 0, 1])) ** COLOR_EXPONENT;

/** 0 to 1: nearly all of the range is for differences below a part of the largest: section 4.1.3. */
function remapped(difference: number): number {
  const powered = difference ** COLOR_EXPONENT;
  const knee = KNEE_AT * LARGEST;
  if (powered < knee) return (KNEE_TO / knee) * powered;
  return KNEE_TO + ((powered - knee) / (LARGEST - knee)) * (1 - KNEE_TO);
}

/** Edges and points of the achromatic channel that only one picture has: section 4.2. */
function featureDifference(a: Plane, b: Plane, pixelsPerDegree: number): Float32Array {
  const { gaussian, edge, point } = featureFilters(pixelsPerDegree);
  const strength = (plane: Plane, kernel: Float32Array) => {
    const x = convolve(plane, kernel, gaussian).values;
    const y = convolve(plane, gaussian, kernel).values;
    return x.map((value, i) => Math.hypot(value, y[i]!));
  };
  const scaled = (plane: Plane): Plane => ({ ...plane, values: plane.values.map((y) => (y + 16) / 116) });
  const [na, nb] = [scaled(a), scaled(b)];
  const [edgesA, edgesB] = [strength(na, edge), strength(nb, edge)];
  const [pointsA, pointsB] = [strength(na, point), strength(nb, point)];
  return edgesA.map((value, i) => {
    const more = Math.max(Math.abs(value - edgesB[i]!), Math.abs(pointsA[i]! - pointsB[i]!));
    return (more / Math.SQRT2) ** FEATURE_EXPONENT;
  });
}
