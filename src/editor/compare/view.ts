/** Over the picture while two materials are compared: the divider, both names, and which of them stays. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { splitLine } from '../ui/split-line.ts';
import { endComparison } from './start.ts';

export function createComparisonView(session: Session): HTMLElement {
  const { store, state } = session;
  const line = splitLine(t('Divider between the two materials'), (divider) => state.set({ divider }));
  const [nameA, nameB] = [h('span', { class: 'compare-name' }), h('span', { class: 'compare-name' })];
  const keep = (which: 'A' | 'B', text: string, tip: string) => {
    const button = h('button', { type: 'button', class: 'text-button', tip }, text);
    button.addEventListener('click', () => endComparison(session, which));
    return button;
  };
  const bar = h(
    'div',
    { class: 'compare-bar', role: 'group', 'aria-label': t('Comparison of two materials') },
    h('b', {}, 'A'),
    nameA,
    keep('A', t('Keep A'), t('End the comparison; nothing has changed (Esc)')),
    h('span', { class: 'compare-between' }),
    keep('B', t('Keep B'), t('The material becomes B, in one step that can be undone')),
    h('b', {}, 'B'),
    nameB,
  );
  const action = (text: string, run: () => void) => {
    const button = h('button', { type: 'button', class: 'text-button' }, text);
    button.addEventListener('click', run);
    return button;
  };
  // The path tracer has the document's material alone.
  const paused = h(
    'div',
    { class: 'compare-paused', role: 'group', 'aria-label': t('Comparison of two materials') },
    h('span', {}, t('Path traced pictures show A alone.')),
    action(t('Back to the comparison'), () => state.set({ rendering: 'interactive' })),
    action(t('End'), () => endComparison(session, 'A')),
  );
  const element = h('div', { class: 'split comparison', hidden: true }, line.element, bar, paused);
  const show = () => {
    const { comparison, divider, rendering } = state.value;
    element.hidden = comparison === null;
    if (!comparison) return;
    const isPaused = rendering !== 'interactive';
    line.element.hidden = isPaused;
    bar.hidden = isPaused;
    paused.hidden = !isPaused;
    line.show(divider);
    nameA.textContent = store.document.materials[comparison.material]?.name ?? '';
    nameB.textContent = comparison.title;
  };
  state.subscribe((now, before) => {
    const isOther = now.comparison !== before.comparison || now.rendering !== before.rendering;
    if (isOther || now.divider !== before.divider) show();
  });
  store.subscribe(show);
  show();
  return element;
}
