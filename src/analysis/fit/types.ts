import type { ParameterValues } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import type { Metric } from './metrics.ts';

/** What is to be reproduced: measured data, or a model with values for its parameters. */
export interface FitTarget {
  readonly model: Model;
  /** Those that are not named take their defaults. */
  readonly parameters?: Readonly<Record<string, unknown>>;
}

export interface FitOptions {
  /** The same seed gives the same fit; 1 if not given. */
  readonly seed?: number;
  /** Parameters that keep a value. */
  readonly fixed?: Readonly<Record<string, unknown>>;
  readonly signal?: AbortSignal;
  /** Called now and then with the share that is done, 0 to 1, and the smallest cube-root error so far. */
  readonly onProgress?: (done: number, error: number) => void;
}

export interface FitErrors {
  /** The root mean square difference of the cube roots of f (n.l), f in 1/sr: see metrics.ts. */
  readonly cubeRoot: number;
  /** The difference of lit spheres in Oklab, 0 to 100: see look.ts. */
  readonly look: number;
}

/** What a fit was made by: a metric of BRDFs; or the picture of a sphere and the cube root, with equal weight. */
export type Judge = Metric | 'look';

/** The best parameters under one metric. */
export interface Candidate extends FitErrors {
  readonly metric: Judge;
  readonly parameters: ParameterValues;
}

export interface FittedNumber {
  /** `roughness`, or `baseColor.r`. */
  readonly name: string;
  readonly value: number;
  /** How far the value can go, if the others follow, until the difference is visible: see determinacy.ts. */
  readonly play: number;
  /** Which end of its range the value stands at. */
  readonly bound: 'min' | 'max' | null;
}

export interface Fit {
  readonly model: string;
  readonly parameters: ParameterValues;
  readonly errors: FitErrors;
  /** The errors of the model's defaults (with what is fixed), to compare with. */
  readonly defaults: FitErrors;
  /** The root mean square of the target's own cube roots: what an error of 100 % is. */
  readonly size: number;
  /** The metric whose fit looks most like the target. */
  readonly metric: Judge;
  readonly candidates: readonly Candidate[];
  /** Every number that was fitted. */
  readonly numbers: readonly FittedNumber[];
  /** Names of which only a combination is determined; a name alone has no visible effect. */
  readonly loose: readonly (readonly string[])[];
}
