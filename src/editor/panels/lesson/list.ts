/** The lessons that ship, each with how far the person has come. */
import { t } from '../../language/language.ts';
import { progressOf } from '../../learn/progress.ts';
import { type LessonSummary, lessonSummaries } from '../../learn/source.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';

export function lessonList(open: (name: string) => void, current: string | null): HTMLElement {
  const items = lessonSummaries().map((lesson, i) => h('li', {}, card(lesson, i + 1, open, current)));
  return h(
    'div',
    { class: 'lesson-list' },
    h(
      'p',
      { class: 'lesson-lead' },
      t('From one lamp to a complete material: a formula, a slider and a picture at every step.'),
    ),
    h('ol', {}, ...items),
    h(
      'p',
      { class: 'hint' },
      t('A lesson of your own: drop a folder or a .zip with lesson.en.md and scene.json on the page.'),
    ),
  );
}

function card(
  { name, title, summary, minutes }: LessonSummary,
  number: number,
  open: (name: string) => void,
  current: string | null,
): HTMLElement {
  const progress = progressOf(name);
  const state = progress?.done ? icon('check') : progress ? h('span', { class: 'lesson-begun' }) : null;
  const button = h(
    'button',
    { type: 'button', class: 'lesson-card', ...(name === current && { 'aria-current': 'true' }) },
    h('span', { class: 'lesson-number' }, String(number)),
    h('span', { class: 'lesson-title' }, title),
    h(
      'span',
      { class: 'lesson-state' },
      state,
      progress?.done ? t('seen') : progress ? t('begun') : t('{minutes} min', { minutes }),
    ),
    h('span', { class: 'lesson-summary' }, summary),
  );
  button.dataset.lesson = name;
  button.addEventListener('click', () => open(name));
  return button;
}
