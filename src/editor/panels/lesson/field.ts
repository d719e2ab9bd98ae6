/** A field of the scene within a lesson: the inspector's own control, so that a drag is one undo step. */

import { t } from '../../language/language.ts';
import type { Course } from '../../learn/course.ts';
import { fieldAt } from '../../learn/field-path.ts';
import type { Range } from '../../learn/lesson.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { pathCell, readPath } from '../inspector/cell.ts';
import { type Bound, infoField, labelOf } from '../inspector/field.ts';

export interface LessonField {
  readonly path: string;
  readonly range?: Range | null;
  readonly label?: string;
}

/** Whether the step has the field: another one may do without what it is of. */
export function hasField({ step }: Course, path: string): boolean {
  try {
    fieldAt(step.document, path);
    return true;
  } catch {
    return false;
  }
}

/** It stands still where the person has taken away what it is of. */
export function lessonField(
  session: Session,
  course: Course,
  { path: text, range, label = '' }: LessonField,
): Bound {
  const { store } = session;
  const { path, info, otherwise } = fieldAt(course.step.document, text);
  const name = label || labelOf(String(path.findLast((part) => typeof part === 'string')));
  const cell = pathCell(store, path, t('Change {label}', { label: name }));
  const read = () => cell.get() ?? otherwise;
  const before = readPath(course.step.document, path) ?? otherwise;
  const bound =
    info && infoField(name, range ? { ...info, slider: range } : info, { ...cell, get: read }, before);
  const element = h('div', { class: 'lesson-field' }, bound?.element);
  element.dataset.path = path.join('.');
  return {
    element,
    update() {
      const there = readPath(store.document, path.slice(0, -1)) !== undefined;
      element.inert = !there;
      if (there) bound?.update();
    },
  };
}
