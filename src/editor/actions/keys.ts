/** Keys as people write them, `Ctrl+Shift+Z`, and as the browser reports them. */

/** The keys of an event, written with the modifiers in the order Ctrl, Alt, Shift. Cmd counts as Ctrl. */
export function keysOf(event: KeyboardEvent): string {
  const name = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toUpperCase() : event.key;
  // Shift is part of a sign such as ?, but not of a letter.
  const signs = event.key.length === 1 && event.key.toLowerCase() === event.key.toUpperCase();
  const modifiers = [
    (event.ctrlKey || event.metaKey) && 'Ctrl',
    event.altKey && 'Alt',
    event.shiftKey && !(signs && !/\d/.test(event.key)) && 'Shift',
  ];
  return [...modifiers.filter(Boolean), name].join('+');
}
