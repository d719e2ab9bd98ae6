/** What a person does to all that is selected, each as one undo step. */
import { describeEntities, type EntityRef, entity, isMember, type MemberRef, namesOf } from './entity.ts';
import { DocumentError, pathText } from './error.ts';
import { dropEmptied } from './group-commands.ts';
import { keyOf, membersOf, wholeGroups } from './groups.ts';
import { removeMaterials } from './material-commands.ts';
import { FreeIds, FreeNames } from './names.ts';
import { insertAfter, type PlacedKind, parentOf } from './order.ts';
import type { Document, Light, Material, SceneObject } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';

/** What is locked among these. */
export function lockedOf(document: Document, refs: readonly EntityRef[]): MemberRef[] {
  return refs.filter(isMember).filter(({ kind, id }) => entity(document, kind, id).locked);
}

/**
 * Removes them, and groups with all that is in them. What is locked stays, and the groups that it is in; refused
 * if that is everything. Objects whose material goes get another one; assets that nothing uses any more stay
 * until removeUnused.
 */
export function removeEntities(
  store: DocumentStore,
  refs: readonly EntityRef[],
  groups: readonly string[] = [],
): void {
  const { document } = store;
  for (const { kind, id } of refs) entity(document, kind, id);
  for (const id of groups) entity(document, 'groups', id);
  const all = unique([...refs, ...groups.flatMap((id) => membersOf(document, id))]);
  const locked = new Set(lockedOf(document, all).map(keyOf));
  const gone = all.filter((ref) => !locked.has(keyOf(ref)));
  const [kept] = all;
  if (kept && gone.length === 0)
    throw new DocumentError('scene', [{ path: pathText([kept.kind, kept.id]), message: 'is locked' }]);
  const [group] = groups;
  const one = refs.length === 0 && groups.length === 1 && group !== undefined;
  const what = one ? entity(document, 'groups', group).name : describeEntities(document, gone);
  store.edit(`Delete ${what}`, (draft) => {
    for (const { kind, id } of gone) if (kind !== 'materials') delete draft[kind][id];
    removeMaterials(
      draft,
      gone.filter(({ kind }) => kind === 'materials').map(({ id }) => id),
    );
    dropEmptied(draft, document, groups);
  });
}

/**
 * Copies them, groups that are there as a whole among them, and returns the copies, in the same order. Copies come behind
 * the last of their originals in the same group. The copy of an object shares its material; copies are not locked, for they
 * are there to be moved.
 *
 * @param merge of a drag that moves the copies in the same undo step
 */
export function duplicateEntities(
  store: DocumentStore,
  refs: readonly EntityRef[],
  merge?: string,
): EntityRef[] {
  const { document } = store;
  const originals = unique(refs);
  for (const { kind, id } of originals) entity(document, kind, id);
  const chosen = new Set(originals.map(keyOf));
  const copies = new Map<string, EntityRef>();
  const recipe = (draft: Draft) => {
    const copyOf = new Map<string, string>();
    const groups = copiesOf(document, 'groups', wholeGroups(document, originals), (id, own) => {
      copyOf.set(id, own);
      return entity(document, 'groups', id);
    });
    const around = (group: string | null) => copyOf.get(group ?? '') ?? group;
    insertAfter(
      draft,
      'groups',
      mapped(groups, (copy) => ({ ...copy, parent: around(copy.parent) })),
    );
    for (const kind of ['lights', 'objects', 'materials'] as const) {
      const ids = Object.keys(document[kind]).filter((id) => chosen.has(keyOf({ kind, id })));
      const added = copiesOf<Light | SceneObject | Material>(document, kind, ids, (id, own) => {
        copies.set(keyOf({ kind, id }), { kind, id: own });
        return entity(document, kind, id);
      });
      insertAfter(
        draft,
        kind,
        mapped(added, (copy) =>
          'group' in copy ? { ...copy, locked: false, group: around(copy.group) } : copy,
        ),
      );
    }
  };
  store.edit(
    `Duplicate ${describeEntities(document, originals)}`,
    recipe,
    merge === undefined ? {} : { merge },
  );
  return originals.flatMap((ref) => copies.get(keyOf(ref)) ?? []);
}

type Added<T> = Map<string, (readonly [id: string, copy: T])[]>;

/** Copies under free ids and names, by the last original of the same group, which they are to follow. */
function copiesOf<T extends { name: string }>(
  document: Document,
  kind: PlacedKind,
  originals: Iterable<string>,
  make: (id: string, copy: string) => T,
): Added<T> {
  const names = new FreeNames(namesOf(document[kind]));
  const ids = new FreeIds(Object.keys(document[kind]));
  const byGroup = new Map<string | null, { last: string; own: (readonly [string, T])[] }>();
  for (const id of originals) {
    const group = parentOf(document, kind, id);
    const copy = ids.take(baseOf(id));
    const original = make(id, copy);
    // What is in it is frozen, and may be that of both.
    const entry = [copy, { ...original, name: names.take(original.name) }] as const;
    const others = byGroup.get(group);
    if (others) {
      others.own.push(entry);
      others.last = id;
    } else byGroup.set(group, { last: id, own: [entry] });
  }
  return new Map([...byGroup.values()].map(({ last, own }) => [last, own]));
}

function mapped<T, R>(added: Added<T>, change: (copy: T) => R): Added<R> {
  return new Map(
    [...added].map(([id, own]) => [id, own.map(([copy, value]) => [copy, change(value)] as const)]),
  );
}

/** `sphere-12` was made of `sphere`. */
const baseOf = (id: string) => id.replace(/-\d+$/, '');

export function setVisible(store: DocumentStore, refs: readonly MemberRef[], visible: boolean): void {
  setFlag(store, refs, 'visible', visible, visible ? 'Show' : 'Hide');
}

/** Locked: not picked in the picture, not moved, not deleted. */
export function setLocked(store: DocumentStore, refs: readonly MemberRef[], locked: boolean): void {
  setFlag(store, refs, 'locked', locked, locked ? 'Lock' : 'Unlock');
}

function setFlag(
  store: DocumentStore,
  refs: readonly MemberRef[],
  field: 'visible' | 'locked',
  value: boolean,
  verb: string,
): void {
  const { document } = store;
  const changed = unique(refs).filter(({ kind, id }) => entity(document, kind, id)[field] !== value);
  if (changed.length === 0) return;
  store.edit(`${verb} ${describeEntities(document, changed)}`, (draft) => {
    for (const { kind, id } of changed) entity(draft, kind, id)[field] = value;
  });
}

function unique<R extends EntityRef>(refs: readonly R[]): R[] {
  return [...new Map(refs.map((ref) => [keyOf(ref), ref])).values()];
}
