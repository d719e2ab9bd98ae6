/** What clicks and keys in the outliner select. */
import { keyOf, memberCounts, membersOf } from '../../../scene/groups.ts';
import type { Document } from '../../../scene/schema.ts';
import type { Entity } from '../../state.ts';
import { entityKey, type RowTarget, type TreeRow } from './tree.ts';

/** The objects, lights and materials that a row stands for: of a group, all that is in it. */
export function entitiesOf(document: Document, target: RowTarget): readonly Entity[] {
  if (target.type === 'entity') return [target.entity];
  return target.type === 'group' ? membersOf(document, target.id) : [];
}

/** Everything from one row to another, those of the other one last. */
export function between(document: Document, rows: readonly TreeRow[], from: number, to: number): Entity[] {
  const between = rows.slice(Math.min(from, to), Math.max(from, to) + 1);
  return union(
    [],
    (from <= to ? between : between.reverse()).flatMap(({ target }) => entitiesOf(document, target)),
  );
}

/** All of both, each once, those of the second one last. */
export function union(a: readonly Entity[], b: readonly Entity[]): Entity[] {
  const found = new Map<string, Entity>();
  for (const entity of [...a, ...b]) {
    // Where it was named last counts.
    found.delete(keyOf(entity));
    found.set(keyOf(entity), entity);
  }
  return [...found.values()];
}

/** Takes all of `b` away from `a` where it is all there; else adds it. */
export function toggled(a: readonly Entity[], b: readonly Entity[]): Entity[] {
  const [had, taken] = [new Set(a.map(entityKey)), new Set(b.map(entityKey))];
  const all = b.length > 0 && b.every((entity) => had.has(entityKey(entity)));
  return all ? a.filter((entity) => !taken.has(entityKey(entity))) : union(a, b);
}

/** How much of what a row stands for is selected. */
export type Chosen = 'all' | 'some' | 'none';

export function chosenIn(document: Document, selected: readonly Entity[]): (target: RowTarget) => Chosen {
  const keys = new Set(selected.map(keyOf));
  const inGroups = () => ({
    all: memberCounts(document),
    chosen: memberCounts(document, (ref) => keys.has(keyOf(ref))),
  });
  let counts: ReturnType<typeof inGroups> | undefined;
  return (target) => {
    switch (target.type) {
      case 'scene':
        return keys.size === 0 ? 'all' : 'none';
      case 'section':
        return 'none';
      case 'entity':
        return keys.has(keyOf(target.entity)) ? 'all' : 'none';
      case 'group': {
        counts ??= inGroups();
        const chosen = counts.chosen.get(target.id) ?? 0;
        if (chosen === 0) return 'none';
        return chosen === counts.all.get(target.id) ? 'all' : 'some';
      }
    }
  };
}
