/** What the page asks the worker of a fit for, and what comes back. */
import type { Fit } from '../../../analysis/fit/types.ts';
import type { Subject } from '../bench/series.ts';

export interface FitJob {
  readonly target: Pick<Subject, 'model' | 'source' | 'parameters'>;
  readonly model: Pick<Subject, 'model' | 'source'>;
}

/** Pixels along each side of the spheres. */
export const SPHERE_SIZE = 88;

export type FitAnswer =
  | { readonly kind: 'progress'; readonly done: number; readonly error: number }
  | {
      readonly kind: 'fit';
      readonly fit: Fit;
      /** Of the target and of the fit: RGBA, sRGB. */
      readonly spheres: readonly [Uint8ClampedArray<ArrayBuffer>, Uint8ClampedArray<ArrayBuffer>];
    }
  | { readonly kind: 'error'; readonly message: string };
