import { type ChiSquaredResult, chiSquaredTest } from './chi-squared.ts';
import { integrateRectangle } from './quadrature.ts';
import { direction, type Vec3 } from './vector.ts';

/**
 * Does a sampler of directions give what its density says?
 *
 * The hemisphere about +z, or the sphere, is cut into cells of equal solid angle; the counts of samples in them are compared
 * with the integrals of the density over them. What the density lacks to 1 is the expected share of lost
 * samples (those below the surface), which is a cell of its own.
 */

export interface Sampler {
  /** A direction for two numbers in 0..1, or null where the sample is lost. */
  readonly sample: (u: readonly [number, number]) => Vec3 | null;
  /** The density of that, in 1/sr. */
  readonly pdf: (l: Vec3) => number;
}

export interface SamplerTestOptions {
  readonly samples: number;
  readonly random: () => number;
  /** Whether directions below the surface count, too: light may pass through it. */
  readonly sphere?: boolean;
  /** Cells in cos(theta) and in azimuth. */
  readonly cells?: readonly [number, number];
  /** Directions near which the density may be large. */
  readonly focus?: readonly Vec3[];
  /** Evaluations of the density after which the integral over one cell is left as it is. */
  readonly maxEvaluations?: number;
}

export interface SamplerTestResult extends ChiSquaredResult {
  /** The density's integral over all directions: at most 1. */
  readonly mass: number;
  /** Estimated absolute error of the expected shares, added up; where it is large, the test says nothing. */
  readonly error: number;
}

export function testSampler(sampler: Sampler, options: SamplerTestOptions): SamplerTestResult {
  const [rows, columns] = options.cells ?? [12, 24];
  const bottom = options.sphere ? -1 : 0;
  const height = (1 - bottom) / rows;
  const width = (2 * Math.PI) / columns;

  const focus = (options.focus ?? []).map(([x, y, z]) => [z, azimuth(x, y)] as const);
  const shares: number[] = [];
  let error = 0;
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const cell = { x: bottom + row * height, y: column * width, width: height, height: width };
      const density = (cosTheta: number, phi: number) => [sampler.pdf(direction(cosTheta, phi))];
      const integral = integrateRectangle(density, cell, {
        // A tenth of the deviation that a cell's count has by chance.
        tolerance: 0.1 / (rows * columns) / Math.sqrt(options.samples),
        maxEvaluations: options.maxEvaluations ?? 20_000,
        focus: focus.filter(
          ([z, phi]) => Math.floor((z - bottom) / height) === row && Math.floor(phi / width) === column,
        ),
      });
      shares.push(integral.value[0]!);
      error += integral.error;
    }
  }
  const mass = shares.reduce((sum, share) => sum + share, 0);

  const counts = new Array<number>(rows * columns + 1).fill(0);
  for (let i = 0; i < options.samples; i++) {
    const l = sampler.sample([options.random(), options.random()]);
    if (l && l[2] < bottom) throw new RangeError(`the sampler gave ${l}, which is below the surface`);
    const cell = l
      ? Math.min(rows - 1, Math.floor((l[2] - bottom) / height)) * columns +
        Math.min(columns - 1, Math.floor(azimuth(l[0], l[1]) / width))
      : rows * columns;
    counts[cell]!++;
  }
  const expected = [...shares, Math.max(0, 1 - mass)].map((share) => share * options.samples);
  return { ...chiSquaredTest(counts, expected), mass, error };
}

/** The azimuth in 0..2 pi. */
function azimuth(x: number, y: number): number {
  const phi = Math.atan2(y, x);
  return phi < 0 ? phi + 2 * Math.PI : phi;
}
