/** What the page asks the bench's worker for, and what comes back. */
import type { Curve } from '../../../analysis/plots/curve.ts';
import type { ImageSlice } from '../../../analysis/plots/image-slice.ts';
import type { Subject } from './series.ts';

export type Task =
  | { readonly kind: 'albedo'; readonly phiV: number }
  | { readonly kind: 'image'; readonly cosine: boolean };

export interface Job {
  /** A later job with the same key takes the place of this one. */
  readonly key: string;
  readonly ticket: number;
  readonly subject: Pick<Subject, 'model' | 'source' | 'parameters'>;
  readonly term: string;
  readonly task: Task;
}

export interface Result {
  readonly curve: Curve;
  readonly image: ImageSlice | null;
  /** 0 to 1. */
  readonly progress: number;
  /** What went wrong; the rest is then empty. */
  readonly error: string | null;
}

export interface Answer {
  readonly key: string;
  readonly ticket: number;
  readonly result: Result;
}
