/** Where the keyboard is, and where it can go. */

const FOCUSABLE =
  'a[href], button, input, select, textarea, summary, canvas[tabindex], [contenteditable], [tabindex]';

/** What Tab reaches within an element, in the order of the page. */
export function tabStops(within: Element): HTMLElement[] {
  return [...within.querySelectorAll<HTMLElement>(FOCUSABLE)].filter(
    (element) =>
      element.tabIndex >= 0 && !element.matches(':disabled, [inert] *') && element.checkVisibility(),
  );
}

/** Keeps Tab within an element: after the last comes the first. */
export function keepTabWithin(element: HTMLElement): void {
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Tab') return;
    const stops = tabStops(element);
    const at = document.activeElement;
    const [first, last] = [stops[0], stops.at(-1)];
    const onward = event.shiftKey ? (at === first || at === element) && last : at === last && first;
    if (!onward) return;
    event.preventDefault();
    onward.focus();
  });
}

/** Whether the person is using the keyboard on this element, as the browser judges it. */
export function isKeyboardOn(element: Element): boolean {
  return element.matches(':focus-visible');
}
