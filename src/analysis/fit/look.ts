/** A lit sphere, computed without a renderer: how a BRDF looks, to compare by and to show. */
import type { Rgb } from '../../brdf/model.ts';
import type { Triple } from '../../color/matrix.ts';
import { oklab } from '../../color/oklab.ts';
import { linearToSrgb } from '../../color/srgb.ts';
import type { Vec3 } from '../vector.ts';
import { meanSquare } from './metrics.ts';
import type { Pair } from './samples.ts';

export interface Look {
  /** Pixels along each side of the square that holds the sphere. */
  readonly size: number;
  /** What the picture needs f (n.l) at. */
  readonly pairs: readonly Pair[];
  /** The picture's radiance from those values: RGB triples of the sphere's pixels. */
  shade(values: Float64Array): Float64Array;
  /** Where in the square each of those pixels is: row times size plus column, from the top left. */
  readonly places: readonly number[];
}

/**
 * How far apart directions to the light are, in radians: 1.2 standard deviations of the smallest soft light, so
 * that the sum over them is as smooth as the light itself.
 */
const SPACING = 0.32;
/** Up to here half vectors are in rings evenly spread over the logarithm of theta_h, for lobes of any width. */
const MIDDLE = 0.1;
const INNERMOST = 5e-5;
const INNER_RINGS = 8;

interface Ring {
  readonly theta: number;
  readonly spokes: number;
  /** The solid angle of half vectors that each spoke stands for. */
  readonly solidAngle: number;
}

/** Half vectors about the normal. */
const RINGS: readonly Ring[] = (() => {
  const span = Math.log(MIDDLE / INNERMOST) / INNER_RINGS;
  const inner = Array.from({ length: INNER_RINGS }, (_, i) => {
    const theta = INNERMOST * Math.exp(span * (i + 0.5));
    return { theta, width: theta * span };
  });
  // A direction that is reflected at h turns twice as far as h.
  const count = Math.ceil((2 * (Math.PI / 2 - MIDDLE)) / SPACING);
  const width = (Math.PI / 2 - MIDDLE) / count;
  const outer = Array.from({ length: count }, (_, i) => ({ theta: MIDDLE + width * (i + 0.5), width }));
  return [...inner, ...outer].map(({ theta, width }) => {
    const round = 2 * Math.PI * Math.sin(Math.min(2 * theta, Math.PI / 2));
    const spokes = Math.max(6, Math.ceil(round / SPACING));
    return { theta, spokes, solidAngle: (Math.sin(theta) * width * 2 * Math.PI) / spokes };
  });
})();

/** A sphere seen from far along -z, +y up, in a room with a warm soft light, a cool one behind, sky and floor. */
export function createLook(size: number): Look {
  const pairs: Pair[] = [];
  const weights: Rgb[] = [];
  const places: number[] = [];
  /** Where each pixel's pairs begin, and the end of the last. */
  const starts: number[] = [];
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const x = (2 * column + 1) / size - 1;
      const y = 1 - (2 * row + 1) / size;
      const z = Math.sqrt(1 - x * x - y * y);
      // The outermost rim is seen below half a degree above the horizon, where no formula is at its best.
      if (!(z > 0.01)) continue;
      places.push(row * size + column);
      starts.push(pairs.length);
      for (const { pair, weight } of pixelPairs([x, y, z])) {
        pairs.push(pair);
        weights.push(weight);
      }
    }
  }
  starts.push(pairs.length);
  const shade = (values: Float64Array) => {
    const radiance = new Float64Array(3 * places.length);
    for (const pixel of places.keys()) {
      for (let i = starts[pixel] as number; i < (starts[pixel + 1] as number); i++) {
        for (let c = 0; c < 3; c++)
          radiance[3 * pixel + c]! += (values[3 * i + c] as number) * ((weights[i] as Rgb)[c] as number);
      }
    }
    return radiance;
  };
  return { size, pairs, shade, places };
}

