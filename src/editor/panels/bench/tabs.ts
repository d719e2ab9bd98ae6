/** The views of the bench: one tab stop, arrow keys between them (WAI-ARIA tabs). */

import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { type BenchView, views } from './settings.ts';
import { viewInfo } from './views.ts';

export interface Tabs {
  readonly element: HTMLElement;
  show(view: BenchView): void;
}

export function createTabs(change: (view: BenchView) => void): Tabs {
  const buttons = views.map((view) => {
    const { label, tip } = viewInfo[view];
    const button = h('button', { type: 'button', role: 'tab', class: 'bench-tab', tip }, label);
    button.dataset.view = view;
    button.addEventListener('click', () => change(view));
    return { view, button };
  });
  const element = h(
    'div',
    { class: 'bench-tabs', role: 'tablist', 'aria-label': t('Plot') },
    ...buttons.map(({ button }) => button),
  );
  element.addEventListener('keydown', (event) => {
    const direction = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!direction) return;
    event.preventDefault();
    const now = buttons.findIndex(({ button }) => button.getAttribute('aria-selected') === 'true');
    const next = buttons[(now + direction + buttons.length) % buttons.length];
    if (!next) return;
    change(next.view);
    next.button.focus();
  });
  let shown: BenchView | null = null;
  return {
    element,
    show(current) {
      if (current === shown) return;
      shown = current;
      for (const { view, button } of buttons) {
        button.setAttribute('aria-selected', String(view === current));
        button.tabIndex = view === current ? 0 : -1;
        // In a narrow bench the row of tabs is longer than there is room.
        if (view === current) button.scrollIntoView({ block: 'nearest', inline: 'nearest' });
      }
    },
  };
}
