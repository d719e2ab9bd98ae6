/** What the page's menus, keys and rows do to all that is selected. */
import { isMember, type MemberRef } from '../scene/entity.ts';
import { groupEntities, shift, ungroup } from '../scene/group-commands.ts';
import { groupOf, groupsAround, keyOf, membersOf, wholeGroups } from '../scene/groups.ts';
import { assignMaterial, giveOwnMaterials } from '../scene/material-commands.ts';
import {
  duplicateEntities,
  lockedOf,
  removeEntities,
  setLocked,
  setVisible,
} from '../scene/selection-commands.ts';
import { attempt } from './commands.ts';
import { plural, t } from './language/language.ts';
import type { Session } from './session.ts';
import type { Entity } from './state.ts';
import { toast } from './ui/toast.ts';

type Context = Pick<Session, 'store' | 'state'>;

/** The objects and lights that are selected. */
export function selectedMembers({ state }: Context): MemberRef[] {
  return state.value.selected.filter(isMember);
}

export function deleteSelected({ store, state }: Context): void {
  const { selected } = state.value;
  if (selected.length === 0) return;
  const locked = lockedOf(store.document, selected).length;
  attempt(t('Not deleted'), () => {
    if (locked < selected.length) removeEntities(store, selected);
    if (locked > 0) toast('info', plural(locked, 'One is locked and stays', '{count} are locked and stay'));
  });
}

export function duplicateSelected({ store, state }: Context): void {
  const { selected } = state.value;
  if (selected.length === 0) return;
  const copies = attempt(t('Not duplicated'), () => duplicateEntities(store, selected));
  if (copies) state.selectAll(copies);
}

/** Hides what is selected; shows it if all of it is hidden. */
export function toggleVisible(context: Context, refs = selectedMembers(context)): void {
  const { document } = context.store;
  const shown = refs.some(({ kind, id }) => document[kind][id]?.visible);
  attempt(t('Nothing was hidden or shown'), () => setVisible(context.store, refs, !shown));
}

/** Locks what is selected; unlocks it if all of it is locked. */
export function toggleLocked(context: Context, refs = selectedMembers(context)): void {
  const { document } = context.store;
  const free = refs.some(({ kind, id }) => !document[kind][id]?.locked);
  attempt(t('Nothing was locked or unlocked'), () => setLocked(context.store, refs, free));
}

export function groupSelected({ store, state }: Context): void {
  attempt(t('Not grouped'), () => groupEntities(store, state.value.selected, t('Group|thing')));
}

export function ungroupSelected({ store, state }: Context): void {
  attempt(t('Not ungrouped'), () => ungroup(store, state.value.selected));
}

/** Lets what is selected change places with its neighbours in the outliner. */
export function shiftSelected({ store, state }: Context, by: -1 | 1): void {
  attempt(t('Not moved'), () => shift(store, state.value.selected, by));
}

/** Everything that is in the innermost groups of what is selected that are not selected as a whole. */
export function selectGroups({ store, state }: Context): void {
  const { document } = store;
  const whole = wholeGroups(document, state.value.selected);
  const outside = (ref: MemberRef) =>
    [...groupsAround(document.groups, groupOf(document, ref))].find((group) => !whole.has(group));
  const groups = new Set(state.value.selected.filter(isMember).map(outside));
  const more = [...groups].flatMap((group) => (group === undefined ? [] : membersOf(document, group)));
  const before = new Set(state.value.selected.map(keyOf));
  // What was chosen last stays the last.
  const added = new Map(more.filter((ref) => !before.has(keyOf(ref))).map((ref) => [keyOf(ref), ref]));
  state.selectAll([...added.values(), ...state.value.selected]);
}

/** All materials where a material was chosen last; else every object and light that is neither hidden nor locked. */
function selectable({ store, state }: Context): Entity[] {
  const { document } = store;
  if (state.value.selection?.kind === 'materials')
    return Object.keys(document.materials).map((id) => ({ kind: 'materials', id }));
  return (['lights', 'objects'] as const).flatMap((kind) =>
    Object.entries<{ visible: boolean; locked: boolean }>(document[kind])
      .filter(([, { visible, locked }]) => visible && !locked)
      .map(([id]) => ({ kind, id })),
  );
}

export function selectEverything(context: Context): void {
  context.state.selectAll(selectable(context));
}

export function selectInverse(context: Context): void {
  const { state } = context;
  state.selectAll(selectable(context).filter((entity) => !state.isSelected(entity)));
}

/** All that can be selected and has one of the materials of what is selected; of materials, the objects that have them. */
export function selectSameMaterial({ store, state }: Context): void {
  const { objects } = store.document;
  const { selected } = state.value;
  const wanted = new Set(
    selected.map(({ kind, id }) =>
      kind === 'materials' ? id : kind === 'objects' ? objects[id]?.material : undefined,
    ),
  );
  const found = Object.entries(objects).flatMap(([id, { material, visible, locked }]): Entity[] =>
    wanted.has(material) && visible && !locked ? [{ kind: 'objects', id }] : [],
  );
  // What was chosen last stays the last.
  const before = new Set(selected.map(keyOf));
  const members = selected.filter(({ kind }) => kind === 'objects');
  state.selectAll([...found.filter((ref) => !before.has(keyOf(ref))), ...members]);
}

/** Gives the objects that are selected the material of the one that was chosen last. */
export function assignLastMaterial({ store, state }: Context): void {
  const { selection, selected } = state.value;
  const material = store.document.objects[selection?.id ?? '']?.material;
  const objects = selected.filter(({ kind }) => kind === 'objects').map(({ id }) => id);
  if (material !== undefined)
    attempt(t('The objects keep their material'), () => assignMaterial(store, objects, material));
}

/** Gives the objects that are selected copies of their materials, for themselves. */
export function giveOwn({ store, state }: Context): void {
  const objects = state.value.selected.filter(({ kind }) => kind === 'objects').map(({ id }) => id);
  attempt(t('The objects keep their material'), () => giveOwnMaterials(store, objects));
}

/** What was hidden to look at something alone. */
let hiddenForAlone: readonly MemberRef[] = [];

/** Another document is open. */
export function forgetAlone(): void {
  hiddenForAlone = [];
}

/** Whether something was hidden to look at something alone, and still is. */
export function isAlone({ store: { document } }: Context): boolean {
  return hiddenForAlone.some(({ kind, id }) => document[kind][id]?.visible === false);
}

/**
 * Hides the other objects where objects are given, the other lights where lights are; shows again what was hidden so. Undo
 * brings it back, too.
 */
export function toggleAlone(context: Context, refs = selectedMembers(context)): void {
  const { store } = context;
  const { document } = store;
  const back = hiddenForAlone.filter(({ kind, id }) => document[kind][id]?.visible === false);
  const alone = new Set(refs.map(keyOf));
  const kinds = new Set(refs.map(({ kind }) => kind));
  const others = allMembers(context).filter(
    (ref) => kinds.has(ref.kind) && !alone.has(keyOf(ref)) && document[ref.kind][ref.id]?.visible,
  );
  attempt(t('Nothing was hidden or shown'), () => {
    if (back.length > 0) setVisible(store, back, true);
    else setVisible(store, others, false);
  });
  hiddenForAlone = back.length > 0 ? [] : others;
}

/** Every object and light of the scene. */
export function allMembers({ store: { document } }: Context): MemberRef[] {
  return (['lights', 'objects'] as const).flatMap((kind) =>
    Object.keys(document[kind]).map((id) => ({ kind, id })),
  );
}
