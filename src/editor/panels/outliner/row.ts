/** One row of the outliner. */
import { renameEntity } from '../../commands.ts';
import { t } from '../../language/language.ts';
import { toggleVisible } from '../../selection.ts';
import type { Session } from '../../session.ts';
import type { EntityKind } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { type IconName, icon, setIcon } from '../../ui/icons.ts';
import { openMenu } from '../../ui/menu.ts';
import { selectionEntries } from '../selection-menu.ts';

export interface OutlinerRow {
  readonly element: HTMLElement;
  /** `visible` is null for what cannot be hidden. */
  show(name: string, iconName: IconName, visible: boolean | null): void;
  select(selected: boolean): void;
  rename(): void;
}

export function createRow(session: Session, kind: EntityKind, id: string): OutlinerRow {
  const { store, state } = session;
  const symbol = icon('mesh');
  const label = h('span', { class: 'name' });
  const eye = h('button', { type: 'button', class: 'icon-button eye', tabindex: -1 }, icon('eye'));
  const element = h('div', { class: 'outliner-row', role: 'option', tabindex: 0 }, symbol, label, eye);
  element.dataset.entity = `${kind}/${id}`;
  let visible: boolean | null = null;

  element.addEventListener('click', () => state.select({ kind, id }));
  element.addEventListener('dblclick', (event) => {
    if (event.target !== eye && !eye.contains(event.target as Node)) rename();
  });
  element.addEventListener('contextmenu', (event) => {
    event.preventDefault();
    state.select({ kind, id });
    openMenu(label, label.textContent ?? '', selectionEntries(session));
  });
  element.addEventListener('keydown', (event) => {
    if (event.target !== element || (event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault();
    state.select({ kind, id });
  });
  eye.addEventListener('click', (event) => {
    event.stopPropagation();
    if (visible !== null && kind !== 'materials') toggleVisible(session, [{ kind, id }]);
  });

  const rename = () => {
    const input = h('input', { type: 'text', class: 'rename', 'aria-label': t('Name'), maxlength: 200 });
    input.value = label.textContent ?? '';
    label.replaceWith(input);
    input.focus();
    input.select();
    let open = true;
    const close = (keep: boolean) => {
      if (!open) return;
      open = false;
      input.replaceWith(label);
      const name = input.value.trim();
      if (keep && name) renameEntity(store, kind, id, name);
    };
    input.addEventListener('blur', () => close(true));
    input.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' || event.key === 'Escape') {
        close(event.key === 'Enter');
        element.focus();
      }
    });
  };

  return {
    element,
    show(name, iconName, nextVisible) {
      if (label.textContent !== name) label.textContent = name;
      label.title = name;
      setIcon(symbol, iconName);
      visible = nextVisible;
      eye.hidden = visible === null;
      eye.setAttribute('aria-label', visible ? t('Hide {name}', { name }) : t('Show {name}', { name }));
      setIcon(eye, visible ? 'eye' : 'eyeOff');
      element.classList.toggle('invisible', visible === false);
    },
    select(selected) {
      element.classList.toggle('selected', selected);
      element.setAttribute('aria-selected', String(selected));
    },
    rename,
  };
}
