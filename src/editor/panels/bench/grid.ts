/** The panes of the bench: one in the dock, six on the full page, each with a view of its own choice. */

import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { selectField } from '../../ui/fields.ts';
import { createPane, type PaneActions, type PlotPane } from './pane.ts';
import { type BenchSettings, type BenchView, initialSettings, paneSettings, views } from './settings.ts';
import { viewInfo } from './views.ts';

export interface Grid {
  readonly element: HTMLElement;
  pane(index: number): PlotPane;
  show(settings: BenchSettings, visible: readonly number[]): void;
}

export interface GridActions extends PaneActions {
  activate(pane: number): void;
  choose(pane: number, view: BenchView): void;
  /** What a view shows that is no drawing. */
  panel(view: BenchView): HTMLElement;
}

const choices = views.map((view) => ({ value: view, label: viewInfo[view].label }));

export function createGrid(actions: GridActions): Grid {
  const cells = initialSettings.panes.map((_, index) => {
    const pane = createPane(actions);
    const choice = selectField(t('View {number}', { number: index + 1 }), choices, (value) => {
      const view = views.find((candidate) => candidate === value);
      if (view) actions.choose(index, view);
    });
    const body = h('div', { class: 'bench-pane-body' }, pane.element);
    const element = h(
      'div',
      { class: 'bench-pane' },
      h('div', { class: 'bench-pane-head' }, choice.element),
      body,
    );
    element.addEventListener('pointerdown', () => actions.activate(index));
    element.addEventListener('focusin', () => actions.activate(index));
    return { pane, choice, body, element };
  });
  const element = h('div', { class: 'bench-view' });
  let shown = '';
  return {
    element,
    pane: (index) => (cells[index] as (typeof cells)[number]).pane,
    show(settings, visible) {
      const key = visible.join();
      if (key !== shown) {
        shown = key;
        element.replaceChildren(...visible.flatMap((index) => cells[index]?.element ?? []));
      }
      for (const index of visible) {
        const cell = cells[index];
        const { view } = paneSettings(settings, index);
        const content = viewInfo[view].view ? cell?.pane.element : actions.panel(view);
        if (content && content.parentElement !== cell?.body) cell?.body.replaceChildren(content);
        cell?.choice.show(view);
        cell?.element.classList.toggle('active', index === settings.active);
      }
    },
  };
}
