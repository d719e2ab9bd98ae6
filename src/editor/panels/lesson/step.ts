/** One step of a lesson: what is read, and the fields, terms and questions in it. */

import { t } from '../../language/language.ts';
import type { Course } from '../../learn/course.ts';
import type { Block } from '../../learn/lesson.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import type { Bound } from '../inspector/field.ts';
import { lessonField } from './field.ts';
import { Terms } from './terms.ts';
import { formula, inlineNodes, proseElement } from './text.ts';

export function stepView(session: Session, course: Course): Bound {
  const terms = new Terms(session, course);
  const fields: Bound[] = [];
  const { step } = course;
  const elements = step.blocks.map((block) => blockElement(block));

  function blockElement(block: Block): HTMLElement {
    switch (block.kind) {
      case 'paragraph':
      case 'list':
        return terms.block((onTerm) => proseElement(block, onTerm));
      case 'formula':
        return terms.block((onTerm) => formula(block.tex, true, onTerm), block.terms);
      case 'field': {
        const field = lessonField(session, course, block);
        fields.push(field);
        return field.element;
      }
      case 'do':
      case 'see':
        return terms.block((onTerm) =>
          h(
            'p',
            { class: `lesson-note ${block.kind}` },
            h('strong', {}, block.kind === 'do' ? t('Do') : t('See')),
            h('span', {}, ...inlineNodes(block.text, onTerm)),
          ),
        );
      case 'question':
        return h(
          'details',
          { class: 'lesson-question' },
          h('summary', {}, h('span', {}, ...inlineNodes(block.question, () => {}))),
          terms.block((onTerm) => h('p', {}, ...inlineNodes(block.answer, onTerm))),
        );
    }
  }

  return {
    element: h('div', { class: 'lesson-step' }, h('h2', { tabindex: -1 }, step.title), ...elements),
    update() {
      for (const field of fields) field.update();
      terms.update();
    },
  };
}
