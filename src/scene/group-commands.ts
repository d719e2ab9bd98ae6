/** Commands for groups, each one undo step; see groups.ts. A group whose last member leaves it goes, too. */
import { current } from 'immer';
import {
  describeEntities,
  type EntityRef,
  entity,
  isMember,
  type MemberRef,
  memberKinds,
  namesOf,
} from './entity.ts';
import { DocumentError } from './error.ts';
import { commonGroup, groupOf, groupsAround, isWithin, keyOf, memberCounts, unitsOf } from './groups.ts';
import { freeId, freeName } from './names.ts';
import {
  arrange,
  type Beside,
  idsMoved,
  idsShifted,
  outlined,
  type PlacedRef,
  parentOf,
  placedKinds,
} from './order.ts';
import type { Document } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';

/**
 * Puts what is selected into a new group, whole groups as groups, and returns its id. The new group is in the
 * innermost one that all of it was in.
 */
export function groupEntities(store: DocumentStore, refs: readonly EntityRef[], name = 'Group'): string {
  const { document } = store;
  const { groups, loose } = unitsOf(document, refs);
  if (groups.length + loose.length === 0)
    throw new DocumentError('scene', [{ path: '', message: 'only objects and lights can be in a group' }]);
  const parents = [
    ...groups.map((id) => entity(document, 'groups', id).parent),
    ...loose.map((ref) => groupOf(document, ref)),
  ];
  const id = freeId(name, document.groups);
  store.edit(`Group ${describeEntities(document, refs.filter(isMember))}`, (draft) => {
    draft.groups[id] = {
      name: freeName(name, namesOf(document.groups)),
      parent: commonGroup(document.groups, parents),
    };
    put(draft, groups, loose, id);
    dropEmptied(draft, document);
  });
  return id;
}

/**
 * Dissolves the groups that are selected as a whole, the outermost of each; what is selected of other groups
 * leaves them. Everything goes to the group around.
 */
export function ungroup(store: DocumentStore, refs: readonly EntityRef[]): void {
  const { document } = store;
  const { groups, loose } = unitsOf(document, refs);
  const leaving = loose.filter((ref) => groupOf(document, ref) !== null);
  if (groups.length + leaving.length === 0) return;
  const [first] = groups;
  const label =
    groups.length === 1 && leaving.length === 0 && first
      ? `Ungroup ${entity(document, 'groups', first).name}`
      : `Ungroup ${describeEntities(document, refs.filter(isMember))}`;
  store.edit(label, (draft) => {
    for (const id of groups) dissolve(draft, document, id);
    for (const ref of leaving) {
      const own = groupOf(document, ref);
      entity(draft, ref.kind, ref.id).group = own === null ? null : entity(document, 'groups', own).parent;
    }
    dropEmptied(draft, document);
  });
}

function dissolve(draft: Draft, document: Document, id: string): void {
  const { parent } = entity(document, 'groups', id);
  for (const kind of ['lights', 'objects'] as const)
    for (const [member, { group }] of Object.entries<{ group: string | null }>(document[kind]))
      if (group === id) entity(draft, kind, member).group = parent;
  for (const [child, group] of Object.entries(document.groups))
    if (group.parent === id) entity(draft, 'groups', child).parent = parent;
  delete draft.groups[id];
}

/**
 * Moves objects, lights and groups into a group, or out of all of them, beside something there or to the end; refused for a
 * group into itself. Among themselves they stay in the order of the outliner.
 */