function* pixelPairs(n: Vec3): Generator<{ pair: Pair; weight: Rgb }> {
  // The sphere's own tangent runs around it, as its texture coordinates do.
  const flat = Math.hypot(n[0], n[2]);
  const X: Vec3 = [n[2] / flat, 0, -n[0] / flat];
  const Y: Vec3 = [n[1] * X[2] - n[2] * X[1], n[2] * X[0] - n[0] * X[2], n[0] * X[1] - n[1] * X[0]];
  const v: Vec3 = [X[2], Y[2], n[2]];
  for (const [ring, { theta, spokes, solidAngle }] of RINGS.entries()) {
    const [sine, cosine] = [Math.sin(theta), Math.cos(theta)];
    for (let spoke = 0; spoke < spokes; spoke++) {
      const phi = (2 * Math.PI * (spoke + (ring % 2) / 2)) / spokes;
      const h: Vec3 = [sine * Math.cos(phi), sine * Math.sin(phi), cosine];
      const vh = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
      const l: Vec3 = [2 * vh * h[0] - v[0], 2 * vh * h[1] - v[1], 2 * vh * h[2] - v[2]];
      if (vh <= 0 || l[2] <= 1e-3) continue;
      const world: Vec3 = [
        l[0] * X[0] + l[1] * Y[0] + l[2] * n[0],
        l[0] * X[1] + l[1] * Y[1] + l[2] * n[1],
        l[0] * X[2] + l[1] * Y[2] + l[2] * n[2],
      ];
      // Reflected at h, a solid angle about h becomes one about l that is 4 (v.h) times as large.
      const [r, g, b] = roomLight(world);
      const w = 4 * vh * solidAngle;
      yield { pair: { l, v }, weight: [w * r, w * g, w * b] };
    }
  }
}

interface SoftLight {
  readonly towards: Vec3;
  readonly radiance: Rgb;
  /** exp(sharpness (cos - 1)): 1/e at the angle acos(1 - 1/sharpness). */
  readonly sharpness: number;
}

/** Warm from the upper left, cool from behind on the right, to bring out the rim. */
const SOFT_LIGHTS: readonly SoftLight[] = [
  { towards: unit([-0.55, 0.65, 0.55]), radiance: [6, 5.4, 4.6], sharpness: 14 },
  { towards: unit([0.85, 0.25, -0.45]), radiance: [1.8, 2.4, 3.3], sharpness: 14 },
];
const SKY: Rgb = [0.4, 0.48, 0.6];
const FLOOR: Rgb = [0.14, 0.12, 0.1];

/** The room's radiance; in its units a white matte sphere is about .9 where it is brightest. */
function roomLight(l: Vec3): Rgb {
  const t = 0.5 + 0.5 * Math.max(-1, Math.min(1, 2.5 * l[1]));
  const smooth = t * t * (3 - 2 * t);
  const sum = [0, 1, 2].map((c) => FLOOR[c]! + (SKY[c]! - FLOOR[c]!) * smooth) as [number, number, number];
  for (const { towards, radiance, sharpness } of SOFT_LIGHTS) {
    const cosine = l[0] * towards[0] + l[1] * towards[1] + l[2] * towards[2];
    const strength = Math.exp(sharpness * (cosine - 1));
    for (let c = 0; c < 3; c++) sum[c]! += strength * radiance[c]!;
  }
  return sum;
}

function unit([x, y, z]: Vec3): Vec3 {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

/**
 * Radiance as a display shows it, 0 to 1 and linear: x/(1 + x), which takes highlights to white (E. Reinhard et
 * al., 2002, "Photographic Tone Reproduction for Digital Images", equation 3), brightened so that 1 becomes .64.
 */
export function displayed(radiance: number): number {
  const x = 1.8 * Math.max(0, radiance);
  return x / (1 + x);
}

/**
 * How two pictures of the same look differ: their pixels' differences in Oklab (B. Ottosson, 2020), times 100, so
 * that black and white are 100 apart. A difference of 1 or 2 in a whole area is about what can just be seen.
 */
export function lookDifferences(a: Float64Array, b: Float64Array): Float64Array {
  const differences = new Float64Array(a.length);
  for (let i = 0; i < a.length; i += 3) {
    const [p, q] = [seen(a, i), seen(b, i)];
    for (let c = 0; c < 3; c++) differences[i + c] = 100 * ((p[c] as number) - (q[c] as number));
  }
  return differences;
}

/** The root mean square, over the sphere, of the pixels' distances. */
export function distance(differences: Float64Array): number {
  return Math.sqrt(3 * meanSquare(differences));
}

function seen(pixels: Float64Array, at: number): Triple {
  const [r, g, b] = [0, 1, 2].map((c) => displayed(pixels[at + c] as number)) as [number, number, number];
  return oklab([r, g, b]);
}

/** A picture as a screen shows it: RGBA, sRGB, rows from the top, clear beside the sphere. */
export function lookPixels({ size, places }: Look, radiance: Float64Array): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * size * size);
  for (const [i, place] of places.entries()) {
    for (let c = 0; c < 3; c++)
      pixels[4 * place + c] = 255 * linearToSrgb(displayed(radiance[3 * i + c] as number));
    pixels[4 * place + 3] = 255;
  }
  return pixels;
}
