/**
 * One tooltip for the page: shows `data-tip` of what the pointer rests on, a finger holds or the keyboard
 * focuses, and the keys of the action that `data-keys` names.
 */
import { h } from './dom.ts';
import { isKeyboardOn } from './focus.ts';

const DELAY_MS = 350;
/** How long it stays after a finger has let go. */
const TOUCH_LIFE_MS = 2500;

/** @param shortcut the keys of an action, if it has any */
export function installTooltip(shortcut: (action: string) => string | undefined): void {
  const tip = h('div', { class: 'tooltip', role: 'tooltip', id: 'tooltip', hidden: true });
  document.body.append(tip);
  let timer = 0;
  let current: HTMLElement | null = null;

  const hide = () => {
    clearTimeout(timer);
    current?.removeAttribute('aria-describedby');
    current = null;
    tip.hidden = true;
  };
  const show = (target: HTMLElement) => {
    const keys = target.dataset.keys && shortcut(target.dataset.keys);
    tip.textContent = `${target.dataset.tip ?? ''}${keys ? `  (${keys})` : ''}`;
    // Nothing outside an open dialog is above it.
    (target.closest('dialog') ?? document.body).append(tip);
    tip.hidden = false;
    target.setAttribute('aria-describedby', tip.id);
    const box = target.getBoundingClientRect();
    const own = tip.getBoundingClientRect();
    const left = Math.min(Math.max(6, box.left), innerWidth - own.width - 6);
    const below = box.bottom + 6;
    tip.style.left = `${left}px`;
    tip.style.top = `${below + own.height < innerHeight ? below : box.top - own.height - 6}px`;
  };
  const wait = (event: Event) => {
    const target = event.target instanceof Element ? event.target.closest<HTMLElement>('[data-tip]') : null;
    if (target === current) return;
    hide();
    if (!target?.dataset.tip) return;
    current = target;
    timer = window.setTimeout(() => {
      if (target.isConnected) show(target);
    }, DELAY_MS);
  };
  document.addEventListener('pointerover', wait);
  document.addEventListener('focusin', (event) => {
    if (event.target instanceof Element && isKeyboardOn(event.target)) wait(event);
  });
  document.addEventListener('focusout', hide);
  document.addEventListener('pointerdown', (event) => event.pointerType !== 'touch' && hide(), true);
  document.addEventListener('pointerup', (event) => {
    if (event.pointerType !== 'touch') return;
    if (tip.hidden) hide();
    else timer = window.setTimeout(hide, TOUCH_LIFE_MS);
  });
  document.addEventListener('keydown', hide, true);
  document.addEventListener('wheel', hide, { passive: true });
}
