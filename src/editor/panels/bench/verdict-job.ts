/** What the page and the verdict's worker tell each other. */
import type { Point, Property, Verdict } from '../../../analysis/verdict/types.ts';
import type { Rgb } from '../../../brdf/model.ts';
import type { Subject } from './series.ts';

export type VerdictJob = Pick<Subject, 'model' | 'source'>;

/** A term's values, which only the page can ask the GPU for. */
export interface GpuQuestion {
  readonly kind: 'gpu';
  readonly term: string;
  readonly points: readonly Point[];
}

/** The answer to the one question that is open; or why there is none. */
export type GpuReply = { readonly values: readonly Rgb[] } | { readonly failure: string };

export type VerdictRequest = VerdictJob | GpuReply;

export type VerdictAnswer =
  | { readonly kind: 'progress'; readonly done: number; readonly property: Property }
  | { readonly kind: 'verdict'; readonly verdict: Verdict }
  | { readonly kind: 'error'; readonly message: string }
  | GpuQuestion;
