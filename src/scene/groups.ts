/** What is in which group. */
import { type EntityRef, isMember, type MemberRef, memberKinds } from './entity.ts';
import type { PlacedRef } from './order.ts';
import type { Document } from './schema.ts';

type Groups = Document['groups'];

/** The group and those that it is in, from within; nothing for null. */
export function* groupsAround(groups: Groups, id: string | null): Generator<string> {
  for (let at = id; at !== null; at = groups[at]?.parent ?? null) yield at;
}

export function groupOf(document: Document, { kind, id }: MemberRef): string | null {
  return document[kind][id]?.group ?? null;
}

/** All objects and lights, with the group that each is in. */
function* members(document: Document): Generator<[MemberRef, group: string | null]> {
  for (const kind of memberKinds)
    for (const [id, { group }] of Object.entries<{ group: string | null }>(document[kind]))
      yield [{ kind, id }, group];
}

/** The objects and lights in a group and in the groups within it. */
export function membersOf(document: Document, group: string): MemberRef[] {
  return [...members(document)]
    .filter(([, own]) => isWithin(document.groups, own, group))
    .map(([ref]) => ref);
}

/** Whether a group is the other one or somewhere in it. */
export function isWithin(groups: Groups, id: string | null, other: string): boolean {
  for (const at of groupsAround(groups, id)) if (at === other) return true;
  return false;
}

/** How many objects and lights each group has, those of the groups within it among them. */
export function memberCounts(
  document: Document,
  counts: (ref: MemberRef) => boolean = () => true,
): ReadonlyMap<string, number> {
  const found = new Map<string, number>();
  for (const [ref, group] of members(document))
    if (group !== null && counts(ref))
      for (const at of groupsAround(document.groups, group)) found.set(at, (found.get(at) ?? 0) + 1);
  return found;
}

/** The groups all of whose members are among these, with the groups within them; not those without members. */
export function wholeGroups(document: Document, refs: readonly EntityRef[]): Set<string> {
  const chosen = new Set(refs.map(keyOf));
  const all = memberCounts(document);
  const among = memberCounts(document, (ref) => chosen.has(keyOf(ref)));
  const isWhole = (id: string) => all.has(id) && among.get(id) === all.get(id);
  // A group without members goes with the one that it is in.
  const goesAlong = (id: string) => !all.has(id) && [...groupsAround(document.groups, id)].some(isWhole);
  return new Set(Object.keys(document.groups).filter((id) => isWhole(id) || goesAlong(id)));
}

export interface Units {
  /** Groups that are there as a whole and are in none that is. */
  readonly groups: readonly string[];
  /** What is in none of them. */
  readonly loose: readonly MemberRef[];
}

/** What a person sees in a selection: whole groups, and single objects and lights. */
export function unitsOf(document: Document, refs: readonly EntityRef[]): Units {
  const whole = wholeGroups(document, refs);
  const groups = [...whole].filter((id) => !whole.has(document.groups[id]?.parent ?? ''));
  const loose = refs.filter(isMember).filter((ref) => !whole.has(groupOf(document, ref) ?? ''));
  return { groups, loose };
}

/** The innermost group that all of these are in; null where there is none. */
export function commonGroup(groups: Groups, of: readonly (string | null)[]): string | null {
  const [first = null, ...others] = of;
  for (const candidate of groupsAround(groups, first))
    if (others.every((other) => isWithin(groups, other, candidate))) return candidate;
  return null;
}

export const keyOf = ({ kind, id }: EntityRef | PlacedRef): string => `${kind} ${id}`;
