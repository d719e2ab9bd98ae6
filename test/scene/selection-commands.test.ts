import { beforeEach, describe, expect, test } from 'vitest';
import { addLight, addObject, rename, setField } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { describeEntities, type EntityRef, type MemberRef } from '../../src/scene/entity.ts';
import { groupEntities, moveToGroup, ungroup } from '../../src/scene/group-commands.ts';
import { membersOf, unitsOf, wholeGroups } from '../../src/scene/groups.ts';
import { assignMaterial, giveOwnMaterials } from '../../src/scene/material-commands.ts';
import {
  duplicateEntities,
  removeEntities,
  setLocked,
  setVisible,
} from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { place } from '../../src/scene/transform-commands.ts';

let store: DocumentStore;
let box: MemberRef;
let cone: MemberRef;
let lamp: MemberRef;

beforeEach(() => {
  store = new DocumentStore(createDocument());
  box = { kind: 'objects', id: addObject(store, 'box') };
  cone = { kind: 'objects', id: addObject(store, 'cone') };
  lamp = { kind: 'lights', id: addLight(store, 'point') };
});

const steps = () => store.historyIndex;
const materialOf = (ref: EntityRef) => store.document.objects[ref.id]?.material ?? '';
const groupOf = (ref: MemberRef) => store.document[ref.kind][ref.id]?.group;

/** Runs a command and checks that it is one step, which undo takes back to the letter. */
function once<T>(run: () => T): T {
  const [before, count] = [store.document, steps()];
  const result = run();
  expect(steps()).toBe(count + 1);
  const after = store.document;
  store.undo();
  expect(store.document).toBe(before);
  store.redo();
  expect(store.document).toBe(after);
  return result;
}

describe('many things at once', () => {
  test('are deleted, with an heir for what had a deleted material', () => {
    const [other, gone] = [materialOf(cone), materialOf(box)];
    once(() => removeEntities(store, [lamp, cone, { kind: 'materials', id: gone }]));
    expect(Object.keys(store.document.objects)).toEqual([box.id]);
    expect(store.document.lights).toEqual({});
    expect(materialOf(box)).toBe(other);
    expect(store.undoLabel).toBe('Delete 1 light, 1 object and 1 material');
  });

  test('are duplicated under names and ids of their own, unlocked, in the order asked for', () => {
    setLocked(store, [box], true);
    const copies = once(() =>
      duplicateEntities(store, [lamp, box, { kind: 'materials', id: materialOf(box) }]),
    );
    expect(copies.map(({ kind }) => kind)).toEqual(['lights', 'objects', 'materials']);
    const [, copy] = copies;
    expect(store.document.objects[copy?.id ?? '']).toMatchObject({
      name: 'Cube 2',
      locked: false,
      material: materialOf(box),
    });
  });

  test('are duplicated by a drag that moves the copies: one step, which can be given up', () => {
    const before = store.document;
    const drag = () => {
      const copies = duplicateEntities(store, [box, lamp], 'drag');
      for (const x of [1, 2, 3]) {
        const moved = copies.map((ref) => ({
          ...(ref as MemberRef),
          placement: { position: [x, 0, 0] as [number, number, number] },
        }));
        place(store, 'Move', moved, 'drag');
      }
      return copies;
    };
    const [copy] = once(drag);
    expect(store.document.objects[copy!.id]?.position).toEqual([3, 0, 0]);
    expect(store.undoLabel).toBe('Duplicate 1 light and 1 object');
    store.undo();
    drag();
    store.abandon('other');
    expect(store.document).not.toBe(before);
    store.abandon('drag');
    expect(store.document).toBe(before);
    expect(store.canRedo).toBe(true);
  });

  test('get copies of their materials that no other object has, one of each', () => {
    assignMaterial(store, [box.id, cone.id], materialOf(box));
    const third = addObject(store, 'sphere', materialOf(box));
    const shared = materialOf(box);
    const [own, ...more] = once(() => giveOwnMaterials(store, [box.id, cone.id]));
    expect(more).toEqual([]);
    expect([box, cone].map(materialOf)).toEqual([own, own]);
    expect(store.document.objects[third]?.material).toBe(shared);
    const { name, ...copy } = store.document.materials[own!]!;
    expect(name).not.toBe(store.document.materials[shared]?.name);
    expect(store.document.materials[shared]).toMatchObject(copy);
    expect(store.undoLabel).toBe(`Own copy of ${store.document.materials[shared]?.name}`);
  });

  test('take back a drag by the last word of its key alone', () => {
    const before = store.document;
    store.edit(
      'Slide',
      (draft) => {
        draft.name = 'Other';
      },
      { merge: 'name gesture-12' },
    );
    store.abandon('gesture-2');
    expect(store.document).not.toBe(before);
    store.abandon('gesture-12');
    expect(store.document).toBe(before);
  });

  test('are hidden and locked; those that are already cost no step', () => {
    once(() => setVisible(store, [box, cone, lamp], false));
    const count = steps();
    setVisible(store, [box, cone], false);
    expect(steps()).toBe(count);
    once(() => setLocked(store, [box, lamp], true));
    expect(store.undoLabel).toBe('Lock 1 light and 1 object');
    expect(store.document.lights[lamp.id]).toMatchObject({ locked: true, visible: false });
  });

  test('keep what is locked when they are deleted, and are refused if all is', () => {
    setLocked(store, [box], true);
    once(() => removeEntities(store, [box, cone]));
    expect(Object.keys(store.document.objects)).toEqual([box.id]);
    const before = store.document;
    expect(() => removeEntities(store, [box])).toThrow(/cube: is locked/);
    expect(store.document).toBe(before);
  });

  test('that do not exist change nothing', () => {
    const before = store.document;
    const nothing = { kind: 'objects', id: 'nothing' } as const;
    for (const command of [removeEntities, duplicateEntities])
      expect(() => command(store, [box, nothing])).toThrow(/nothing.*does not exist/);
    expect(() => setVisible(store, [box, nothing], false)).toThrow(/does not exist/);
    expect(store.document).toBe(before);
  });

  test('are described by names and numbers', () => {
    expect(describeEntities(store.document, [box])).toBe('Cube');
    expect(describeEntities(store.document, [box, cone])).toBe('2 objects');
    expect(describeEntities(store.document, [box, lamp])).toBe('1 light and 1 object');
  });
});

