/** What the page asks the heat map's worker for, and what comes back. */
import type { HeatMap, MappedProperty } from '../../../analysis/verdict/heat-map.ts';
import type { VerdictJob } from './verdict-job.ts';

export interface HeatMapJob extends VerdictJob {
  readonly property: MappedProperty;
  /** null lets the model's figures choose. */
  readonly axes: readonly [string, string] | null;
}

export type HeatMapAnswer =
  | { readonly kind: 'progress'; readonly done: number }
  | { readonly kind: 'map'; readonly map: HeatMap }
  | { readonly kind: 'error'; readonly message: string };
