/** What the page asks the verdict's worker for, and what comes back. */
import type { Property, Verdict } from '../../../analysis/verdict/types.ts';
import type { Subject } from './series.ts';

export type VerdictJob = Pick<Subject, 'model' | 'source'>;

export type VerdictAnswer =
  | { readonly kind: 'progress'; readonly done: number; readonly property: Property }
  | { readonly kind: 'verdict'; readonly verdict: Verdict }
  | { readonly kind: 'error'; readonly message: string };
