/**
 * A lesson that is being taken: which step, and what the page shows for it. The lesson has a document of its own; what
 * was open before comes back when the lesson is left.
 */
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { initialSettings } from '../panels/bench/settings.ts';
import type { Session } from '../session.ts';
import type { EditorState } from '../state.ts';
import { onlyTheCameraDiffers } from '../storage/autosave.ts';
import type { KeptDocument } from '../storage/kept-documents.ts';
import type { ReadyLesson, ReadyStep } from './prepare.ts';
import { keepProgress } from './progress.ts';
import type { LessonSource } from './source.ts';

/** What was on the page before the lesson. */
export interface Before {
  readonly state: Pick<EditorState, 'benchOpen' | 'benchPage' | 'bench' | 'rendering' | 'source'>;
  /** Null where the page began with the lesson. */
  readonly scene: {
    readonly document: Document;
    readonly kept: KeptDocument | null;
    readonly address: string;
  } | null;
}

export class Course {
  readonly source: LessonSource;
  readonly lesson: ReadyLesson;
  readonly #session: Session;
  readonly before: Before;
  readonly #unsubscribe: () => void;
  #index = 0;
  /** The document as the course last left it. */
  #put: Document;
  /** The course itself is opening something. */
  #busy = false;

  /** @param onEnd another document was opened in place of the lesson's */
  constructor(
    session: Session,
    source: LessonSource,
    lesson: ReadyLesson,
    before: Before,
    onEnd: () => void,
  ) {
    this.source = source;
    this.lesson = lesson;
    this.#session = session;
    this.before = before;
    this.#put = session.store.document;
    this.#unsubscribe = session.store.subscribe(({ reason }) => {
      if (reason !== 'open' || this.#busy) return;
      this.#end();
      onEnd();
    });
  }

  get index(): number {
    return this.#index;
  }

  get step(): ReadyStep {
    return this.lesson.steps[this.#index] as ReadyStep;
  }

  get isFirst(): boolean {
    return this.#index === 0;
  }

  get isLast(): boolean {
    return this.#index === this.lesson.steps.length - 1;
  }

  /** Shows a step of the document that is open already, as it is: what a person did there is theirs. */
  begin(index: number): void {
    this.#index = index;
    this.#showRoom();
  }

  go(index: number): void {
    const from = this.step.document.camera;
    this.#index = Math.max(0, Math.min(this.lesson.steps.length - 1, index));
    const { document } = this.step;
    // The camera stays in the person's hand as long as the lesson does not move it.
    const sameView = JSON.stringify(from) === JSON.stringify(document.camera);
    this.#change(sameView ? { ...document, camera: this.#session.store.document.camera } : document);
    this.#showRoom();
  }

  /** The step as it was at its beginning. */
  reset(): void {
    this.#change(this.step.document);
    this.#showRoom();
  }

  /** The term of the lesson's material that the picture shows alone. */
  get term(): string | null {
    const { term } = this.#session.store.document.view;
    return term !== null && term.material === this.lesson.material ? term.name : null;
  }

  /** Null shows what the step itself shows. */
  showTerm(name: string | null): void {
    const { material } = this.lesson;
    const { state, store } = this.#session;
    const { document } = store;
    const term = name !== null && material !== null ? { material, name } : this.step.document.view.term;
    this.#change({ ...document, view: { ...document.view, term } });
    const plotted = name ?? this.step.bench?.term ?? 'BRDF';
    if (state.value.benchOpen) state.set({ bench: { ...state.value.bench, term: plotted } });
  }

  /** What was there before the lesson is there again; what was done in the lesson is kept as a document. */
  async leave(): Promise<void> {
    const { scene } = this.before;
    const { workspace } = this.#session;
    this.#end();
    if (scene?.kept) await workspace.openKept(scene.kept);
    else if (scene) await workspace.replace(scene.document, scene.address);
  }

  #end(): void {
    this.#unsubscribe();
    this.#session.state.set(this.before.state);
  }

  /** As long as nobody has worked on the lesson's scene, its steps are no work, either; otherwise one undo step. */
  #change(document: Document): void {
    const { store, workspace } = this.#session;
    this.#busy = true;
    if (workspace.kept === null && onlyTheCameraDiffers(store.document, this.#put)) workspace.amend(document);
    else {
      const label = t('Lesson: {step}', { step: this.step.title });
      store.edit(label, (draft) => void Object.assign(draft, document));
      store.endMerge();
    }
    this.#busy = false;
    this.#put = store.document;
  }

  /** Plots, rendering and what is selected. */
  #showRoom(): void {
    const { bench, rendering, selection } = this.step;
    const { state } = this.#session;
    state.select(selection);
    state.set({
      rendering,
      source: null,
      benchOpen: bench !== null,
      benchPage: false,
      bench: { ...initialSettings, ...bench },
    });
    // A folder that was dropped may be called anything.
    if (this.source.address !== null) keepProgress(this.source.name, this.#index, this.isLast);
  }
}

export function whatIsOpen({ state, store, workspace }: Session, withScene: boolean): Before {
  const { benchOpen, benchPage, bench, rendering, source } = state.value;
  const scene = { document: store.document, kept: workspace.kept, address: location.search + location.hash };
  return { state: { benchOpen, benchPage, bench, rendering, source }, scene: withScene ? scene : null };
}
