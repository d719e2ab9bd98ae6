/** Lessons in the page: the panel, the list, and the lesson that is open. Loaded when somebody wants to learn. */
import 'katex/dist/katex.min.css';
import '../style/lesson.css';
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';
import { createLessonPanel, type LessonPanel } from '../panels/lesson/panel.ts';
import type { Session } from '../session.ts';
import { toastError } from '../ui/toast.ts';
import { type Before, Course, whatIsOpen } from './course.ts';
import type { ReadyLesson } from './prepare.ts';
import { progressOf } from './progress.ts';
import { type LessonSource, lessonOfAddress, lessonOfFiles, readLesson, shippedLesson } from './source.ts';

interface Opened {
  readonly source: LessonSource;
  readonly lesson: ReadyLesson;
}

export class Learning {
  readonly #session: Session;
  readonly #panel: LessonPanel;
  #course: Course | null = null;
  /** What the page's address names. */
  #addressed: Opened | null = null;

  constructor(session: Session) {
    this.#session = session;
    this.#panel = createLessonPanel(session, this);
  }

  get course(): Course | null {
    return this.#course;
  }

  get isOpen(): boolean {
    return this.#panel.isOpen;
  }

  /** The list of lessons, over the lesson that is open, if there is one. */
  showList(): void {
    this.#panel.showList();
  }

  async open(name: string): Promise<void> {
    await this.#attempt(() => shippedLesson(name));
  }

  async openFiles(files: readonly File[]): Promise<void> {
    await this.#attempt(() => lessonOfFiles(files));
  }

  /** The scene of the lesson that the page's address names, as its step shows it. Throws an Error that says what is wrong. */
  async addressedDocument(address: string): Promise<Document> {
    const { source, lesson } = await this.#read(address);
    return stepOf(source, lesson).document;
  }

  /** The same lesson beside its scene, which is open. */
  async openAddressed(address: string): Promise<void> {
    try {
      const { source, lesson } = await this.#read(address);
      this.#begin(source, lesson, whatIsOpen(this.#session, false));
    } catch {
      // Who asked for the scene has said what is wrong.
      this.#panel.showList();
    }
  }

  go(index: number): void {
    this.#course?.go(index);
    this.#panel.showStep();
  }

  reset(): void {
    this.#course?.reset();
    this.#panel.showStep();
  }

  async leave(): Promise<void> {
    const course = this.#course;
    this.#course = null;
    this.#panel.close();
    try {
      await course?.leave();
    } catch (error) {
      toastError(t('What was open before could not be opened'), error);
    }
  }

  async #read(address: string): Promise<Opened> {
    if (this.#addressed) return this.#addressed;
    const source = address.includes('/') ? await lessonOfAddress(address) : shippedLesson(address);
    this.#addressed = { source, lesson: readLesson(source) };
    return this.#addressed;
  }

  async #attempt(find: () => LessonSource | Promise<LessonSource>): Promise<void> {
    try {
      const source = await find();
      const lesson = readLesson(source);
      // From lesson to lesson, what was there before the first of them is what comes back.
      const before = this.#course?.before ?? whatIsOpen(this.#session, true);
      if (await this.#session.workspace.replace(stepOf(source, lesson).document, source.address))
        this.#begin(source, lesson, before);
      else this.#panel.close();
    } catch (error) {
      toastError(t('The lesson was not opened; the scene is unchanged'), error);
    }
  }

  #begin(source: LessonSource, lesson: ReadyLesson, before: Before): void {
    this.#course = new Course(this.#session, source, lesson, before, () => {
      this.#course = null;
      this.#panel.close();
    });
    this.#course.begin(indexOf(source, lesson));
    this.#panel.showStep();
  }
}

/** The step that the person saw last; the first one after the last. */
function indexOf({ name, address }: LessonSource, { steps }: ReadyLesson): number {
  const step = (address !== null && progressOf(name)?.step) || 0;
  return step < steps.length - 1 ? step : 0;
}

function stepOf(source: LessonSource, lesson: ReadyLesson) {
  return lesson.steps[indexOf(source, lesson)] as ReadyLesson['steps'][number];
}
