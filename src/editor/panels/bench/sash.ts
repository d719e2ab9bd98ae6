/** The upper edge of the dock: drag it, or move it with the arrow keys. */

import { t } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';

const LEAST = 180;
/** What the viewport above keeps. */
const VIEWPORT = 120;
const STEP = 24;

export function clampHeight(height: number): number {
  return Math.round(Math.max(LEAST, Math.min(height, innerHeight - VIEWPORT - 140)));
}

export function createSash(height: () => number, change: (height: number) => void): HTMLElement {
  const sash = h('div', {
    class: 'bench-sash',
    role: 'separator',
    tabindex: 0,
    'aria-orientation': 'horizontal',
    'aria-valuemin': LEAST,
    'aria-label': t('Height of the bench'),
  });
  sash.addEventListener('pointerdown', (event) => {
    sash.setPointerCapture(event.pointerId);
    const [from, began] = [event.clientY, height()];
    const move = (now: PointerEvent) => change(clampHeight(began + from - now.clientY));
    sash.addEventListener('pointermove', move);
    sash.addEventListener('lostpointercapture', () => sash.removeEventListener('pointermove', move), {
      once: true,
    });
  });
  sash.addEventListener('keydown', (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!direction) return;
    event.preventDefault();
    change(clampHeight(height() + direction * STEP));
  });
  return sash;
}
