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
      this.#done.push({ label, before, after, merge });
      if (this.#done.length > maxSteps) this.#done.shift();
    }
    this.#undone = [];
    this.#change(after, label, 'edit');
  }

  /** Ends a drag: the next edit is a step of its own, whatever its merge key. */
  endMerge(): void {
    const last = this.#done.at(-1);
    if (last !== undefined) last.merge = undefined;
  }

  undo(): void {
    const step = this.#done.pop();
    if (step === undefined) return;
    this.#undone.push(step);
    this.endMerge();
    this.#change(step.before, step.label, 'undo');
  }

  redo(): void {
    const step = this.#undone.pop();
    if (step === undefined) return;
    step.merge = undefined;
    this.#done.push(step);
    this.#change(step.after, step.label, 'redo');
  }

  /** Another document; there is no undo back to the last one. */
  open(document: Document): void {
    this.#done = [];
    this.#undone = [];
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
