/**
 * The tour: a card beside each thing that it points at. Nothing is blocked, so that all of it can be tried; by keyboard
 * the arrows go on and back, and Escape ends it.
 */
import { t } from '../language/language.ts';
import { nextTask } from '../next-task.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { settle } from './invitation.ts';
import { type TourStep, tourSteps } from './steps.ts';

const GAP = 12;
let end: (() => void) | null = null;

export function startTour(session: Session): void {
  end?.();
  settle();
  const before = document.activeElement;
  const steps = tourSteps(session);
  let at = 0;
  let target: HTMLElement | null = null;

  const title = h('h2', { id: 'tour-title' });
  const text = h('p', { id: 'tour-text' });
  const count = h('span', { class: 'tour-count' });
  const back = h('button', { type: 'button', class: 'text-button' }, t('Back'));
  const next = h('button', { type: 'button', class: 'text-button primary' });
  const close = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('End the tour') },
    icon('close'),
  );
  const ring = h('div', { class: 'tour-ring', 'aria-hidden': 'true' });
  const card = h(
    'div',
    {
      class: 'tour-card',
      role: 'dialog',
      'aria-labelledby': title.id,
      'aria-describedby': text.id,
    },
    h('header', {}, title, close),
    text,
    h('footer', {}, count, back, next),
  );

  const show = (index: number, step: 1 | -1) => {
    const found = seen(steps, index, step);
    if (!found) {
      if (step === 1) finish();
      return;
    }
    at = found.index;
    const { title: name, text: words } = steps[at] as TourStep;
    title.textContent = name;
    text.textContent = words;
    count.textContent = t('{step} of {steps}', { step: at + 1, steps: steps.length });
    back.disabled = at === 0;
    next.textContent = at === steps.length - 1 ? t('Done') : t('Next');
    pointAt(found.target);
    next.focus({ preventScroll: true });
    // What prepare() asks for comes in a task of its own, in the place of what was there.
    void nextTask().then(() => {
      const there = end === finish && target?.isConnected === false && seen(steps, at, step);
      if (there) pointAt(there.target);
    });
  };
  const pointAt = (element: HTMLElement) => {
    target = element;
    element.scrollIntoView({ block: 'nearest' });
    place();
  };
  const place = () => target && put(card, ring, target.getBoundingClientRect());
  const onKey = (event: KeyboardEvent) => {
    if (event.key === 'Escape') finish();
    else if (!card.contains(document.activeElement)) return;
    else if (event.key === 'ArrowRight') show(at + 1, 1);
    else if (event.key === 'ArrowLeft') show(at - 1, -1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const finish = () => {
    end = null;
    observer.disconnect();
    document.removeEventListener('keydown', onKey, true);
    ring.remove();
    card.remove();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  };
  end = finish;
  back.addEventListener('click', () => show(at - 1, -1));
  next.addEventListener('click', () => show(at + 1, 1));
  close.addEventListener('click', finish);
  document.addEventListener('keydown', onKey, true);
  // Panels open, fold and change their sizes while the tour is there.
  const observer = new ResizeObserver(place);
  observer.observe(document.body);
  for (const panel of document.querySelectorAll('#app > *')) observer.observe(panel);
  document.body.append(ring, card);
  show(0, 1);
}

/** The first step from an index whose target is seen. */
function seen(
  steps: readonly TourStep[],
  from: number,
  step: 1 | -1,
): { index: number; target: HTMLElement } | null {
  for (let index = from; index >= 0 && index < steps.length; index += step) {
    const { targets, prepare } = steps[index] as TourStep;
    prepare?.();
    const target = targets
      .map((selector) => document.querySelector<HTMLElement>(selector))
      .find((element) => element?.checkVisibility());
    if (target) return { index, target };
  }
  return null;
}

/** Of the card's upper left corner, in CSS pixels. */
type Place = readonly [x: number, y: number];

/** The card goes where there is room: beside the thing, below or above it, or over its lower edge. */
function put(card: HTMLElement, ring: HTMLElement, at: DOMRect): void {
  ring.style.left = `${at.left}px`;
  ring.style.top = `${at.top}px`;
  ring.style.width = `${at.width}px`;
  ring.style.height = `${at.height}px`;
  const { width, height } = card.getBoundingClientRect();
  const middle = at.top + Math.min(at.height, innerHeight) / 2 - height / 2;
  const start = at.left + at.width / 2 - width / 2;
  const beside: Place[] = [
    [at.right + GAP, middle],
    [at.left - GAP - width, middle],
  ];
  const below: Place = [start, at.bottom + GAP];
  const above: Place = [start, at.top - GAP - height];
  const isInBar = at.bottom < height;
  const places = isInBar ? [below, ...beside] : [...beside, below, above];
  // Half of it may have to be pulled back into the window.
  const fits = ([x, y]: Place) =>
    (isInBar || (x >= GAP && x + width <= innerWidth - GAP)) &&
    y >= -height / 2 &&
    y + height / 2 <= innerHeight;
  const [x, y] = places.find(fits) ?? [start, at.bottom - height - 4 * GAP];
  card.style.left = `${Math.max(GAP, Math.min(x, innerWidth - width - GAP))}px`;
  card.style.top = `${Math.max(GAP, Math.min(y, innerHeight - height - GAP))}px`;
}
