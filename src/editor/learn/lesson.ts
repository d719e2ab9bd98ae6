/**
 * A lesson as its text says it (docs/lessons.md): steps, each with what is read and with how the scene, the
 * picture and the plots stand when the step begins. Made by parse.ts, held against its scene by prepare.ts.
 */
import type { Rendering } from '../state.ts';
import type { Place } from './error.ts';

export type Inline =
  | { readonly kind: 'text' | 'code' | 'formula'; readonly text: string }
  | { readonly kind: 'strong' | 'emphasis'; readonly children: readonly Inline[] };

export type Prose =
  | { readonly kind: 'paragraph'; readonly children: readonly Inline[] }
  | { readonly kind: 'list'; readonly ordered: boolean; readonly items: readonly (readonly Prose[])[] };

/** What a click on a term of a formula does, beside its sentence. */
export type Target =
  | { readonly kind: 'idea' }
  /** Shows a term of the lesson's material alone. */
  | { readonly kind: 'term'; readonly name: string }
  /** Offers a field of the scene. */
  | { readonly kind: 'field'; readonly path: string };

export interface Definition {
  readonly key: string;
  readonly target: Target;
  readonly text: readonly Inline[];
  readonly place: Place;
}

/** What is read in a step, in the order of the text. */
export type Block = { readonly place: Place } & (
  | Prose
  /** TeX, on a line of its own; `terms` are its \term{key}{...}: what each key's first one looks like. */
  | { readonly kind: 'formula'; readonly tex: string; readonly terms: ReadonlyMap<string, string> }
  | { readonly kind: 'field'; readonly path: string; readonly range: Range | null; readonly label: string }
  | { readonly kind: 'do' | 'see'; readonly text: readonly Inline[] }
  | { readonly kind: 'question'; readonly question: readonly Inline[]; readonly answer: readonly Inline[] }
);

export type Range = readonly [min: number, max: number];

type Vector = readonly [number, number, number];

/** How things stand when a step begins, beside the lesson's scene. */
export type Setting = { readonly place: Place } & (
  | { readonly kind: 'set'; readonly path: string; readonly value: unknown }
  | { readonly kind: 'without'; readonly entities: readonly string[] }
  | { readonly kind: 'look'; readonly from: Vector; readonly at: Vector | null }
  | { readonly kind: 'term'; readonly name: string; readonly material: string | null }
  | {
      readonly kind: 'plot';
      readonly view: string;
      readonly settings: Readonly<Record<string, string | number | boolean>>;
    }
  | { readonly kind: 'pin'; readonly name: string; readonly parameters: Readonly<Record<string, unknown>> }
  | { readonly kind: 'rendering'; readonly rendering: Rendering }
  | { readonly kind: 'select'; readonly entity: string }
);

export interface Step {
  readonly title: string;
  readonly place: Place;
  readonly blocks: readonly Block[];
  readonly settings: readonly Setting[];
}

export interface Lesson {
  readonly file: string;
  readonly title: string;
  readonly summary: string;
  /** Where it stands in a list of lessons. */
  readonly order: number;
  readonly minutes: number;
  /** The material that terms and plots are of; null: the scene's first. */
  readonly material: string | null;
  readonly definitions: ReadonlyMap<string, Definition>;
  readonly steps: readonly Step[];
}
