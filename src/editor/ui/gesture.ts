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
