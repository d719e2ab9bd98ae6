/** Arrow keys in the grid of materials: along the row, and to what is above or below, also across sections. */

/** Moves the focus. False for keys that mean nothing here. */
export function gridMove(list: HTMLElement, { key, target }: KeyboardEvent): boolean {
  const cards = [...list.querySelectorAll<HTMLElement>('.material-card')];
  const from = cards.indexOf(target as HTMLElement);
  const card = cards[from];
  if (!card) return false;
  const next = { ArrowLeft: cards[from - 1], ArrowRight: cards[from + 1], Home: cards[0], End: cards.at(-1) }[
    key
  ];
  const found = next ?? (key === 'ArrowUp' || key === 'ArrowDown' ? vertical(cards, card, key) : null);
  if (!found) return key.startsWith('Arrow');
  found.focus();
  found.scrollIntoView({ block: 'nearest' });
  return true;
}

/** The card of the next row that is nearest to the same column. */
function vertical(
  cards: readonly HTMLElement[],
  from: HTMLElement,
  key: 'ArrowUp' | 'ArrowDown',
): HTMLElement | null {
  const { left, top } = from.getBoundingClientRect();
  const sign = key === 'ArrowDown' ? 1 : -1;
  const rest = cards
    .map((card) => ({ card, box: card.getBoundingClientRect() }))
    .map(({ card, box }) => ({ card, down: sign * (box.top - top), across: Math.abs(box.left - left) }))
    .filter(({ down }) => down > 1)
    .sort((a, b) => a.down - b.down || a.across - b.across);
  return rest[0]?.card ?? null;
}
