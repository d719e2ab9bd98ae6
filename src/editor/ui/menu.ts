/**
 * Drop-down menus: a button and a list of actions, made anew each time it opens. By keyboard: up and down
 * within a menu, left and right to the menus beside it, letters to the entry that begins with them.
 */
import { h } from './dom.ts';
import { type IconName, icon } from './icons.ts';
import { openPopup } from './popup.ts';

export interface MenuAction {
  label: string;
  icon?: IconName;
  shortcut?: string;
  tip?: string;
  disabled?: boolean;
  /** For what is on or off, or one of several. */
  checked?: boolean;
  run(): void;
}

export type MenuEntry = MenuAction | { heading: string } | 'separator';

/** What opens the menu of a button, for the menus beside it. */
const openers = new WeakMap<Element, () => void>();

export function menuButton(label: string, entries: () => readonly MenuEntry[]): HTMLButtonElement {
  return asMenuButton(h('button', { type: 'button', class: 'menu-button' }, label), label, entries);
}

/** Makes a button open a menu. */
export function asMenuButton(
  button: HTMLButtonElement,
  label: string,
  entries: () => readonly MenuEntry[],
): HTMLButtonElement {
  button.setAttribute('aria-haspopup', 'menu');
  const mark = (isOpen: boolean) => {
    button.classList.toggle('open', isOpen);
    button.setAttribute('aria-expanded', String(isOpen));
  };
  const open = () => {
    mark(true);
    openMenu(button, label, entries(), () => mark(false));
  };
  mark(false);
  openers.set(button, open);
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    if (!button.classList.contains('open')) open();
  });
  button.addEventListener('click', (event) => {
    // A click from the keyboard has no pointerdown before it.
    if (event.detail === 0) open();
  });
  button.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowDown' || event.key === 'ArrowUp') open();
    else if (event.key === 'ArrowLeft' || event.key === 'ArrowRight') beside(button, event.key)?.focus();
    else return;
    event.preventDefault();
  });
  return button;
}

/** The button of the next menu in a direction, round the row of menus; undefined outside such a row. */
function beside(button: Element, key: 'ArrowLeft' | 'ArrowRight'): HTMLElement | undefined {
  const row = [...(button.parentElement?.children ?? [])].filter((other) => openers.has(other));
  const at = row.indexOf(button);
  const next = row[(at + (key === 'ArrowRight' ? 1 : -1) + row.length) % row.length];
  return at >= 0 && next instanceof HTMLElement ? next : undefined;
}

export function openMenu(
  anchor: HTMLElement,
  label: string,
  entries: readonly MenuEntry[],
  onClose?: () => void,
): void {
  const list = h('div', { class: 'menu', role: 'menu', 'aria-label': label });
  const close = openPopup({ anchor, content: list, label, role: 'none', ...(onClose && { onClose }) });
  for (const entry of entries) {
    if (entry === 'separator') list.append(h('hr'));
    else if ('heading' in entry) list.append(h('div', { class: 'menu-heading' }, entry.heading));
    else list.append(menuItem(entry, close));
  }
  list.addEventListener('keydown', (event) => onMenuKey(event, list, anchor, close));
  keepInside(list.parentElement);
  list.querySelector<HTMLButtonElement>('button:not(:disabled)')?.focus({ preventScroll: true });
}

function menuItem(entry: MenuAction, close: () => void): HTMLElement {
  const isChoice = entry.checked !== undefined;
  const mark = entry.checked ? icon('check') : entry.icon ? icon(entry.icon) : h('span', { class: 'icon' });
  const item = h(
    'button',
    {
      type: 'button',
      role: isChoice ? 'menuitemcheckbox' : 'menuitem',
      tabindex: -1,
      disabled: entry.disabled,
      tip: entry.tip,
      ...(isChoice && { 'aria-checked': String(entry.checked) }),
    },
    mark,
    h('span', { class: 'menu-label' }, entry.label),
    entry.shortcut ? h('kbd', {}, entry.shortcut) : null,
  );
  item.addEventListener('click', (event) => {
    // The focus goes back to the anchor for those who are there by keyboard alone.
    if (event.detail !== 0) item.blur();
    close();
    entry.run();
  });
  return item;
}

function onMenuKey(event: KeyboardEvent, list: HTMLElement, anchor: HTMLElement, close: () => void): void {
  const { key } = event;
  if (key === 'Tab') {
    // The browser goes on from where the menu came from.
    close();
    event.stopPropagation();
    return;
  }
  if (key === 'ArrowLeft' || key === 'ArrowRight') {
    const next = beside(anchor, key);
    const open = next && openers.get(next);
    if (!open) return;
    event.preventDefault();
    close();
    open();
    return;
  }
  const items = [...list.querySelectorAll<HTMLElement>('button:not(:disabled)')];
  const at = document.activeElement instanceof HTMLElement ? items.indexOf(document.activeElement) : -1;
  const item = itemFor(key, items, at);
  if (!item || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  item.focus();
}

function itemFor(key: string, items: readonly HTMLElement[], at: number): HTMLElement | undefined {
  if (key === 'ArrowDown') return items[(at + 1) % items.length];
  if (key === 'ArrowUp') return items[(Math.max(at, 0) - 1 + items.length) % items.length];
  if (key === 'Home') return items[0];
  if (key === 'End') return items.at(-1);
  if (key.length !== 1 || key === ' ') return undefined;
  // Round from the one that has the focus, so that the same letter leads to each of its entries.
  const round = [...items.slice(at + 1), ...items.slice(0, at + 1)];
  return round.find((item) => labelOf(item).startsWith(key.toLocaleLowerCase()));
}

function labelOf(item: HTMLElement): string {
  return item.querySelector('.menu-label')?.textContent?.toLocaleLowerCase() ?? '';
}

/** The popup was placed while still empty; now that it is full, pull it back into the window. */
function keepInside(popup: HTMLElement | null): void {
  if (!popup) return;
  const box = popup.getBoundingClientRect();
  if (box.right > innerWidth - 6) popup.style.left = `${Math.max(6, innerWidth - box.width - 6)}px`;
  if (box.bottom > innerHeight - 6) popup.style.top = `${Math.max(6, innerHeight - box.height - 6)}px`;
}
