/** The filters of FLIP, all of them separable: sums of products of a filter along x and one along y. */

export interface Plane {
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

/** An odd number of weights, the middle one for the pixel itself. */
export type Kernel = Float32Array;

/** Beyond the border the nearest pixel is repeated. */
export function convolve({ width, height, values }: Plane, alongX: Kernel, alongY: Kernel): Plane {
  return { width, height, values: columns(rows(values, width, height, alongX), width, height, alongY) };
}

function rows(values: Float32Array, width: number, height: number, kernel: Kernel): Float32Array {
  const radius = (kernel.length - 1) / 2;
  const out = new Float32Array(values.length);
  const padded = new Float32Array(width + 2 * radius);
  for (let at = 0; at < width * height; at += width) {
    padded.fill(values[at]!, 0, radius);
    padded.set(values.subarray(at, at + width), radius);
    padded.fill(values[at + width - 1]!, radius + width);
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let k = 0; k < kernel.length; k++) sum += kernel[k]! * padded[x + k]!;
      out[at + x] = sum;
    }
  }
  return out;
}

function columns(values: Float32Array, width: number, height: number, kernel: Kernel): Float32Array {
  const radius = (kernel.length - 1) / 2;
  const out = new Float32Array(values.length);
  for (let y = 0; y < height; y++) {
    for (let k = 0; k < kernel.length; k++) {
      const from = width * Math.min(height - 1, Math.max(0, y + k - radius));
      const weight = kernel[k]!;
      for (let x = 0; x < width; x++) out[y * width + x]! += weight * values[from + x]!;
    }
  }
  return out;
}

const sampled = (radius: number, f: (x: number) => number): Kernel =>
  Float32Array.from({ length: 2 * radius + 1 }, (_, i) => f(i - radius));

const sum = (values: Iterable<number>): number => [...values].reduce((a, b) => a + b, 0);

function scaledToOne(kernel: Kernel): Kernel {
  const total = sum(kernel);
  return kernel.map((weight) => weight / total);
}

/** Positive weights add up to 1, negative ones to -1. */
function balanced(kernel: Kernel): Kernel {
  const positive = sum(kernel.filter((weight) => weight > 0));
  const negative = -sum(kernel.filter((weight) => weight < 0));
  return kernel.map((weight) => weight / (weight > 0 ? positive : negative));
}

/** a sqrt(pi / b) exp(-pi^2 x^2 / b) for a distance of x degrees. */
type Gaussian = readonly [a: number, b: number];

/**
 * The contrast sensitivity of each channel of YCxCz as sums of Gaussians in degrees: Andersson et al., 2020, table 1,
 * after G. M. Johnson and M. D. Fairchild, 2003.
 */
const SENSITIVITY: readonly (readonly Gaussian[])[] = [
  [[1, 0.0047]],
  [[1, 0.0053]],
  [
    [34.1, 0.04],
    [13.5, 0.025],
  ],
];
const WIDEST = Math.max(...SENSITIVITY.flat().map(([, b]) => b));

export interface Term {
  readonly weight: number;
  /** Along x and along y. */
  readonly kernel: Kernel;
}

/** For each channel of YCxCz what an eye at this distance smooths over; the weights of a channel add up to 1. */
export function sensitivityFilters(pixelsPerDegree: number): readonly (readonly Term[])[] {
  // Three standard deviations of the widest.
  const radius = Math.ceil(3 * Math.sqrt(WIDEST / (2 * Math.PI ** 2)) * pixelsPerDegree);
  return SENSITIVITY.map((gaussians) => {
    const terms = gaussians.map(([a, b]) => {
      const kernel = sampled(radius, (x) => Math.exp(-((Math.PI * x) ** 2) / (b * pixelsPerDegree ** 2)));
      return { weight: a * Math.sqrt(Math.PI / b) * sum(kernel) ** 2, kernel: scaledToOne(kernel) };
    });
    const total = sum(terms.map(({ weight }) => weight));
    return terms.map(({ weight, kernel }) => ({ weight: weight / total, kernel }));
  });
}

/** Width of an edge that is seen best, in degrees: Andersson et al., 2020, section 4.2.1. */
const FEATURE_WIDTH = 0.082;

/** First and second derivative of a Gaussian, which answer to edges and points, and the Gaussian across them. */
export function featureFilters(pixelsPerDegree: number): { gaussian: Kernel; edge: Kernel; point: Kernel } {
  const deviation = 0.5 * FEATURE_WIDTH * pixelsPerDegree;
  const radius = Math.ceil(3 * deviation);
  const gaussian = sampled(radius, (x) => Math.exp((-x * x) / (2 * deviation ** 2)));
  return {
    gaussian: scaledToOne(gaussian),
    edge: balanced(gaussian.map((g, i) => -(i - radius) * g)),
    point: balanced(gaussian.map((g, i) => (((i - radius) / deviation) ** 2 - 1) * g)),
  };
}
