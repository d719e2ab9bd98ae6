/**
 * Shows a long list of rows of one height by the rows that are near what is seen. The list is as high as all of
 * them, so that the browser scrolls it; a hundred rows are all there, for finding in the page and for tests.
 */
import { h } from '../../ui/dom.ts';

/** Rows beyond what is seen that are there, too, above and below. */
const OVERSCAN = 40;
/** The window moves in steps of so many rows. */
const STEP = 20;

export interface RowWindow {
  readonly element: HTMLElement;
  /** So many rows there are from now on; draws those that are near. */
  update(count: number): void;
  reveal(index: number): void;
  readonly rowHeight: number;
}

/** @param draw puts rows `first` to `last` (which is not among them) into the list, in their order */
export function createWindow(
  list: HTMLElement,
  rowHeight: number,
  draw: (first: number, last: number) => void,
): RowWindow {
  const element = h('div', { class: 'outliner-scroll' }, list);
  let count = 0;
  let drawn = '';
  const range = (): [number, number] => {
    const first = Math.floor(element.scrollTop / rowHeight / STEP) * STEP - OVERSCAN;
    const seen = Math.ceil(element.clientHeight / rowHeight) + STEP;
    return [Math.max(0, first), Math.min(count, first + seen + 2 * OVERSCAN)];
  };
  element.addEventListener(
    'scroll',
    () => {
      const [first, last] = range();
      if (`${first} ${last}` === drawn) return;
      drawn = `${first} ${last}`;
      draw(first, last);
    },
    { passive: true },
  );
  return {
    element,
    rowHeight,
    update(next) {
      count = next;
      list.style.height = `${count * rowHeight}px`;
      const [first, last] = range();
      drawn = `${first} ${last}`;
      draw(first, last);
    },
    reveal(index) {
      const top = index * rowHeight;
      const { scrollTop, clientHeight } = element;
      if (top < scrollTop) element.scrollTop = top;
      else if (top + rowHeight > scrollTop + clientHeight) element.scrollTop = top + rowHeight - clientHeight;
    },
  };
}