export function moveToGroup(
  store: DocumentStore,
  refs: readonly MemberRef[],
  groups: readonly string[],
  target: string | null,
  beside?: Beside,
): void {
  const { document } = store;
  const name = target === null ? null : entity(document, 'groups', target).name;
  for (const id of groups)
    if (isWithin(document.groups, target, id))
      throw new DocumentError('scene', [{ path: `groups.${id}`, message: 'the group would be in itself' }]);
  const [first] = groups;
  const what =
    groups.length === 1 && refs.length === 0 && first
      ? entity(document, 'groups', first).name
      : describeEntities(document, refs) || `${groups.length} groups`;
  const stay =
    groups.every((id) => entity(document, 'groups', id).parent === target) &&
    refs.every((ref) => groupOf(document, ref) === target);
  const recipe = (draft: Draft) => {
    put(draft, groups, refs, target);
    const chosen = new Set([...groups.map((id) => keyOf({ kind: 'groups', id })), ...refs.map(keyOf)]);
    const inOrder = outlined(document);
    for (const kind of ['groups', ...memberKinds] as const) {
      const moved = inOrder.filter((ref) => ref.kind === kind && chosen.has(keyOf(ref)));
      const ids = moved.map(({ id }) => id);
      if (ids.length > 0) arrange(draft, document, kind, idsMoved(document, kind, ids, target, beside));
    }
    dropEmptied(draft, document);
  };
  if (stay) store.edit(`Reorder ${what}`, recipe);
  else store.edit(name === null ? `Move ${what} out of groups` : `Move ${what} into ${name}`, recipe);
}

/** Puts materials beside another one. */
export function moveMaterials(store: DocumentStore, ids: readonly string[], beside: Beside): void {
  const { document } = store;
  const chosen = new Set(ids);
  const moved = Object.keys(document.materials).filter((id) => chosen.has(id));
  const refs = moved.map((id) => ({ kind: 'materials', id }) as const);
  store.edit(`Reorder ${describeEntities(document, refs)}`, (draft) => {
    arrange(draft, document, 'materials', idsMoved(document, 'materials', moved, null, beside));
  });
}

/** Lets what is selected, whole groups as groups, change places with what is before or after it in its group. */
export function shift(store: DocumentStore, refs: readonly EntityRef[], by: -1 | 1): void {
  const { document } = store;
  const { groups, loose } = unitsOf(document, refs);
  const placed: PlacedRef[] = [
    ...groups.map((id) => ({ kind: 'groups', id }) as const),
    ...loose,
    ...refs.filter(({ kind }) => kind === 'materials'),
  ];
  const [first] = groups;
  const what = groups.length === 1 && first ? entity(document, 'groups', first).name : undefined;
  store.edit(`Reorder ${what ?? describeEntities(document, refs)}`, (draft) => {
    for (const kind of placedKinds) {
      const own = placed.filter((ref) => ref.kind === kind);
      let now: Document = document;
      for (const parent of new Set(own.map(({ id }) => parentOf(document, kind, id)))) {
        const ids = idsShifted(now, kind, parent, new Set(own.map(({ id }) => id)), by);
        const entries: Record<string, unknown> = document[kind];
        now = { ...now, [kind]: Object.fromEntries(ids.map((id) => [id, entries[id]])) };
      }
      arrange(draft, document, kind, Object.keys(now[kind]));
    }
  });
}

function put(
  draft: Draft,
  groups: readonly string[],
  refs: readonly MemberRef[],
  target: string | null,
): void {
  for (const id of groups) entity(draft, 'groups', id).parent = target;
  for (const { kind, id } of refs) entity(draft, kind, id).group = target;
}

/**
 * Takes the groups out of a draft that have lost their last member since `before`, and those of `others` that
 * have none, unless somebody is in them.
 */
export function dropEmptied(draft: Draft, before: Document, others: readonly string[] = []): void {
  const had = memberCounts(before);
  // To copy the draft costs as much as the scene has.
  if (had.size === 0 && others.length === 0) return;
  const now = current(draft);
  const has = memberCounts(now);
  for (const id of Object.keys(now.groups)) {
    const asked = others.some((other) => isWithin(now.groups, id, other));
    if (!has.has(id) && (had.has(id) || asked)) delete draft.groups[id];
  }
  // A group that never had members does not keep one alive that has lost its own.
  for (const [id, { parent }] of Object.entries(now.groups))
    if (draft.groups[id] && parent !== null && !draft.groups[parent])
      draft.groups[id].parent =
        [...groupsAround(now.groups, parent)].find((around) => draft.groups[around]) ?? null;
}
