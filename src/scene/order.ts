/**
 * The order in which things are shown, saved and exported: that of the entries of each collection. It is one for each kind:
 * in a group come the groups first, then the lights, then the objects.
 */
import { type EntityKind, type MemberRef, memberKinds } from './entity.ts';
import type { Document } from './schema.ts';
import type { Draft } from './store.ts';

/** What has a place among others: objects, lights and materials, and groups. */
export type PlacedKind = EntityKind | 'groups';

/** As they are shown. */
export const placedKinds: readonly PlacedKind[] = ['groups', 'lights', 'objects', 'materials'];

export interface PlacedRef {
  readonly kind: PlacedKind;
  readonly id: string;
}

/** Where something goes among others. */
export interface Beside extends PlacedRef {
  readonly side: 'before' | 'after';
}

/** The group that something is in. */
export function parentOf(document: Document, kind: PlacedKind, id: string): string | null {
  if (kind === 'materials') return null;
  if (kind === 'groups') return document.groups[id]?.parent ?? null;
  return document[kind][id]?.group ?? null;
}

/** Those of a kind that are directly in a group, or in none. */
export function siblingsIn(document: Document, kind: PlacedKind, group: string | null): string[] {
  return Object.keys(document[kind]).filter((id) => parentOf(document, kind, id) === group);
}

interface Contents {
  readonly groups: string[];
  readonly members: MemberRef[];
}

/** What is directly in each group; null is what is in none. */
export function contentsOf(document: Document): ReadonlyMap<string | null, Contents> {
  const found = new Map<string | null, Contents>([[null, { groups: [], members: [] }]]);
  for (const id of Object.keys(document.groups)) found.set(id, { groups: [], members: [] });
  for (const [id, { parent }] of Object.entries(document.groups)) found.get(parent)?.groups.push(id);
  for (const kind of memberKinds)
    for (const [id, { group }] of Object.entries<{ group: string | null }>(document[kind]))
      found.get(group)?.members.push({ kind, id });
  return found;
}

/** All groups, lights and objects in the order in which a tree of them shows them. */
export function outlined(document: Document): PlacedRef[] {
  const contents = contentsOf(document);
  const inside = (group: string | null): PlacedRef[] => {
    const { groups = [], members = [] } = contents.get(group) ?? {};
    return [...groups.map((id) => ({ kind: 'groups', id }) as const), ...members];
  };
  const found: PlacedRef[] = [];
  // Without recursion: groups may be in one another as deep as wanted.
  const pending = inside(null).reverse();
  for (let next = pending.pop(); next !== undefined; next = pending.pop()) {
    found.push(next);
    if (next.kind === 'groups') pending.push(...inside(next.id).reverse());
  }
  return found;
}

/**
 * The ids of a collection when those that are moved come together beside another one, or without one last among those in the
 * group. Things of another kind than that of what they are beside come as near to it as they can: first or last.
 */
export function idsMoved(
  document: Document,
  kind: PlacedKind,
  moved: readonly string[],
  group: string | null,
  beside?: Beside,
): string[] {
  const gone = new Set(moved);
  const siblings = siblingsIn(document, kind, group);
  const stay = siblings.filter((id) => !gone.has(id));
  let next: string | undefined;
  if (beside?.kind === kind) {
    const at = siblings.indexOf(beside.id) + (beside.side === 'after' ? 1 : 0);
    next = siblings.slice(Math.max(0, at)).find((id) => !gone.has(id));
  } else if (beside && placedKinds.indexOf(kind) > placedKinds.indexOf(beside.kind)) next = stay[0];
  const ordered = stay.toSpliced(next === undefined ? stay.length : stay.indexOf(next), 0, ...moved);
  const all = Object.keys(document[kind]);
  if (ordered.length === siblings.length && ordered.every((id, i) => id === siblings[i])) return all;
  const rest = all.filter((id) => !gone.has(id));
  const last = stay.at(-1);
  const place =
    next !== undefined ? rest.indexOf(next) : last !== undefined ? rest.indexOf(last) + 1 : rest.length;
  return rest.toSpliced(place, 0, ...moved);
}

/** The ids of a collection when some of those in a group have changed places with their neighbours. */
export function idsShifted(
  document: Document,
  kind: PlacedKind,
  group: string | null,
  shifted: ReadonlySet<string>,
  by: -1 | 1,
): string[] {
  const siblings = siblingsIn(document, kind, group);
  const order = by < 0 ? siblings : siblings.toReversed();
  for (let i = 1; i < order.length; i++) {
    const [before, own] = [order[i - 1]!, order[i]!];
    if (shifted.has(own) && !shifted.has(before)) [order[i - 1], order[i]] = [own, before];
  }
  const rearranged = by < 0 ? order : order.toReversed();
  const own = new Set(siblings);
  let at = 0;
  return Object.keys(document[kind]).map((id) => (own.has(id) ? rearranged[at++]! : id));
}

/** Puts the entries of a collection of a draft into another order, if it is another. */
export function arrange(draft: Draft, before: Document, kind: PlacedKind, ids: readonly string[]): void {
  const now = Object.keys(before[kind]);
  if (now.every((id, i) => id === ids[i])) return;
  const collection = draft[kind] as Record<string, unknown>;
  (draft as Record<PlacedKind, unknown>)[kind] = Object.fromEntries(ids.map((id) => [id, collection[id]]));
}

/** Puts new entries into a collection of a draft, each behind the one that it is to follow. */
export function insertAfter<T>(
  draft: Draft,
  kind: PlacedKind,
  added: ReadonlyMap<string, readonly (readonly [id: string, entry: T])[]>,
): void {
  if (added.size === 0) return;
  const entries = Object.entries(draft[kind] as Record<string, unknown>);
  (draft as Record<PlacedKind, unknown>)[kind] = Object.fromEntries(
    entries.flatMap(([id, entry]): (readonly [string, unknown])[] => [[id, entry], ...(added.get(id) ?? [])]),
  );
}
