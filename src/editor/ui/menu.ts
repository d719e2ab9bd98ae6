/** Drop-down menus: a button and a list of actions, made anew each time it opens. */
import { h } from './dom.ts';
import { type IconName, icon } from './icons.ts';
import { openPopup } from './popup.ts';

export interface MenuAction {
  label: string;
  icon?: IconName;
  shortcut?: string;
  tip?: string;
  disabled?: boolean;
  run(): void;
}

export type MenuEntry = MenuAction | { heading: string } | 'separator';

export function menuButton(label: string, entries: () => readonly MenuEntry[]): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'menu-button', 'aria-haspopup': 'menu' }, label);
  const open = () => {
    button.classList.add('open');
    openMenu(button, label, entries(), () => button.classList.remove('open'));
  };
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    if (!button.classList.contains('open')) open();
  });
  button.addEventListener('click', (event) => {
    // A click from the keyboard has no pointerdown before it.
    if (event.detail === 0) open();
  });
  return button;
}

export function openMenu(
  anchor: HTMLElement,
  label: string,
  entries: readonly MenuEntry[],
  onClose?: () => void,
): void {
  const list = h('div', { class: 'menu', role: 'menu' });
  const close = openPopup({ anchor, content: list, label, ...(onClose && { onClose }) });
  for (const entry of entries) {
    if (entry === 'separator') list.append(h('hr'));
    else if ('heading' in entry) list.append(h('div', { class: 'menu-heading' }, entry.heading));
    else {
      const item = h(
        'button',
        { type: 'button', role: 'menuitem', disabled: entry.disabled, tip: entry.tip },
        entry.icon ? icon(entry.icon) : h('span', { class: 'icon' }),
        h('span', { class: 'menu-label' }, entry.label),
        entry.shortcut ? h('kbd', {}, entry.shortcut) : null,
      );
      item.addEventListener('click', () => {
        close();
        entry.run();
      });
      list.append(item);
    }
  }
  list.addEventListener('keydown', (event) => {
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
    event.preventDefault();
    const items: Element[] = [...list.querySelectorAll('button:not(:disabled)')];
    const current = document.activeElement ? items.indexOf(document.activeElement) : -1;
    const next = event.key === 'ArrowDown' ? current + 1 : current - 1;
    const item = items[(next + items.length) % items.length];
    if (item instanceof HTMLElement) item.focus();
  });
  keepInside(list.parentElement);
  list.querySelector<HTMLButtonElement>('button:not(:disabled)')?.focus({ preventScroll: true });
}

/** The popup was placed while still empty; now that it is full, pull it back into the window. */
function keepInside(popup: HTMLElement | null): void {
  if (!popup) return;
  const box = popup.getBoundingClientRect();
  if (box.right > innerWidth - 6) popup.style.left = `${Math.max(6, innerWidth - box.width - 6)}px`;
  if (box.bottom > innerHeight - 6) popup.style.top = `${Math.max(6, innerHeight - box.height - 6)}px`;
}
