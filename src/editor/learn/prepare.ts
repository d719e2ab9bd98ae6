/**
 * A lesson held against its scene: every step's document, plots and fields, or a LessonError that names the line of
 * what the scene does not have. A step is the lesson's scene with the step's own lines on top, whatever came before.
 */
import { produce } from 'immer';
import type { Path } from '../../scene/error.ts';
import { findModel } from '../../scene/models.ts';
import type { Document } from '../../scene/schema.ts';
import { documentIssues } from '../../scene/validate.ts';
import type { BenchSettings } from '../panels/bench/settings.ts';
import { selectedMaterial } from '../selected-material.ts';
import type { Entity, Rendering, Selection } from '../state.ts';
import { benchOf } from './bench-settings.ts';
import { LessonError, type Place, shown } from './error.ts';
import { type FieldPlace, fieldAt, PathError } from './field-path.ts';
import type { Block, Definition, Lesson, Setting, Step } from './lesson.ts';

export interface ReadyStep {
  readonly title: string;
  readonly blocks: readonly Block[];
  readonly document: Document;
  readonly rendering: Rendering;
  readonly selection: Selection;
  /** Null where the step has no plot. */
  readonly bench: Partial<BenchSettings> | null;
}

export interface ReadyLesson {
  readonly title: string;
  readonly summary: string;
  readonly minutes: number;
  /** Whose terms are looked at; null in a scene without materials. */
  readonly material: string | null;
  readonly definitions: ReadonlyMap<string, Definition>;
  readonly steps: readonly ReadyStep[];
}

export function prepareLesson(lesson: Lesson, scene: Document): ReadyLesson {
  const { title, summary, minutes, definitions } = lesson;
  const material = lesson.material ?? Object.keys(scene.materials)[0] ?? null;
  if (material !== null && !Object.hasOwn(scene.materials, material))
    throw new LessonError(
      { file: lesson.file, line: 1 },
      `there is no material “${shown(material)}”`,
      `one of ${Object.keys(scene.materials).join(', ')}`,
    );
  // As a document it is called what the lesson is called, in its language.
  const named = { ...scene, name: title, description: summary };
  const steps = lesson.steps.map((step) => new Preparation(step, named, material).ready());
  for (const definition of definitions.values()) checkDefinition(definition, steps, material);
  return { title, summary, minutes, material, definitions, steps };
}

/** A field's place in a document, or the LessonError that says where the text names none. */
export function placeOf(document: Document, path: string, place: Place): FieldPlace {
  try {
    return fieldAt(document, path);
  } catch (error) {
    if (error instanceof PathError) throw new LessonError(place, error.message, error.expected);
    throw error;
  }
}

/** What it stands for has to be in one of the steps. */
function checkDefinition(
  { target, place }: Definition,
  steps: readonly ReadyStep[],
  material: string | null,
): void {
  if (target.kind === 'idea') return;
  let fault: unknown;
  for (const { document } of steps) {
    try {
      if (target.kind === 'term') checkTerm(document, material, target.name, place);
      else if (!placeOf(document, target.path, place).info)
        throw new LessonError(place, `${shown(target.path)} has no control`, 'the path of a single field');
      return;
    } catch (error) {
      fault ??= error;
    }
  }
  throw fault;
}

function checkTerm(document: Document, material: string | null, name: string, place: Place): void {
  const model = document.materials[material ?? '']?.model ?? '';
  const terms = findModel(document, model)?.terms ?? [];
  if (!terms.includes(name))
    throw new LessonError(
      place,
      `${model || 'no material'} has no term “${shown(name)}”`,
      `one of ${terms.join(', ')}`,
    );
}

class Preparation {
  readonly #step: Step;
  readonly #material: string | null;
  #document: Document;
  #rendering: Rendering = 'interactive';
  #selection: Selection;
  #bench: Partial<BenchSettings> | null = null;

  constructor(step: Step, scene: Document, material: string | null) {
    this.#step = step;
    this.#document = scene;
    this.#material = material;
    this.#selection = material === null ? null : { kind: 'materials', id: material };
  }

  ready(): ReadyStep {
    const { title, blocks, settings } = this.#step;
    for (const setting of settings) this.#apply(setting);
    for (const block of blocks) if (block.kind === 'field') this.#checkField(block);
    return {
      title,
      blocks,
      document: this.#document,
      rendering: this.#rendering,
      selection: this.#selection,
      bench: this.#bench,
    };
  }

  #apply(setting: Setting): void {
    const { place } = setting;
    switch (setting.kind) {
      case 'set':
        this.#write(placeOf(this.#document, setting.path, place).path, setting.value, place);
        break;
      case 'without':
        for (const text of setting.entities) {
          const { kind, id } = this.#entity(text, place);
          this.#change(place, (draft) => {
            delete draft[kind][id];
          });
        }
        break;
      case 'look':
        this.#write(['camera', 'position'], [...setting.from], place);
        if (setting.at) this.#write(['camera', 'target'], [...setting.at], place);
        break;
      case 'term': {
        const material = setting.material ?? this.#material;
        checkTerm(this.#document, material, setting.name, place);
        this.#write(['view', 'term'], { material, name: setting.name }, place);
        break;
      }
      case 'rendering':
        this.#rendering = setting.rendering;
        break;
      case 'select':
        this.#selection = this.#entity(setting.entity, place);
        break;
      case 'plot':
      case 'pin':
        // As in the bench: the plots are of what is selected.
        this.#bench = benchOf(
          this.#bench,
          setting,
          this.#document,
          selectedMaterial(this.#document, this.#selection),
        );
        break;
    }
  }

  #write(path: Path, value: unknown, place: Place): void {
    this.#change(place, (draft) => {
      let holder: unknown = draft;
      for (const key of path.slice(0, -1)) holder = (holder as Record<string | number, unknown>)[key];
      (holder as Record<string | number, unknown>)[path.at(-1) as string] = value;
    });
  }

  /** What the schema refuses is a fault of this line. */
  #change(place: Place, recipe: (draft: Document) => void): void {
    const before = this.#document;
    const after = produce(before, recipe);
    const [issue] = after === before ? [] : documentIssues(after, before);
    if (issue) throw new LessonError(place, `${issue.path}: ${issue.message}`, 'what the scene can have');
    this.#document = after;
  }

  #entity(text: string, place: Place): Entity {
    const [kind, id = ''] = text.split('.');
    const known = (['lights', 'objects', 'materials'] as const).find((name) => name === kind);
    if (known && Object.hasOwn(this.#document[known], id)) return { kind: known, id };
    throw new LessonError(place, `there is no ${shown(text)}`, 'lights.<id>, objects.<id> or materials.<id>');
  }

  #checkField({ path, range, place }: Extract<Block, { kind: 'field' }>): void {
    const { info } = placeOf(this.#document, path, place);
    if (!info || info.kind === 'reference' || info.kind === 'group')
      throw new LessonError(place, `${shown(path)} has no control`, 'the path of a single field');
    if (range && info.kind !== 'number' && info.kind !== 'integer')
      throw new LessonError(place, `${shown(path)} is no number`, `:field ${path} Label`);
  }
}
