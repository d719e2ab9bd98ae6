/**
 * On a narrow page the panels are sheets under the picture, one at a time, and these are their tabs
 * (style/narrow.css). On a wide page all panels are there, and the tabs are not.
 */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { type IconName, icon } from '../ui/icons.ts';

/** By the class of the panel. */
export type Sheet = 'panel-left' | 'panel-right' | 'bench' | 'status' | 'source';

export interface SheetTabs {
  readonly element: HTMLElement;
  /** Null: what lies under the picture when no panel does. */
  open(sheet: Sheet | null): void;
}

export function createSheetTabs({ state, store, actions }: Session): SheetTabs {
  let sheet: Sheet | null = null;
  const tab = (own: Sheet | null, label: string, name: IconName) => {
    const button = h('button', { type: 'button', class: 'sheet-tab' }, icon(name), h('span', {}, label));
    button.addEventListener('click', () => {
      if (own === 'bench' && !state.value.benchOpen) actions.run('view.bench');
      // A second touch gives the picture its place back.
      else {
        open(own === sheet ? null : own);
        // The library keeps the place of the sheets until the picture is asked for.
        if (own === null && actions.get('material.library').on?.()) actions.run('material.library');
      }
    });
    return { own, button };
  };
  const tabs = [
    tab(null, t('Picture'), 'image'),
    tab('panel-left', t('Scene'), 'scene'),
    tab('panel-right', t('Properties'), 'material'),
    tab('bench', t('Bench'), 'plot'),
    tab('status', t('Figures'), 'stopwatch'),
  ];
  const element = h(
    'nav',
    { class: 'sheet-tabs', 'aria-label': t('Panels') },
    ...tabs.map(({ button }) => button),
  );
  const open = (next: Sheet | null) => {
    sheet = next;
    element.parentElement?.setAttribute('data-sheet', next ?? '');
    for (const { own, button } of tabs) button.setAttribute('aria-pressed', String(own === next));
  };
  // What is opened elsewhere, by a key or from a menu, is what the person wants to see.
  state.subscribe((now, before) => {
    if (now.benchOpen !== before.benchOpen) open(now.benchOpen ? 'bench' : sheet === 'bench' ? null : sheet);
    if (now.source !== before.source) open(now.source ? 'source' : sheet === 'source' ? null : sheet);
  });
  store.subscribe(({ reason }) => {
    if (reason === 'open') open(null);
  });
  open(null);
  return { element, open };
}
