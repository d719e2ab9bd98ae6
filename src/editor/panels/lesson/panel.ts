/** The panel of lessons, in place of the outliner: their list, or the step of the one that is open. */
import { t } from '../../language/language.ts';
import type { Learning } from '../../learn/learn.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { iconButton } from '../../ui/icon-button.ts';
import type { Bound } from '../inspector/field.ts';
import { lessonList } from './list.ts';
import { stepView } from './step.ts';
import { fitFormulas } from './text.ts';

export interface LessonPanel {
  readonly isOpen: boolean;
  showList(): void;
  showStep(): void;
  close(): void;
}

export function createLessonPanel(session: Session, learning: Learning): LessonPanel {
  const title = h('span', { class: 'lesson-heading' });
  const list = iconButton('list', t('All lessons'), () => showList());
  const reset = iconButton('loop', t('This step as it was'), () => learning.reset());
  const close = iconButton('close', t('Leave the lessons'), () => void learning.leave());
  const parts = h('ol', { class: 'lesson-parts', 'aria-label': t('Steps') });
  const body = h('div', { class: 'lesson-body', tabindex: 0 });
  const back = h(
    'button',
    {
      type: 'button',
      class: 'text-button lesson-nav',
      tip: t('Previous step of the lesson'),
      keys: 'learn.back',
    },
    t('Back'),
  );
  const next = h(
    'button',
    {
      type: 'button',
      class: 'text-button lesson-nav primary',
      tip: t('Next step of the lesson'),
      keys: 'learn.next',
    },
    t('Next'),
  );
  const count = h('span', { class: 'lesson-count' });
  const foot = h('footer', {}, back, count, next);
  const element = h(
    'aside',
    { class: 'lesson-panel', 'aria-label': t('Lessons') },
    h('header', {}, list, title, reset, close),
    parts,
    body,
    foot,
  );
  let shown: Bound | null = null;

  back.addEventListener('click', () => session.actions.run('learn.back'));
  next.addEventListener('click', () => session.actions.run('learn.next'));
  session.store.subscribe(() => shown?.update());
  // While there is more to read, these keys belong to the text.
  body.addEventListener('keydown', (event) => {
    const down = body.scrollTop + body.clientHeight < body.scrollHeight - 1;
    if ((event.key === 'PageDown' && down) || (event.key === 'PageUp' && body.scrollTop > 0))
      event.stopPropagation();
  });

  const open = () => {
    const app = document.getElementById('app');
    session.closeSheet();
    if (element.isConnected || !app) return;
    app.append(element);
    app.classList.add('learning');
  };

  function showList(): void {
    open();
    shown = null;
    title.textContent = t('Lessons');
    const current = learning.course?.source.name ?? null;
    body.replaceChildren(lessonList((name) => void learning.open(name), current));
    body.scrollTop = 0;
    list.hidden = reset.hidden = parts.hidden = foot.hidden = true;
  }

  function showStep(): void {
    const { course } = learning;
    if (!course) return;
    open();
    const { lesson, index } = course;
    const hadFocus = element.contains(document.activeElement);
    title.textContent = lesson.title;
    shown = stepView(session, course);
    body.replaceChildren(shown.element);
    fitFormulas(body);
    // Its fonts come with the first formula.
    void document.fonts.ready.then(() => fitFormulas(body));
    body.scrollTop = 0;
    shown.update();
    parts.replaceChildren(...lesson.steps.map((step, i) => part(step.title, i, index)));
    count.textContent = t('{step} of {count}', { step: index + 1, count: lesson.steps.length });
    back.disabled = course.isFirst;
    next.textContent = course.isLast ? t('All lessons') : t('Next');
    list.hidden = reset.hidden = parts.hidden = foot.hidden = false;
    if (hadFocus) shown.element.querySelector('h2')?.focus();
  }

  function part(stepTitle: string, i: number, index: number): HTMLElement {
    const button = h('button', {
      type: 'button',
      'aria-label': `${i + 1}. ${stepTitle}`,
      tip: `${i + 1}. ${stepTitle}`,
      class: i < index ? 'past' : undefined,
      ...(i === index && { 'aria-current': 'step' }),
    });
    button.addEventListener('click', () => learning.go(i));
    return h('li', {}, button);
  }

  return {
    get isOpen() {
      return element.isConnected;
    },
    showList,
    showStep,
    close() {
      shown = null;
      element.remove();
      document.getElementById('app')?.classList.remove('learning');
    },
  };
}
