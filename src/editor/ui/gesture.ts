/**
 * A gesture is what a person feels as one action: a drag of a slider, a stroke in the colour
 * picker. Every change within it carries the gesture's key, which the document store takes as
 * the merge key, so that one undo takes back the whole drag. Without a key a change stands alone.
 */
export type Gesture = string | undefined;

let count = 0;

export function newGesture(): string {
  count += 1;
  return `gesture-${count}`;
}

const CANCELLED = 'irradia-gesture-cancelled';

/** Escape: what the gesture has changed is to be taken back. Its field tells; who has the document listens. */
export function cancelGesture(field: HTMLElement, gesture: string): void {
  field.dispatchEvent(new CustomEvent(CANCELLED, { bubbles: true, detail: gesture }));
}

export function onCancelledGesture(takeBack: (gesture: string) => void): void {
  document.addEventListener(CANCELLED, (event) => {
    if (event instanceof CustomEvent && typeof event.detail === 'string') takeBack(event.detail);
  });
}
