/** A line between two pictures: drag it, or move it with the arrow keys. */
import { h } from './dom.ts';

const STEP = 0.02;
const LARGE_STEP = 0.1;

export interface SplitLine {
  readonly element: HTMLElement;
  /** @param part of the width that is left of it, 0..1 */
  show(part: number): void;
}

/** Its parent is the element over which it moves, and gets `--divider`. */
export function splitLine(label: string, onMove: (part: number) => void): SplitLine {
  let part = 0.5;
  const element = h('div', {
    class: 'split-line',
    role: 'separator',
    tabindex: 0,
    'aria-orientation': 'vertical',
    'aria-label': label,
    'aria-valuemin': 0,
    'aria-valuemax': 100,
  });
  const move = (to: number) => onMove(Math.min(1, Math.max(0, to)));
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    const drag = (now: PointerEvent) => {
      const box = element.parentElement?.getBoundingClientRect();
      if (box) move((now.clientX - box.left) / box.width);
    };
    element.addEventListener('pointermove', drag);
    element.addEventListener('lostpointercapture', () => element.removeEventListener('pointermove', drag), {
      once: true,
    });
  });
  element.addEventListener('dblclick', () => move(0.5));
  element.addEventListener('keydown', (event) => {
    const step = event.shiftKey ? LARGE_STEP : STEP;
    const to = { ArrowLeft: part - step, ArrowRight: part + step, Home: 0, End: 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    // The page has its own meaning for no key that moves the divider.
    event.stopPropagation();
    move(to);
  });
  return {
    element,
    show(now) {
      part = now;
      element.parentElement?.style.setProperty('--divider', `${100 * part}%`);
      element.setAttribute('aria-valuenow', String(Math.round(100 * part)));
    },
  };
}
