/** One row of the outliner. What it stands for is told by its key; the outliner hears its clicks. */
import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { icon, setIcon } from '../../ui/icons.ts';
import type { Chosen } from './selecting.ts';
import type { TreeRow } from './tree.ts';

/** What a click on a row can mean. */
export type RowPart = 'row' | 'twisty' | 'eye' | 'lock';

export interface OutlinerRow {
  readonly element: HTMLElement;
  show(row: TreeRow, chosen: Chosen, isCurrent: boolean): void;
  /** Opens the name for typing; calls back with the new one, or null. */
  rename(onDone: (name: string | null) => void): void;
}

const ID_START = 'outliner-';
export const rowId = (key: string): string => `${ID_START}${key}`;
export const keyOfRow = (row: Element): string => row.id.slice(ID_START.length);

/** The part of a row that an event happened on. */
export function partOf(event: Event): RowPart {
  const target = event.target instanceof Element ? event.target : null;
  if (target?.closest('.twisty')) return 'twisty';
  if (target?.closest('.eye')) return 'eye';
  return target?.closest('.lock') ? 'lock' : 'row';
}

export function createRow(key: string): OutlinerRow {
  const twisty = h('span', { class: 'twisty' }, icon('chevronDown'));
  const symbol = icon('mesh');
  const label = h('span', { class: 'name' });
  const count = h('span', { class: 'count' });
  const button = (name: 'lock' | 'eye') =>
    h('button', { type: 'button', class: `icon-button ${name}`, tabindex: -1 }, icon(name));
  const [lock, eye] = [button('lock'), button('eye')];
  const element = h(
    'div',
    { class: 'outliner-row', role: 'treeitem', id: rowId(key) },
    twisty,
    symbol,
    label,
    count,
    lock,
    eye,
  );

  return {
    element,
    show(row, chosen, isCurrent) {
      const { name, target, level, visible, locked } = row;
      if (label.textContent !== name) label.textContent = name;
      label.title = name;
      element.style.setProperty('--level', String(Math.min(level, MAX_INDENT)));
      element.classList.toggle('section-row', target.type === 'section');
      element.classList.toggle('scene-row', target.type === 'scene');
      if (target.type === 'entity') element.dataset.entity = key;
      element.draggable = target.type === 'entity' || (target.type === 'group' && visible !== null);
      if (target.type === 'group') element.dataset.group = target.id;
      symbol.toggleAttribute('hidden', row.icon === null);
      if (row.icon) setIcon(symbol, row.icon);
      twisty.classList.toggle('leaf', row.expanded === null);
      twisty.classList.toggle('folded', row.expanded === false);
      count.textContent = row.count === null ? '' : String(row.count);
      eye.hidden = visible === null;
      lock.hidden = locked === null;
      setIcon(eye, visible ? 'eye' : 'eyeOff');
      setIcon(lock, locked ? 'lock' : 'lockOpen');
      eye.setAttribute('aria-label', visible ? t('Hide {name}', { name }) : t('Show {name}', { name }));
      lock.setAttribute('aria-label', locked ? t('Unlock {name}', { name }) : t('Lock {name}', { name }));
      element.classList.toggle('invisible', visible === false);
      element.classList.toggle('locked', locked === true);
      element.classList.toggle('selected', chosen === 'all');
      element.classList.toggle('partly', chosen === 'some');
      element.classList.toggle('current', isCurrent);
      for (const [attribute, value] of [
        ['aria-level', level],
        ['aria-posinset', row.position],
        ['aria-setsize', row.siblings],
        ['aria-selected', target.type === 'section' ? null : chosen === 'all'],
        ['aria-expanded', row.expanded],
      ] as const) {
        if (value === null) element.removeAttribute(attribute);
        else element.setAttribute(attribute, String(value));
      }
    },
    rename(onDone) {
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
        onDone(keep ? input.value.trim() || null : null);
      };
      input.addEventListener('blur', () => close(true));
      input.addEventListener('keydown', (event) => {
        event.stopPropagation();
        if (event.key === 'Enter' || event.key === 'Escape') close(event.key === 'Enter');
      });
    },
  };
}

/** Deeper rows would have no room for their names. */
const MAX_INDENT = 9;