describe('groups', () => {
  test('are made of what is selected, whole groups as groups, in the group that all of it was in', () => {
    const inner = once(() => groupEntities(store, [box, lamp]));
    expect([groupOf(box), groupOf(lamp)]).toEqual([inner, inner]);
    const outer = once(() => groupEntities(store, [box, lamp, cone]));
    expect(store.document.groups).toEqual({
      [inner]: { name: 'Group', parent: outer },
      [outer]: { name: 'Group 2', parent: null },
    });
    expect(groupOf(cone)).toBe(outer);
    // Within the outer one: so is what is made of some of it.
    const within = groupEntities(store, [cone, box]);
    expect(store.document.groups[within]).toMatchObject({ parent: outer });
    expect(membersOf(store.document, outer)).toHaveLength(3);
  });

  test('are dissolved where they are whole, left where they are not', () => {
    const inner = groupEntities(store, [box, lamp]);
    const outer = groupEntities(store, [box, lamp, cone]);
    once(() => ungroup(store, [box, lamp, cone]));
    expect(store.document.groups).toEqual({ [inner]: { name: 'Group', parent: null } });
    once(() => ungroup(store, [lamp]));
    expect([groupOf(lamp), groupOf(box)]).toEqual([null, inner]);
    const count = steps();
    ungroup(store, [lamp]);
    expect(steps()).toBe(count);
    expect(store.document.groups).not.toHaveProperty(outer);
  });

  test('in others: what is dissolved or left goes to the group around', () => {
    const inner = groupEntities(store, [box]);
    const middle = groupEntities(store, [box, lamp]);
    const outer = groupEntities(store, [box, lamp, cone]);
    const other = { kind: 'objects', id: addObject(store, 'sphere') } as const;
    moveToGroup(store, [other], [], outer);
    once(() => ungroup(store, [box, lamp]));
    expect(store.document.groups).toEqual({
      [inner]: { name: 'Group', parent: outer },
      [outer]: { name: 'Group 3', parent: null },
    });
    expect([groupOf(box), groupOf(lamp)]).toEqual([inner, outer]);
    store.undo();
    // Of the middle one, lamp is one of two: it leaves for the outer one.
    once(() => ungroup(store, [lamp]));
    expect(groupOf(lamp)).toBe(outer);
    expect(store.document.groups[middle]).toMatchObject({ parent: outer });
  });

  test('that have nothing in them go when they are asked to, and only then', () => {
    store.edit('As files can have them', (draft) => {
      draft.groups.empty = { name: 'Empty', parent: null };
      draft.groups.within = { name: 'Within', parent: 'empty' };
      draft.groups.other = { name: 'Other', parent: null };
    });
    once(() => removeEntities(store, [cone]));
    expect(Object.keys(store.document.groups)).toEqual(['empty', 'within', 'other']);
    once(() => removeEntities(store, [], ['empty']));
    expect(Object.keys(store.document.groups)).toEqual(['other']);
  });

  test('that never had members stay in the group around one that goes', () => {
    const outer = groupEntities(store, [box, cone]);
    const inner = groupEntities(store, [box]);
    store.edit('As files can have them', (draft) => {
      draft.groups.empty = { name: 'Empty', parent: inner };
    });
    once(() => removeEntities(store, [box]));
    expect(store.document.groups).toMatchObject({ empty: { parent: outer } });
    expect(store.document.groups).not.toHaveProperty(inner);
  });

  test('go when their last member goes, and bring their members along when they are deleted', () => {
    const group = groupEntities(store, [box, cone]);
    once(() => removeEntities(store, [box, cone]));
    expect(store.document.groups).toEqual({});
    store.undo();
    once(() => removeEntities(store, [], [group]));
    expect(store.undoLabel).toBe('Delete Group');
    expect(store.document).toMatchObject({ groups: {}, objects: {} });
    store.undo();
    setLocked(store, [cone], true);
    removeEntities(store, [], [group]);
    expect(Object.keys(store.document.objects)).toEqual([cone.id]);
    expect(store.document.groups).toHaveProperty(group);
  });

  test('are duplicated with all that is in them', () => {
    const inner = groupEntities(store, [box]);
    const outer = groupEntities(store, [box, lamp]);
    const copies = once(() => duplicateEntities(store, [box, lamp]));
    const [copy, light] = copies as [MemberRef, MemberRef];
    const [innerCopy, outerCopy] = [groupOf(copy) ?? '', groupOf(light) ?? ''];
    expect(store.document.groups[innerCopy]).toEqual({ name: 'Group 3', parent: outerCopy });
    expect(store.document.groups[outerCopy]?.parent).toBeNull();
    expect(new Set([inner, outer, innerCopy, outerCopy]).size).toBe(4);
    // One of two members: the copy is in the same group.
    const [single] = duplicateEntities(store, [lamp]) as [MemberRef];
    expect(groupOf(single)).toBe(outer);
  });

  test('can be moved into one another, but not into themselves', () => {
    const a = groupEntities(store, [box]);
    const b = groupEntities(store, [cone]);
    once(() => moveToGroup(store, [lamp], [b], a));
    expect([groupOf(lamp), store.document.groups[b]?.parent]).toEqual([a, a]);
    expect(() => moveToGroup(store, [], [a], b)).toThrow(/in itself/);
    expect(() => moveToGroup(store, [lamp], [], 'nothing')).toThrow(/does not exist/);
    once(() => moveToGroup(store, [box, lamp], [b], null));
    expect(store.document.groups).toEqual({ [b]: { name: 'Group 2', parent: null } });
    rename(store, 'groups', b, 'Trees');
    expect(store.document.groups[b]?.name).toBe('Trees');
    expect(() => setField(store, ['groups', b, 'parent'], b)).toThrow(/in itself/);
    expect(() => setField(store, ['objects', box.id, 'group'], 'nothing')).toThrow(/no group/);
  });

  test('are whole only with all of their members', () => {
    const inner = groupEntities(store, [box]);
    const outer = groupEntities(store, [box, lamp]);
    expect([...wholeGroups(store.document, [box])]).toEqual([inner]);
    expect([...wholeGroups(store.document, [box, lamp])].sort()).toEqual([inner, outer].sort());
    expect(unitsOf(store.document, [box, lamp, cone])).toEqual({ groups: [outer], loose: [cone] });
  });
});

describe('the history', () => {
  test('names every step and goes to any of them as one change', () => {
    const labels = store.history.map(({ label }) => label);
    expect(labels).toEqual(['Add cube', 'Add cone', 'Add point light']);
    const last = store.document;
    let changes = 0;
    store.subscribe(() => {
      changes += 1;
    });
    store.goTo(0);
    expect([changes, store.historyIndex, store.canUndo]).toEqual([1, 0, false]);
    expect(store.document).toEqual(createDocument());
    expect(store.history.map(({ label }) => label)).toEqual(labels);
    store.goTo(2);
    expect([store.undoLabel, store.redoLabel]).toEqual(['Add cone', 'Add point light']);
    store.goTo(99);
    expect(store.document).toBe(last);
    store.goTo(3);
    expect(changes).toBe(3);
    store.goTo(1);
    addLight(store, 'spot');
    expect(store.history.map(({ label }) => label)).toEqual(['Add cube', 'Add spot light']);
  });
});
