/** One value of many things at once: the last one's is shown, and what is set is set on all. */
import { isMember } from '../../../scene/entity.ts';
import type { Document } from '../../../scene/schema.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { type Cell, readPath, tryEdit, writePath } from './cell.ts';

/** What locked things keep. */
export const PLACEMENT: ReadonlySet<string> = new Set([
  'position',
  'rotation',
  'scale',
  'target',
  'width',
  'height',
]);

export interface ManyCell extends Cell {
  /** Whether not all of them have the same value. */
  isMixed(): boolean;
}

/** @param within the path within each entity @param fallback what an absent value means, for each of them */
export function manyCell(
  { store, state }: Session,
  within: readonly string[],
  label: string,
  fallback?: unknown,
): ManyCell {
  const pathOf = ({ kind, id }: Entity) => [kind, id, ...within];
  const valueIn = (document: Document, entity: Entity) => readPath(document, pathOf(entity)) ?? fallback;
  const get = () => {
    const { selection } = state.value;
    return selection ? valueIn(store.document, selection) : fallback;
  };
  const isPlace = PLACEMENT.has(within[0] ?? '');
  return {
    get,
    isMixed() {
      const shown = JSON.stringify(get());
      return state.value.selected.some((entity) => JSON.stringify(valueIn(store.document, entity)) !== shown);
    },
    set(value, gesture) {
      const shown = get();
      const { document } = store;
      const free = state.value.selected.filter(
        (entity) => !isPlace || !isMember(entity) || !document[entity.kind][entity.id]?.locked,
      );
      tryEdit(
        store,
        label,
        (draft) => {
          for (const entity of free)
            writePath(draft, pathOf(entity), changedParts(valueIn(document, entity), shown, value));
        },
        gesture && `many ${within.join('.')} ${gesture}`,
      );
    },
  };
}

/** Of a vector only the components that differ from what was shown: setting x leaves everybody's y. */
function changedParts(own: unknown, shown: unknown, value: unknown): unknown {
  if (!Array.isArray(own) || !Array.isArray(shown) || !Array.isArray(value)) return value;
  return value.map((part: unknown, i) => (part === shown[i] ? own[i] : part));
}
