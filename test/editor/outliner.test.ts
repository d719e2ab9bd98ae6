import { beforeEach, describe, expect, test } from 'vitest';
import { between, chosenIn, entitiesOf, toggled } from '../../src/editor/panels/outliner/selecting.ts';
import { type TreeRow, treeRows } from '../../src/editor/panels/outliner/tree.ts';
import { matchScore, plain } from '../../src/editor/panels/palette/fuzzy.ts';
import { findItems, type PaletteItem } from '../../src/editor/panels/palette/items.ts';
import { addLight, addObject } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import type { EntityRef } from '../../src/scene/entity.ts';
import { groupEntities } from '../../src/scene/group-commands.ts';
import { setLocked } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

let store: DocumentStore;
let box: EntityRef;
let cone: EntityRef;
let lamp: EntityRef;
let inner: string;
let outer: string;

/** A cube in a group in a group with a lamp; a cone. */
beforeEach(() => {
  store = new DocumentStore(createDocument());
  box = { kind: 'objects', id: addObject(store, 'box') };
  cone = { kind: 'objects', id: addObject(store, 'cone') };
  lamp = { kind: 'lights', id: addLight(store, 'point') };
  inner = groupEntities(store, [box], 'Inner');
  outer = groupEntities(store, [box, lamp], 'Outer');
});

const rowsOf = (query = '', folded: readonly string[] = []) =>
  treeRows(store.document, { query, folded: new Set(folded) });
const outline = (rows: readonly TreeRow[]) =>
  rows.map(({ level, name }) => `${'  '.repeat(level - 1)}${name}`);

describe('the rows of the outliner', () => {
  test('are groups with what is in them, then the rest by kind', () => {
    expect(outline(rowsOf())).toEqual([
      'Scene',
      'Groups',
      '  Outer',
      '    Inner',
      '      Cube',
      '    Point light',
      'Lights',
      'Objects',
      '  Cone',
      'Materials',
      '  Cube',
      '  Cone',
    ]);
    const light = rowsOf().find(({ name }) => name === 'Point light');
    expect(light).toMatchObject({ level: 3, position: 2, siblings: 2, expanded: null, visible: true });
  });

  test('are not there below what is folded', () => {
    expect(outline(rowsOf('', [`groups/${outer}`, 'section/materials']))).toEqual([
      'Scene',
      'Groups',
      '  Outer',
      'Lights',
      'Objects',
      '  Cone',
      'Materials',
    ]);
  });

  test('are those that are searched for by name, kind or state, with the groups around them', () => {
    expect(outline(rowsOf('cube object', [`groups/${outer}`]))).toEqual([
      'Groups',
      '  Outer',
      '    Inner',
      '      Cube',
    ]);
    expect(outline(rowsOf('outer')).filter((line) => line.startsWith('  '))).toHaveLength(4);
    setLocked(store, [{ kind: 'lights', id: lamp.id }], true);
    expect(rowsOf('locked').find(({ level }) => level === 3)).toMatchObject({
      name: 'Point light',
      locked: true,
    });
    expect(rowsOf('nothing is called that')).toEqual([]);
  });

  test('tell whether what is in a group is hidden and locked', () => {
    const row = () => rowsOf().find(({ name }) => name === 'Outer');
    expect(row()).toMatchObject({ visible: true, locked: false });
    setLocked(
      store,
      [
        { kind: 'lights', id: lamp.id },
        { kind: 'objects', id: box.id },
      ],
      true,
    );
    expect(row()).toMatchObject({ locked: true });
  });
});

describe('what rows select', () => {
  test('is all from one to another, each once', () => {
    const rows = rowsOf();
    const at = (name: string) => rows.findIndex((row) => row.name === name);
    expect(between(store.document, rows, at('Outer'), at('Point light'))).toEqual([box, lamp]);
    expect(between(store.document, rows, at('Cone'), at('Point light'))).toEqual([cone, lamp]);
    expect(entitiesOf(store.document, rows[at('Objects')]!.target)).toEqual([]);
  });

  test('is taken away where all of it is there, else added', () => {
    expect(toggled([cone], [box, lamp])).toEqual([cone, box, lamp]);
    expect(toggled([box, cone], [box, lamp])).toEqual([cone, box, lamp]);
    expect(toggled([box, cone, lamp], [box, lamp])).toEqual([cone]);
  });

  test('shows in groups, wholly or partly', () => {
    const chosen = chosenIn(store.document, [box]);
    expect(chosen({ type: 'group', id: inner })).toBe('all');
    expect(chosen({ type: 'group', id: outer })).toBe('some');
    expect(chosen({ type: 'scene' })).toBe('none');
  });
});

describe('the command palette', () => {
  const item = (title: string, kind = ''): PaletteItem => ({
    title,
    kind,
    icon: null,
    text: plain(`${title} ${kind}`),
    run: () => undefined,
  });
  const find = (query: string, ...titles: string[]) =>
    findItems(
      titles.map((title) => item(title)),
      query,
      10,
    ).map(({ title }) => title);

  test('finds letters in their order, at the beginnings of words first', () => {
    expect(find('gr', 'Gold sphere', 'Ungroup', 'Group', 'Copy')).toEqual([
      'Group',
      'Ungroup',
      'Gold sphere',
    ]);
    expect(find('ac', 'Black', 'Add cone')).toEqual(['Add cone', 'Black']);
    expect(find('cone add', 'Add cone', 'Add cube')).toEqual(['Add cone']);
    expect(find('', 'B', 'A')).toEqual(['B', 'A']);
  });

  test('knows no case and no accents, and puts titles before kinds', () => {
    expect(find('CAMARA', 'Mover la cámara')).toHaveLength(1);
    const kinds = findItems([item('Ring', 'gold'), item('Gold sphere')], 'gold', 10);
    expect(kinds.map(({ title }) => title)).toEqual(['Gold sphere', 'Ring']);
    expect(matchScore('xyz', 'y x z')).toBeNull();
  });

  test('has what cannot be done now last, and only where it is looked for', () => {
    const items = [{ ...item('Group'), disabled: true }, item('Select all of its group')];
    expect(findItems(items, 'group', 10).map(({ title }) => title)).toEqual([
      'Select all of its group',
      'Group',
    ]);
    expect(findItems(items, '', 10)).toHaveLength(1);
  });
});
