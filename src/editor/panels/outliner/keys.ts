/** The keys of the outliner, as in any tree: up, down, home, end, left, right, space. */
import type { TreeRow } from './tree.ts';

export type TreeMove =
  /** To a row: alone, adding all between, or without selecting. */
  | { readonly to: number; readonly how: 'select' | 'extend' | 'walk' }
  | { readonly fold: boolean }
  | 'choose'
  | 'toggle';

/** What a key does at a row; null where it does nothing. */
export function treeMove(event: KeyboardEvent, rows: readonly TreeRow[], at: number): TreeMove | null {
  const { key, altKey } = event;
  const held = event.ctrlKey || event.metaKey;
  if (altKey) return null;
  const how = event.shiftKey ? 'extend' : held ? 'walk' : 'select';
  const to = (index: number): TreeMove | null => (rows[index] && index !== at ? { to: index, how } : null);
  const row = rows[at];
  switch (key) {
    case 'ArrowDown':
      return to(at + 1);
    case 'ArrowUp':
      return to(at - 1);
    case 'Home':
      return to(0);
    case 'End':
      return to(rows.length - 1);
    case 'ArrowRight':
      if (row?.expanded === false) return { fold: false };
      return row?.expanded ? to(at + 1) : null;
    case 'ArrowLeft':
      if (row?.expanded) return { fold: true };
      return to(parentOf(rows, at));
    case ' ':
      return held ? 'toggle' : 'choose';
    case 'Enter':
      return held ? null : 'choose';
    default:
      return null;
  }
}

function parentOf(rows: readonly TreeRow[], at: number): number {
  const level = rows[at]?.level ?? 1;
  return rows.findLastIndex((row, i) => i < at && row.level < level);
}
