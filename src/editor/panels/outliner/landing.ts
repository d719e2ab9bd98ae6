/** Where rows that are dragged land: between two rows, in a group, or nowhere. */
import type { MemberRef } from '../../../scene/entity.ts';
import { isWithin, keyOf } from '../../../scene/groups.ts';
import { type Beside, contentsOf, type PlacedKind, type PlacedRef, parentOf } from '../../../scene/order.ts';
import type { Document } from '../../../scene/schema.ts';
import { groupKey, type RowTarget, sectionKey, type TreeRow } from './tree.ts';

/** What is being dragged: groups as groups, and single things. */
export interface Dragged {
  readonly groups: readonly string[];
  readonly members: readonly MemberRef[];
  readonly materials: readonly string[];
}

export interface Landing {
  /** The group that it gets in. */
  readonly group: string | null;
  readonly beside?: Beside;
  /** What shows it: a line at the upper edge of a row (that may be one behind the last), or the row of a group. */
  readonly mark: { readonly line: number; readonly level: number } | { readonly row: string };
}

export interface Pointer {
  /** Of the row's height, from its upper edge. */
  readonly y: number;
  /** How far a name would be indented that begins there. */
  readonly level: number;
}

/** The part of a group's row, above and below, that means a place beside it. */
const EDGE = 0.25;

export function landingAt(
  document: Document,
  rows: readonly TreeRow[],
  index: number,
  pointer: Pointer,
  dragged: Dragged,
): Landing | null {
  const row = rows[index];
  if (!row) return null;
  const { target } = row;
  const ref = refOf(target);
  const { groups, members, materials } = dragged;
  if (materials.length > 0) {
    if (groups.length + members.length > 0 || ref?.kind !== 'materials') return null;
    return besideRow(document, rows, index, ref, pointer.y < 0.5);
  }
  if (ref?.kind === 'materials' || target.type === 'scene') return null;
  const found = ref ? atRow(document, rows, index, ref, pointer, dragged) : atSection(target, row.key);
  const isInItself = found !== null && groups.some((id) => isWithin(document.groups, found.group, id));
  return isInItself ? null : found;
}

function refOf(target: RowTarget): PlacedRef | null {
  if (target.type === 'entity') return target.entity;
  return target.type === 'group' ? { kind: 'groups', id: target.id } : null;
}

/** The title of a section is out of all groups. */
function atSection(target: RowTarget, key: string): Landing | null {
  return target.type === 'section' && target.kind !== 'materials'
    ? { group: null, mark: { row: key } }
    : null;
}

function atRow(
  document: Document,
  rows: readonly TreeRow[],
  index: number,
  ref: PlacedRef,
  { y, level }: Pointer,
  { groups, members }: Dragged,
): Landing | null {
  const has = (kind: PlacedKind) => members.some((member) => member.kind === kind);
  const row = rows[index]!;
  if (ref.kind === 'groups') {
    const into: Landing = { group: ref.id, mark: { row: row.key } };
    if (groups.length === 0 || (y >= EDGE && y <= 1 - EDGE)) return into;
    if (y < EDGE) return besideRow(document, rows, index, ref, true);
    const below = rows[index + 1];
    const first = below && below.level > row.level ? refOf(below.target) : null;
    return first
      ? besideRow(document, rows, index + 1, first, true)
      : besideRow(document, rows, index, ref, false);
  }
  if (has(ref.kind)) return besideRow(document, rows, index, ref, y < 0.5);
  const behind = members.length === 0 && y >= 0.5 ? behindGroup(document, rows, index, ref, level) : null;
  if (behind) return behind;
  // Kinds do not mix: it comes among its own in the same group.
  const parent = parentOf(document, ref.kind, ref.id);
  const moved = [...groups.map((id) => ({ kind: 'groups', id }) as const), ...members];
  if (moved.every(({ kind, id }) => parentOf(document, kind, id) === parent)) return null;
  const [{ kind } = ref] = moved;
  return { group: parent, mark: { row: parent === null ? sectionKey(kind) : groupKey(parent) } };
}

/** To the left of the last thing in a group is behind the group; null where it is not the last, or not to the left. */
function behindGroup(
  document: Document,
  rows: readonly TreeRow[],
  index: number,
  ref: PlacedRef,
  level: number,
): Landing | null {
  const contents = contentsOf(document);
  let [at, own]: [PlacedRef, number] = [ref, rows[index]!.level];
  while (own > level) {
    const parent = parentOf(document, at.kind, at.id);
    const { groups, members } = contents.get(parent) ?? { groups: [], members: [] };
    const last = members.at(-1) ?? { kind: 'groups', id: groups.at(-1) ?? '' };
    if (parent === null || keyOf(last) !== keyOf(at)) break;
    [at, own] = [{ kind: 'groups', id: parent }, own - 1];
  }
  if (at === ref) return null;
  const group = parentOf(document, at.kind, at.id);
  return { group, beside: { ...at, side: 'after' }, mark: { line: index + 1, level: own } };
}

function besideRow(
  document: Document,
  rows: readonly TreeRow[],
  index: number,
  ref: PlacedRef,
  isBefore: boolean,
): Landing {
  const { level } = rows[index]!;
  let end = index + 1;
  // Behind a group is behind all that is in it.
  while (!isBefore && (rows[end]?.level ?? 0) > level) end += 1;
  return {
    group: parentOf(document, ref.kind, ref.id),
    beside: { ...ref, side: isBefore ? 'before' : 'after' },
    mark: { line: isBefore ? index : end, level },
  };
}
