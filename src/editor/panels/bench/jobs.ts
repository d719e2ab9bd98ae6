/** What the page asks the bench's workers for, and what comes back. */
import type { Sweep } from '../../../analysis/plots/albedo-sweep.ts';
import type { AzimuthOptions } from '../../../analysis/plots/azimuth-slice.ts';
import type { Curve } from '../../../analysis/plots/curve.ts';
import type { ImageSliceOptions } from '../../../analysis/plots/image-slice.ts';
import type { LightSliceOptions } from '../../../analysis/plots/light-slice.ts';
import type { LitOptions } from '../../../analysis/plots/lit-picture.ts';
import type { Lobe } from '../../../analysis/plots/lobe.ts';
import type { Picture } from '../../../analysis/plots/picture.ts';
import type { TriangleMesh } from '../../../analysis/plots/surface.ts';
import type { OwnModel } from './settings.ts';

export type Task =
  | { readonly kind: 'albedo'; readonly phiV: number }
  | {
      readonly kind: 'sweep';
      readonly parameter: string;
      readonly min: number;
      readonly max: number;
      readonly phiV: number;
    }
  | { readonly kind: 'image'; readonly options: ImageSliceOptions }
  | { readonly kind: 'map'; readonly options: AzimuthOptions }
  | { readonly kind: 'lobe'; readonly options: LightSliceOptions }
  | { readonly kind: 'sphere'; readonly options: LitOptions }
  | { readonly kind: 'object'; readonly mesh: number; readonly options: LitOptions };

export interface Job {
  /** A later job with the same key takes the place of this one. */
  readonly key: string;
  readonly ticket: number;
  readonly model: string;
  /** The number of the source that the model comes from; null where it ships. */
  readonly source: number | null;
  readonly parameters: Readonly<Record<string, unknown>>;
  readonly term: string;
  readonly task: Task;
}

/** A shape to light, sent once; jobs name it by its number. */
export interface Shape {
  readonly mesh: number;
  readonly triangles: TriangleMesh;
}

/** A scene's own model, sent once, for measurements are megabytes; jobs name it by its number. null forgets it. */
export interface Source {
  readonly source: number;
  readonly own: OwnModel | null;
}

/** What a task gives is in the field of its kind of data; the others are absent. */
export interface Result {
  readonly curve?: Curve;
  readonly sweep?: Sweep;
  readonly lobe?: Lobe;
  readonly picture?: Picture;
  /** 0 to 1. */
  readonly progress: number;
  /** What went wrong; the rest is then absent. */
  readonly error?: string;
}

export interface Answer {
  readonly key: string;
  readonly ticket: number;
  readonly result: Result;
}
