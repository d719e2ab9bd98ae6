/** The command palette: whatever can be done, and whatever is in the scene, by typing some of its letters. */
import { plural, t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { findItems, type PaletteItem, paletteItems } from './items.ts';

const MOST_SHOWN = 60;

export function openPalette(session: Session): void {
  const items = paletteItems(session);
  let found: readonly PaletteItem[] = [];
  let at = 0;

  const input = h('input', {
    type: 'text',
    role: 'combobox',
    placeholder: t('Type what you want to do or find'),
    'aria-label': t('Command palette'),
    'aria-controls': 'palette-list',
    'aria-expanded': 'true',
    'aria-autocomplete': 'list',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const list = h('div', {
    class: 'palette-list',
    id: 'palette-list',
    role: 'listbox',
    'aria-label': t('Found'),
  });
  const count = h('span', { class: 'visually-hidden', role: 'status' });
  const dialog = h(
    'dialog',
    { class: 'palette', 'aria-label': t('Command palette') },
    h('div', { class: 'palette-search' }, icon('search'), input),
    list,
    count,
  );

  const show = () => {
    found = findItems(items, input.value, MOST_SHOWN);
    at = 0;
    list.replaceChildren(
      ...(found.length > 0 ? found.map(option) : [h('p', { class: 'hint' }, t('Nothing is called that.'))]),
    );
    list.scrollTop = 0;
    count.textContent = plural(found.length, '{count} found', '{count} found');
    mark();
  };
  const option = (item: PaletteItem, index: number) => {
    const element = h(
      'div',
      {
        class: 'palette-item',
        role: 'option',
        id: `palette-${index}`,
        'aria-disabled': String(item.disabled ?? false),
      },
      item.icon ? icon(item.icon) : h('span', { class: 'icon' }),
      h('span', { class: 'palette-title' }, item.title),
      h('span', { class: 'palette-kind' }, item.kind),
      item.shortcut ? h('kbd', {}, item.shortcut) : null,
    );
    element.addEventListener('click', () => run(item));
    element.addEventListener('pointermove', () => {
      if (at !== index) mark(index);
    });
    return element;
  };
  const mark = (index = at, reveal = false) => {
    at = index;
    [...list.children].forEach((element, i) => {
      element.setAttribute('aria-selected', String(i === at));
      if (i === at && reveal) element.scrollIntoView({ block: 'nearest' });
    });
    if (found[at]) input.setAttribute('aria-activedescendant', `palette-${at}`);
    else input.removeAttribute('aria-activedescendant');
  };
  const run = (item: PaletteItem) => {
    if (item.disabled) return;
    // First: what opens a dialog of its own must find none.
    dialog.close();
    // Its event comes only later, when another palette may be open.
    dialog.remove();
    item.run();
  };

  input.addEventListener('input', show);
  input.addEventListener('keydown', (event) => {
    const last = found.length - 1;
    const to: Readonly<Record<string, number>> = {
      ArrowDown: at < last ? at + 1 : 0,
      ArrowUp: at > 0 ? at - 1 : last,
      PageDown: Math.min(last, at + 8),
      PageUp: Math.max(0, at - 8),
    };
    const next = to[event.key];
    const item = found[at];
    if (next !== undefined) mark(Math.max(0, next), true);
    else if (event.key === 'Enter' && !event.isComposing && item) run(item);
    else return;
    event.preventDefault();
  });
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  show();
  input.focus();
}
