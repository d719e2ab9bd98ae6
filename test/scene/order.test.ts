/** The order of things: moved beside others, shifted, kept by copies, by the text of a document and by undo. */
import fc from 'fast-check';
import { beforeEach, describe, expect, test } from 'vitest';
import { copyEntities, pasteEntities } from '../../src/scene/clipboard.ts';
import { compactDocument } from '../../src/scene/compact.ts';
import { parseDocument, serializeDocument } from '../../src/scene/document.ts';
import type { MemberRef } from '../../src/scene/entity.ts';
import { moveMaterials, moveToGroup, shift } from '../../src/scene/group-commands.ts';
import { membersOf } from '../../src/scene/groups.ts';
import { outlined, siblingsIn } from '../../src/scene/order.ts';
import type { Document } from '../../src/scene/schema.ts';
import { duplicateEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const box = (group: string | null = null) => ({ material: 'm', geometry: { type: 'box' }, group });
let store: DocumentStore;
beforeEach(() => {
  const named = <T extends object>(entries: Record<string, T>) =>
    Object.fromEntries(Object.entries(entries).map(([id, entry]) => [id, { name: id, ...entry }]));
  const document = parseDocument(
    {
      format: 'irradia',
      version: 1,
      materials: named({ m: { model: 'lambert' }, n: { model: 'lambert' }, o: { model: 'lambert' } }),
      groups: named({ g: {}, h: {}, k: { parent: 'g' } }),
      lights: named({ lamp: { type: 'point' }, key: { type: 'spot' }, fill: { type: 'point', group: 'g' } }),
      objects: named({
        a: box(),
        b: box(),
        p: box('g'),
        c: box(),
        q: box('g'),
        r: box('h'),
        s: box('k'),
        d: box(),
      }),
    },
    'test',
  );
  store = new DocumentStore(document);
});

const objects = (...ids: string[]): MemberRef[] => ids.map((id) => ({ kind: 'objects', id }));
const inGroup = (group: string | null, document: Document = store.document) =>
  siblingsIn(document, 'objects', group).join('');
const groupsIn = (group: string | null) => siblingsIn(store.document, 'groups', group).join('');

/** One step, which undo takes back to the letter. */
function once(run: () => void): void {
  const [before, steps] = [JSON.stringify(store.document), store.historyIndex];
  run();
  expect(store.historyIndex).toBe(steps + 1);
  const after = JSON.stringify(store.document);
  store.undo();
  expect(JSON.stringify(store.document)).toBe(before);
  store.redo();
  expect(JSON.stringify(store.document)).toBe(after);
}

describe('things are put', () => {
  test('before and behind others, several together, in the order that they had', () => {
    once(() => moveToGroup(store, objects('d', 'b'), [], null, { kind: 'objects', id: 'a', side: 'before' }));
    expect(inGroup(null)).toBe('bdac');
    expect(store.undoLabel).toBe('Reorder 2 objects');
    once(() => moveToGroup(store, objects('d', 'a'), [], null, { kind: 'objects', id: 'c', side: 'after' }));
    expect(inGroup(null)).toBe('bcda');
  });

  test('into groups and out of them, beside what is there or to the end', () => {
    once(() => moveToGroup(store, objects('a'), [], 'g', { kind: 'objects', id: 'q', side: 'before' }));
    expect(inGroup('g')).toBe('paq');
    once(() => moveToGroup(store, objects('b'), [], 'g'));
    expect(inGroup('g')).toBe('paqb');
    once(() => moveToGroup(store, objects('a', 's'), [], null, { kind: 'objects', id: 'c', side: 'after' }));
    expect(inGroup(null)).toBe('csad');
    // A group goes with its last member.
    expect(groupsIn('g')).toBe('');
  });

  test('behind the last of their group in the text, too, and not behind those of other groups', () => {
    moveToGroup(store, objects('a'), [], 'g');
    expect(Object.keys(store.document.objects).join('')).toBe('bpcqarsd');
  });

  test('as near to a thing of another kind as their kind allows', () => {
    once(() => moveToGroup(store, objects('d'), ['h'], null, { kind: 'lights', id: 'key', side: 'before' }));
    expect(inGroup(null)).toBe('dabc');
    expect(groupsIn(null)).toBe('gh');
  });

  test('as groups, which cannot be put into themselves', () => {
    once(() => moveToGroup(store, [], ['h'], null, { kind: 'groups', id: 'g', side: 'before' }));
    expect(groupsIn(null)).toBe('hg');
    once(() => moveToGroup(store, [], ['h'], 'g', { kind: 'groups', id: 'k', side: 'before' }));
    expect(groupsIn('g')).toBe('hk');
    expect(() => moveToGroup(store, [], ['g'], 'k')).toThrow('in itself');
  });

  test('materials beside materials', () => {
    once(() => moveMaterials(store, ['o', 'n'], { kind: 'materials', id: 'm', side: 'before' }));
    expect(Object.keys(store.document.materials)).toEqual(['n', 'o', 'm']);
  });

  test('where they are already: that is no step', () => {
    moveToGroup(store, objects('b', 'c'), [], null, { kind: 'objects', id: 'a', side: 'after' });
    moveToGroup(store, objects('a', 'b'), [], null, { kind: 'objects', id: 'a', side: 'before' });
    expect(store.canUndo).toBe(false);
  });
});

describe('things are shifted', () => {
  test('past their neighbours, several at once, as far as there are any', () => {
    once(() => shift(store, objects('b', 'd'), -1));
    expect(inGroup(null)).toBe('badc');
    once(() => shift(store, objects('b', 'd'), -1));
    expect(inGroup(null)).toBe('bdac');
    shift(store, objects('b', 'd'), -1);
    expect(store.historyIndex).toBe(2);
    once(() => shift(store, objects('b', 'd'), 1));
    expect(inGroup(null)).toBe('abdc');
  });

  test('in several groups and kinds, whole groups as groups', () => {
    once(() =>
      shift(
        store,
        [...objects('q', 'b'), { kind: 'lights', id: 'key' }, ...membersOf(store.document, 'h')],
        -1,
      ),
    );
    expect([inGroup(null), inGroup('g'), groupsIn(null)]).toEqual(['bacd', 'qp', 'hg']);
    expect(Object.keys(store.document.lights)).toEqual(['key', 'lamp', 'fill']);
    once(() => shift(store, [{ kind: 'materials', id: 'm' }], 1));
    expect(Object.keys(store.document.materials)).toEqual(['n', 'm', 'o']);
  });
});

describe('the order', () => {
  test('of copies is that of their originals, and they come behind them', () => {
    once(() => void duplicateEntities(store, [...objects('c', 'a'), ...membersOf(store.document, 'g')]));
    const names = (group: string | null) =>
      siblingsIn(store.document, 'objects', group).map((id) => store.document.objects[id]?.name);
    expect(names(null)).toEqual(['a', 'b', 'c', 'a 2', 'c 2', 'd']);
    expect(groupsIn(null)).toBe('gg-2h');
    expect(names('g-2')).toEqual(['p 2', 'q 2']);
  });

  test('of what is pasted is that of what was copied', () => {
    const text = copyEntities(store.document, objects('d', 'q', 'a', 'r', 'p', 's'));
    once(() => void pasteEntities(store, text));
    expect(inGroup(null)).toBe('abcda-2p-2q-2d-2');
    expect(groupsIn(null)).toBe('ghh-2k-2');
  });

  test('is in the text of a document, and in a link', () => {
    moveToGroup(store, objects('d', 'c'), [], null, { kind: 'objects', id: 'a', side: 'before' });
    for (const text of [serializeDocument(store.document), JSON.stringify(compactDocument(store.document))])
      expect(Object.keys(parseDocument(text, 'again').objects)).toEqual(Object.keys(store.document.objects));
  });

  test('stays whole, whatever is put where', () => {
    const all = outlined(store.document);
    const some = fc.subarray(objects('a', 'b', 'c', 'd', 'p', 'q', 'r', 's'), { minLength: 1 });
    fc.assert(
      fc.property(
        some,
        fc.constantFrom(null, 'g', 'h', 'k'),
        fc.constantFrom(...all),
        fc.boolean(),
        (refs, target, ref, isBefore) => {
          const own = new DocumentStore(store.document);
          const { kind, id } = ref;
          moveToGroup(own, refs, [], target, { kind, id, side: isBefore ? 'before' : 'after' });
          const order = siblingsIn(own.document, 'objects', target);
          const at = refs.map((moved) => order.indexOf(moved.id)).sort((a, b) => a - b);
          // Together, and nothing lost.
          expect(at).toEqual(at.map((_, i) => at[0]! + i));
          expect(Object.keys(own.document.objects).sort()).toEqual(
            Object.keys(store.document.objects).sort(),
          );
        },
      ),
      { numRuns: 60 },
    );
  });
});
