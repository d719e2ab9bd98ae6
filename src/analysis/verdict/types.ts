import type { ParameterValues, Rgb } from '../../brdf/model.ts';
import type { Vec3 } from '../vector.ts';

/** A law that a model is held to, in the order of the report. */
export const PROPERTIES = [
  'finiteness',
  'positivity',
  'reciprocity',
  'energy',
  'furnace',
  'distribution',
  'weak furnace',
  'lobes',
  'continuity',
  'density',
  'sampler',
  'gpu',
] as const;
export type Property = (typeof PROPERTIES)[number];

/**
 * `given up`: broken, and the model's header says so. `not applicable`: the model has nothing that the law
 * speaks of.
 */
export type Outcome = 'pass' | 'fail' | 'given up' | 'not applicable';

/** Where a law was broken most, or came closest to it: what to put into the scene to see it. */
export interface WorstCase {
  readonly term: string;
  readonly parameters: ParameterValues;
  /** To the light and to the viewer; the normal is +z, the tangent +x. null where the law has none. */
  readonly l: Vec3 | null;
  readonly v: Vec3 | null;
}

export interface Check {
  readonly property: Property;
  readonly outcome: Outcome;
  /** What was measured; null if nothing was, or if it is not finite. */
  readonly figure: number | null;
  /** The figure as a person reads it, with its unit. */
  readonly figureText: string;
  /** One plain sentence or two: what it means. */
  readonly sentence: string;
  readonly worst: WorstCase | null;
}

export interface Verdict {
  readonly model: string;
  readonly checks: readonly Check[];
  /** No law is broken but those that the header gives up. */
  readonly sound: boolean;
}

/** A place at which a model is evaluated. */
export interface Point {
  readonly parameters: ParameterValues;
  readonly l: Vec3;
  readonly v: Vec3;
}

/** Values of a term of the model on a GPU, one for each point. */
export type GpuEvaluation = (term: string, points: readonly Point[]) => Promise<readonly Rgb[]>;

export interface VerdictOptions {
  /** The same seed finds the same cases, on every machine. */
  readonly seed?: number;
  /** How much is looked at: 1 is what the command line does; half of it takes about half as long. */
  readonly effort?: number;
  readonly signal?: AbortSignal;
  /** Called now and then with the share that is done, 0 to 1, and the law at hand. */
  readonly onProgress?: (done: number, property: Property) => void;
  /** Without it, GPU and float64 are not compared. It may reject with a GpuFailure. */
  readonly gpu?: GpuEvaluation;
}
