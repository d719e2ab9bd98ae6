/**
 * The editor's own state: what is selected, what is folded, which units are shown. Nothing here
 * belongs to the scene; the scene's only state is the document.
 */
import type { EntityKind, EntityRef } from '../scene/entity.ts';
import type { Document } from '../scene/schema.ts';
import type { Comparison } from './compare/comparison.ts';
import { type BenchSettings, initialSettings } from './panels/bench/settings.ts';

export type { EntityKind };
export type Entity = EntityRef;

/** What the viewport shows: one of the two renderings, both side by side, or how they differ. */
export const renderings = ['interactive', 'traced', 'split', 'difference'] as const;
export type Rendering = (typeof renderings)[number];

/** What a drag in the picture does: nothing but look around, a box around what is to be selected, or a gizmo's handle. */
export const tools = ['select', 'box', 'move', 'rotate', 'scale'] as const;
export type Tool = (typeof tools)[number];

/** What drags go in where they go in steps. */
export interface Steps {
  /** m */
  readonly move: number;
  /** Degrees. */
  readonly rotate: number;
  readonly scale: number;
}

/** Those that can be chosen. */
export const stepChoices: { readonly [K in keyof Steps]: readonly number[] } = {
  move: [0.01, 0.05, 0.1, 0.25, 0.5, 1],
  rotate: [1, 5, 10, 15, 30, 45],
  scale: [0.01, 0.05, 0.1, 0.25, 0.5, 1],
};

/** Null is the scene itself: camera, environment, view. */
export type Selection = Entity | null;

export interface EditorState {
  /** What was chosen last, whose fields the inspector shows; always the last of `selected`. */
  readonly selection: Selection;
  /** All that is selected. Set by the methods of the store alone. */
  readonly selected: readonly Entity[];
  /** Titles of the inspector's sections that are folded. */
  readonly folded: readonly string[];
  /** The unit in which a photometric field is shown, by `light type.field`. */
  readonly units: Readonly<Record<string, string>>;
  /** Render every animation frame, not only when something changed. */
  readonly continuous: boolean;
  readonly statusOpen: boolean;
  /** The GPU's times are measured and shown. */
  readonly gpuTimes: boolean;
  readonly benchOpen: boolean;
  /** The open bench fills the page. */
  readonly benchPage: boolean;
  /** CSS pixels. */
  readonly benchHeight: number;
  readonly bench: BenchSettings;
  /** The model of the scene whose source is being edited. */
  readonly source: string | null;
  readonly tool: Tool;
  /** Whose axes the gizmo has. */
  readonly space: 'world' | 'local';
  /** What several things turn and scale about: the middle of where they stand, or where the last one stands. */
  readonly pivot: 'middle' | 'last';
  /** Drags go in steps. */
  readonly snap: boolean;
  readonly steps: Steps;
  readonly rendering: Rendering;
  /** The part of the viewport's width left of the divider, which is interactive. */
  readonly divider: number;
  /** Two materials that are compared in the picture; null for none. */
  readonly comparison: Comparison | null;
  readonly tracingPaused: boolean;
  /** Whether the path traced picture is shown, compared and saved denoised. */
  readonly denoise: boolean;
}

const persistent = ['folded', 'units', 'statusOpen', 'benchOpen', 'benchHeight'] as const;

type Persistent = Pick<EditorState, (typeof persistent)[number]>;

const STORAGE_KEY = 'irradia.editor';

const initial: EditorState = {
  selection: null,
  selected: [],
  folded: ['Geometry', 'Maps', 'Emission and transparency', 'Near and far'],
  units: {},
  continuous: false,
  statusOpen: true,
  gpuTimes: false,
  benchOpen: false,
  benchPage: false,
  benchHeight: 348,
  bench: initialSettings,
  source: null,
  tool: 'move',
  space: 'world',
  pivot: 'middle',
  snap: false,
  steps: { move: 0.1, rotate: 15, scale: 0.1 },
  rendering: 'interactive',
  divider: 0.5,
  comparison: null,
  tracingPaused: false,
  denoise: false,
};

export class EditorStateStore {
  #state: EditorState = { ...initial, ...restore() };
  readonly #listeners = new Set<(state: EditorState, previous: EditorState) => void>();

  get value(): EditorState {
    return this.#state;
  }

  set(patch: Partial<EditorState>): void {
    const previous = this.#state;
    this.#state = { ...previous, ...patch };
    if (persistent.some((name) => patch[name] !== undefined)) this.#persist();
    for (const listener of [...this.#listeners]) listener(this.#state, previous);
  }

  /** Selects this alone; null is the scene. */
  select(selection: Selection): void {
    this.selectAll(selection ? [selection] : []);
  }

  /** Selects these, the last of them as the one whose fields are shown. */
  selectAll(entities: readonly Entity[]): void {
    const { selected } = this.#state;
    const same = entities.length === selected.length && entities.every((e, i) => isSame(e, selected[i]));
    if (!same) this.set({ selected: entities, selection: entities.at(-1) ?? null });
  }

  /** Adds to what is selected, or takes away from it. */
  toggleSelected(entity: Entity): void {
    const others = this.#state.selected.filter((other) => !isSame(other, entity));
    this.selectAll(this.isSelected(entity) ? others : [...others, entity]);
  }

  isSelected(entity: Entity): boolean {
    return this.#state.selected.some((other) => isSame(other, entity));
  }

  fold(title: string, folded: boolean): void {
    const others = this.#state.folded.filter((other) => other !== title);
    this.set({ folded: folded ? [...others, title] : others });
  }

  /** What was selected may be gone after an undo or a new document. */
  forget(document: Document): void {
    this.selectAll(this.#state.selected.filter(({ kind, id }) => id in document[kind]));
  }

  subscribe(listener: (state: EditorState, previous: EditorState) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #persist(): void {
    const { folded, units, statusOpen, benchOpen, benchHeight } = this.#state;
    const kept: Persistent = { folded, units, statusOpen, benchOpen, benchHeight };
    try {
      localStorage.setItem(STORAGE_KEY, JSON.stringify(kept));
    } catch {
      // Storage may be forbidden or full; the page then forgets its layout, nothing else.
    }
  }
}

const isSame = (a: Entity, b: Entity | undefined): boolean => a.kind === b?.kind && a.id === b.id;

/** What an older or a tampered page left in storage is taken only where it has the right shape. */
function restore(): Partial<Persistent> {
  try {
    const stored: unknown = JSON.parse(localStorage.getItem(STORAGE_KEY) ?? '{}');
    if (typeof stored !== 'object' || stored === null) return {};
    const { folded, units, statusOpen, benchOpen, benchHeight } = stored as Record<string, unknown>;
    const isText = (value: unknown): value is string => typeof value === 'string';
    return {
      ...(Array.isArray(folded) && { folded: folded.filter(isText) }),
      ...(typeof units === 'object' &&
        units !== null && {
          units: Object.fromEntries(
            Object.entries(units).filter((entry): entry is [string, string] => isText(entry[1])),
          ),
        }),
      ...(typeof statusOpen === 'boolean' && { statusOpen }),
      ...(typeof benchOpen === 'boolean' && { benchOpen }),
      ...(typeof benchHeight === 'number' && { benchHeight }),
    };
  } catch {
    return {};
  }
}
