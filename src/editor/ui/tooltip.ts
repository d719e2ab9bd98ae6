/** One tooltip for the page: shows `data-tip` of what the pointer rests on or the keyboard focuses. */
import { h } from './dom.ts';

const DELAY_MS = 350;

export function installTooltip(): void {
  const tip = h('div', { class: 'tooltip', role: 'tooltip', hidden: true });
  document.body.append(tip);
  let timer = 0;
  let current: HTMLElement | null = null;

  const hide = () => {
    clearTimeout(timer);
    current = null;
    tip.hidden = true;
  };
  const show = (target: HTMLElement) => {
    tip.textContent = target.dataset.tip ?? '';
    tip.hidden = false;
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
  document.addEventListener('pointerdown', hide, true);
  document.addEventListener('keydown', hide, true);
  document.addEventListener('wheel', hide, { passive: true });
}
