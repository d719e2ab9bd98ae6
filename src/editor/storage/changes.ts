/**
 * What an edit changed, so that keeping it costs what it touched and not what the scene has. Documents
 * share what did not change, so the comparison is of identities.
 */
import { type Collection, collections, type Single, singles } from '../../scene/schema.ts';
import type { StoredDocument } from './stored-document.ts';

export interface Change {
  /** Parts that a document has once, whole. */
  readonly singles?: Readonly<Partial<Record<Single, unknown>>>;
  /** By collection and id; null is for what has gone. */
  readonly entities?: Readonly<Partial<Record<Collection, Readonly<Record<string, unknown>>>>>;
  /** The ids of a collection, where they are not those of before with the new ones behind them. */
  readonly order?: Readonly<Partial<Record<Collection, readonly string[]>>>;
}

/** What the two have in common by identity, they have in common. Assets are compared by their hashes. */
export function changeBetween(before: StoredDocument, after: StoredDocument): Change | null {
  const changedSingles: Partial<Record<Single, unknown>> = {};
  const entities: Partial<Record<Collection, Record<string, unknown>>> = {};
  const order: Partial<Record<Collection, string[]>> = {};
  for (const name of singles) if (before[name] !== after[name]) changedSingles[name] = after[name];
  for (const name of collections) {
    const [old, now] = [before[name], after[name]];
    if (old === now) continue;
    const changed: Record<string, unknown> = {};
    for (const [id, entity] of Object.entries(now)) if (entity !== old[id]) changed[id] = entity;
    for (const id of Object.keys(old)) if (!Object.hasOwn(now, id)) changed[id] = null;
    if (Object.keys(changed).length > 0) entities[name] = changed;
    const ids = Object.keys(now);
    const expected = Object.keys(withEntities(old, changed));
    if (ids.some((id, i) => id !== expected[i])) order[name] = ids;
  }
  const change = { singles: changedSingles, entities, order };
  return Object.values(change).some((part) => Object.keys(part).length > 0) ? change : null;
}

/** The plain JSON of a document with a change made to it. */
export function applyChange(json: Record<string, unknown>, change: Change): Record<string, unknown> {
  const next: Record<string, unknown> = { ...json, ...change.singles };
  for (const name of collections) {
    const old = (next[name] ?? {}) as Record<string, unknown>;
    const entities = withEntities(old, change.entities?.[name] ?? {});
    const order = change.order?.[name];
    next[name] = order ? Object.fromEntries(order.map((id) => [id, entities[id]])) : entities;
  }
  return next;
}

function withEntities(
  old: Readonly<Record<string, unknown>>,
  changed: Readonly<Record<string, unknown>>,
): Record<string, unknown> {
  const next = { ...old };
  for (const [id, entity] of Object.entries(changed)) {
    if (entity === null) delete next[id];
    else next[id] = entity;
  }
  return next;
}
