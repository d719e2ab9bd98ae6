/** The line between the two renderings: drag it, or move it with the arrow keys. */

import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import type { PathTracing } from './path-tracing.ts';

const STEP = 0.02;
const LARGE_STEP = 0.1;

export function createDivider({ state }: Session, tracing: PathTracing): HTMLElement {
  const line = h('div', {
    class: 'split-line',
    role: 'separator',
    tabindex: 0,
    'aria-orientation': 'vertical',
    'aria-label': t('Divider between the interactive and the path traced picture'),
    'aria-valuemin': 0,
    'aria-valuemax': 100,
  });
  const right = h('span', { class: 'split-label right' });
  const element = h(
    'div',
    { class: 'split', hidden: true },
    h('span', { class: 'split-label left' }, t('Interactive')),
    right,
    line,
  );
  const move = (divider: number) => state.set({ divider: Math.min(1, Math.max(0, divider)) });

  line.addEventListener('pointerdown', (event) => {
    line.setPointerCapture(event.pointerId);
    const drag = (now: PointerEvent) => {
      const { left, width } = element.getBoundingClientRect();
      move((now.clientX - left) / width);
    };
    line.addEventListener('pointermove', drag);
    line.addEventListener('lostpointercapture', () => line.removeEventListener('pointermove', drag), {
      once: true,
    });
  });
  line.addEventListener('dblclick', () => move(0.5));
  line.addEventListener('keydown', (event) => {
    const { divider } = state.value;
    const step = event.shiftKey ? LARGE_STEP : STEP;
    const to = { ArrowLeft: divider - step, ArrowRight: divider + step, Home: 0, End: 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    // The page has its own meaning for no key that moves the divider.
    event.stopPropagation();
    move(to);
  });

  const show = () => {
    const { rendering, divider } = state.value;
    element.hidden = rendering !== 'split';
    element.style.setProperty('--divider', `${100 * divider}%`);
    line.setAttribute('aria-valuenow', String(Math.round(100 * divider)));
    right.textContent = tracing.texture ? t('Path traced') : t('Path traced: not yet');
  };
  state.subscribe((now, before) => {
    if (now.rendering !== before.rendering || now.divider !== before.divider) show();
  });
  tracing.subscribe(show);
  show();
  return element;
}
