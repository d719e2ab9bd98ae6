/** All steps that can be undone and redone, by name. A click goes to the state behind a step. */
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { openPopup } from '../../ui/popup.ts';

export function openHistory({ store }: Session, anchor: HTMLElement): void {
  const list = h('div', {
    class: 'history-list',
    role: 'listbox',
    tabindex: 0,
    'aria-label': t('History'),
  });
  const entry = (label: string, index: number) => {
    const isPresent = index === store.historyIndex;
    const option = h(
      'div',
      {
        class: index > store.historyIndex ? 'history-step undone' : 'history-step',
        role: 'option',
        id: `history-${index}`,
        'aria-selected': String(isPresent),
      },
      label,
    );
    option.classList.toggle('present', isPresent);
    option.addEventListener('click', () => store.goTo(index));
    return option;
  };
  const update = () => {
    const steps = store.history.map(({ label }, i) => entry(translate(label), i + 1));
    const { scrollTop } = list;
    list.replaceChildren(entry(t('As it was opened'), 0), ...steps);
    list.scrollTop = scrollTop;
    list.setAttribute('aria-activedescendant', `history-${store.historyIndex}`);
    list.querySelector('.present')?.scrollIntoView({ block: 'nearest' });
  };
  const moves: Readonly<Record<string, () => number>> = {
    ArrowUp: () => store.historyIndex - 1,
    ArrowDown: () => store.historyIndex + 1,
    Home: () => 0,
    End: () => store.history.length,
  };
  list.addEventListener('keydown', (event) => {
    const to = moves[event.key];
    if (!to) return;
    event.preventDefault();
    store.goTo(to());
  });
  const stop = store.subscribe(update);
  update();
  const heading = h('div', { class: 'menu-heading' }, t('History'));
  openPopup({
    anchor,
    content: h('div', { class: 'history' }, heading, list),
    label: t('History'),
    onClose: stop,
  });
  update();
  list.focus();
}
