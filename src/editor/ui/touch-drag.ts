/**
 * Whatever can be dragged by the mouse can be dragged by a finger that has rested on it: rows of the outliner, materials of the
 * library. Browsers differ in whether they say so by themselves; here one and the same events are made for all of them, so that
 * what listens to the mouse's drags needs not know of fingers. A finger that lifts without having moved asks for the menu.
 */

/** A finger that has rested so long holds what it is on. */
const HOLD_MS = 400;
/** CSS pixels: a finger that has moved further before scrolls, and after drags. */
const STILL_PX = 8;

interface Touched {
  readonly pointerId: number;
  readonly source: HTMLElement;
  readonly start: PointerEvent;
  readonly timer: number;
  held: boolean;
  data: DataTransfer | null;
  over: Element | null;
  picture: HTMLElement | null;
}

export function installTouchDrag(): void {
  let touched: Touched | null = null;

  const send = (
    type: string,
    to: EventTarget,
    { clientX, clientY }: PointerEvent,
    related?: Element | null,
  ): boolean => {
    if (!touched) return false;
    const event = new DragEvent(type, {
      bubbles: true,
      cancelable: true,
      composed: true,
      clientX,
      clientY,
      dataTransfer: touched.data,
      relatedTarget: related ?? null,
    });
    to.dispatchEvent(event);
    return event.defaultPrevented;
  };
  const move = (event: PointerEvent) => {
    if (!touched || event.pointerId !== touched.pointerId) return;
    const { start, source } = touched;
    const way = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
    if (!touched.held) {
      if (way > STILL_PX) end();
      return;
    }
    if (touched.data === null) {
      if (way <= STILL_PX) return;
      touched.data = new DataTransfer();
      send('dragstart', source, start);
      touched.picture = pictureOf(source);
    }
    const { picture } = touched;
    if (picture) picture.style.transform = `translate(${event.clientX + 14}px, ${event.clientY - 40}px)`;
    const under = document.elementFromPoint(event.clientX, event.clientY);
    const before = touched.over;
    touched.over = under;
    if (before && before !== under) send('dragleave', before, event, under);
    if (under) send('dragover', under, event);
  };
  const up = (event: PointerEvent) => {
    if (!touched || event.pointerId !== touched.pointerId) return;
    const { data, source, over, held } = touched;
    if (held) swallow();
    if (data !== null) {
      // Where something wants it, and only there.
      if (over && send('dragover', over, event)) send('drop', over, event);
      else if (over) send('dragleave', over, event);
      send('dragend', source, event);
    } else if (held) askForMenu(source, event);
    end();
  };
  const cancel = (event: PointerEvent) => {
    if (!touched || event.pointerId !== touched.pointerId) return;
    if (touched.over) send('dragleave', touched.over, event);
    if (touched.data !== null) send('dragend', touched.source, event);
    end();
  };
  const end = () => {
    if (!touched) return;
    clearTimeout(touched.timer);
    touched.source.classList.remove('held');
    touched.picture?.remove();
    touched.source.removeEventListener('touchmove', stay);
    touched = null;
  };
  /** The list does not scroll under what is held. */
  const stay = (event: TouchEvent) => {
    if (touched?.held && event.cancelable) event.preventDefault();
  };

  document.addEventListener(
    'pointerdown',
    (event) => {
      end();
      const source =
        event.target instanceof Element ? event.target.closest<HTMLElement>('[draggable="true"]') : null;
      if (event.pointerType !== 'touch' || !event.isPrimary || !source) return;
      const timer = window.setTimeout(() => {
        if (!touched) return;
        touched.held = true;
        source.classList.add('held');
      }, HOLD_MS);
      touched = {
        ...{ pointerId: event.pointerId, source, start: event, timer, held: false },
        ...{ data: null, over: null, picture: null },
      };
      source.addEventListener('touchmove', stay, { passive: false });
    },
    true,
  );
  document.addEventListener('pointermove', move);
  document.addEventListener('pointerup', up);
  document.addEventListener('pointercancel', cancel);
  // The browser's own drag, and its own menu, are these.
  for (const type of ['dragstart', 'contextmenu'])
    document.addEventListener(
      type,
      (event) => {
        if (!touched || !event.isTrusted) return;
        event.preventDefault();
        event.stopImmediatePropagation();
      },
      true,
    );
}

function pictureOf(source: HTMLElement): HTMLElement {
  const picture = document.createElement('div');
  picture.className = 'drag-picture touch';
  picture.textContent = source.querySelector('.name')?.textContent ?? source.textContent;
  document.body.append(picture);
  return picture;
}

function askForMenu(source: HTMLElement, { clientX, clientY }: PointerEvent): void {
  const target = document.elementFromPoint(clientX, clientY) ?? source;
  target.dispatchEvent(new MouseEvent('contextmenu', { bubbles: true, cancelable: true, clientX, clientY }));
}

/** Letting go is no click. */
function swallow(): void {
  document.addEventListener('touchend', (event) => event.preventDefault(), {
    once: true,
    capture: true,
    passive: false,
  });
}
