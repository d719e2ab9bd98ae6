/** What a person does to all that is selected, each as one undo step. */
import { describeEntities, type EntityRef, entity, isMember, type MemberRef, namesOf } from './entity.ts';
import { DocumentError, pathText } from './error.ts';
import { dropEmptied } from './group-commands.ts';
import { keyOf, membersOf, wholeGroups } from './groups.ts';
import { removeMaterials } from './material-commands.ts';
import { FreeIds, FreeNames } from './names.ts';
import type { Document } from './schema.ts';
import type { DocumentStore } from './store.ts';

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
 * Copies them, groups that are there as a whole among them, and returns the copies, in the same order. The copy
 * of an object shares its material; copies are not locked, for they are there to be moved.
 */
export function duplicateEntities(store: DocumentStore, refs: readonly EntityRef[]): EntityRef[] {
  const { document } = store;
  const originals = unique(refs);
  const copies = new Map<string, EntityRef>();
  store.edit(`Duplicate ${describeEntities(document, originals)}`, (draft) => {
    const whole = wholeGroups(document, originals);
    const groupNames = new FreeNames(namesOf(document.groups));
    const groupIds = new FreeIds(Object.keys(document.groups));
    const copyOf = new Map<string, string>();
    for (const id of whole) {
      const { name, parent } = entity(document, 'groups', id);
      const copy = groupIds.take(baseOf(id));
      draft.groups[copy] = { name: groupNames.take(name), parent };
      copyOf.set(id, copy);
    }
    for (const copy of copyOf.values()) {
      const group = entity(draft, 'groups', copy);
      group.parent = copyOf.get(group.parent ?? '') ?? group.parent;
    }
    for (const kind of ['lights', 'objects', 'materials'] as const) {
      const names = new FreeNames(namesOf(document[kind]));
      const ids = new FreeIds(Object.keys(document[kind]));
      for (const ref of originals) {
        if (ref.kind !== kind) continue;
        const original = entity(document, kind, ref.id);
        const id = ids.take(baseOf(ref.id));
        const target: Record<string, object> = draft[kind];
        target[id] = {
          ...structuredClone(original),
          name: names.take(original.name),
          ...('group' in original && {
            locked: false,
            group: copyOf.get(original.group ?? '') ?? original.group,
          }),
        };
        copies.set(keyOf(ref), { kind, id });
      }
    }
  });
  return originals.flatMap((ref) => copies.get(keyOf(ref)) ?? []);
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
