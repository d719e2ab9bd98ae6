/**
 * The one holder of the document. Every change is an edit with a label that a person reads
 * in the undo menu. An edit that throws, or whose result would not be a valid document,
 * changes nothing.
 *
 * Undo keeps documents, not inverse patches: immer shares what did not change, so that a step
 * holds just what it changed, and unlike a patch it brings back the order of a collection too.
 */
import { freeze, produce } from 'immer';
import { DocumentError } from './error.ts';
import type { Document } from './schema.ts';
import { documentIssues } from './validate.ts';

/** The document as a recipe sees it: assign to its fields. */
export type Draft = Document;

/** A step that can be gone back to, or forward. */
export interface HistoryStep {
  readonly label: string;
}

export interface EditOptions {
  /** Edits in a row with the same key become one undo step: a slider being dragged. */
  merge?: string;
}

export interface StoreEvent {
  document: Document;
  previous: Document;
  label: string;
  reason: 'edit' | 'undo' | 'redo' | 'open';
}

interface Step {
  label: string;
  before: Document;
  after: Document;
  merge: string | undefined;
}

const maxSteps = 500;

export class DocumentStore {
  #document: Document;
  #done: Step[] = [];
  #undone: Step[] = [];
  /** What could be redone before the last step. */
  #forgotten: Step[] = [];
  #listeners = new Set<(event: StoreEvent) => void>();

  constructor(document: Document) {
    this.#document = freeze(document, true);
  }

  get document(): Document {
    return this.#document;
  }
  get canUndo(): boolean {
    return this.#done.length > 0;
  }
  get canRedo(): boolean {
    return this.#undone.length > 0;
  }
  get undoLabel(): string | null {
    return this.#done.at(-1)?.label ?? null;
  }
  get redoLabel(): string | null {
    return this.#undone.at(-1)?.label ?? null;
  }

  /** One undo step. Throws DocumentError, and changes nothing, if the result would not be valid. */
  edit(label: string, recipe: (draft: Draft) => void, { merge }: EditOptions = {}): void {
    const before = this.#document;
    const after = produce(before, (draft) => {
      recipe(draft as Draft);
    });
    if (after === before) return;
    const issues = documentIssues(after, before);
    if (issues.length > 0) throw new DocumentError(label, issues);
    const last = this.#done.at(-1);
    if (merge !== undefined && last?.merge === merge && this.#undone.length === 0) {
      last.after = after;
    } else {
      this.#forgotten = this.#undone;
      this.#done.push({ label, before, after, merge });
      if (this.#done.length > maxSteps) this.#done.shift();
    }
    this.#undone = [];
    this.#change(after, label, 'edit');
  }

  /**
   * Takes back a drag that is under way as though it had never been: what it made impossible to redo can be redone.
   *
   * @param merge the edits' key, or the last word of it
   */
  abandon(merge: string): void {
    const last = this.#done.at(-1);
    if (last?.merge === undefined || !` ${last.merge}`.endsWith(` ${merge}`)) return;
    this.#done.pop();
    this.#undone = this.#forgotten;
    this.#change(last.before, last.label, 'undo');
  }

  /** Ends a drag: the next edit is a step of its own, whatever its merge key. */
  endMerge(): void {
    const last = this.#done.at(-1);
    if (last !== undefined) last.merge = undefined;
  }

  undo(): void {
    this.goTo(this.#done.length - 1);
  }

  redo(): void {
    this.goTo(this.#done.length + 1);
  }

  /** Every step from the first, those that were undone last. The present state is behind `historyIndex` of them. */
  get history(): readonly HistoryStep[] {
    return [...this.#done, ...this.#undone.toReversed()];
  }
  get historyIndex(): number {
    return this.#done.length;
  }

  /** Undoes or redoes until so many steps are done, as one change. */
  goTo(index: number): void {
    const from = this.#done.length;
    const to = Math.max(0, Math.min(from + this.#undone.length, Math.round(index)));
    if (to === from) return;
    let last: Step | undefined;
    while (this.#done.length > to) {
      last = this.#done.pop();
      if (last) this.#undone.push(last);
    }
    while (this.#done.length < to) {
      last = this.#undone.pop();
      if (last) this.#done.push(last);
    }
    this.endMerge();
    if (last) this.#change(to < from ? last.before : last.after, last.label, to < from ? 'undo' : 'redo');
  }

  /** Another document; there is no undo back to the last one. */
  open(document: Document): void {
    this.#done = [];
    this.#undone = [];
    this.#forgotten = [];
    this.#change(freeze(document, true), `Open ${document.name}`, 'open');
  }

  subscribe(listener: (event: StoreEvent) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #change(document: Document, label: string, reason: StoreEvent['reason']): void {
    const previous = this.#document;
    this.#document = document;
    for (const listener of [...this.#listeners]) listener({ document, previous, label, reason });
  }
}
