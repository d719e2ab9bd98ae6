/** Where rows land that are dragged in the outliner, by the row under the pointer and where in it. */
import { describe, expect, test } from 'vitest';
import { type Dragged, landingAt } from '../../src/editor/panels/outliner/landing.ts';
import { treeRows } from '../../src/editor/panels/outliner/tree.ts';
import { parseDocument } from '../../src/scene/document.ts';

const box = (group: string | null = null) => ({ material: 'm', geometry: { type: 'box' }, group });
const document = parseDocument(
  {
    format: 'irradia',
    version: 1,
    materials: { m: { name: 'm', model: 'lambert' }, n: { name: 'n', model: 'lambert' } },
    groups: { g: { name: 'g' }, h: { name: 'h' }, k: { name: 'k', parent: 'g' } },
    lights: { lamp: { type: 'point' } },
    objects: { a: box(), b: box(), p: box('k'), q: box('k'), r: box('h') },
  },
  'test',
);
const nothing: Dragged = { groups: [], members: [], materials: [] };
const objects = (...ids: string[]): Dragged => ({
  ...nothing,
  members: ids.map((id) => ({ kind: 'objects', id })),
});
const groups = (...ids: string[]): Dragged => ({ ...nothing, groups: ids });

function at(key: string, y: number, dragged: Dragged, folded: string[] = [], level = 9): string {
  const rows = treeRows(document, { folded: new Set(folded), query: '' });
  const index = rows.findIndex((row) => row.key === key);
  const found = landingAt(document, rows, index, { y, level }, dragged);
  if (found === null) return 'nowhere';
  const { group, beside, mark } = found;
  const shown = 'row' in mark ? `around ${mark.row}` : `line above ${rows[mark.line]?.key} at ${mark.level}`;
  return `in ${group}, ${beside ? `${beside.side} ${beside.id}` : 'last'}; ${shown}`;
}

describe('things', () => {
  test('land before or behind one of their kind, where the line is', () => {
    expect(at('objects/b', 0.2, objects('a'))).toBe('in null, before b; line above objects/b at 2');
    expect(at('objects/a', 0.8, objects('p'))).toBe('in null, after a; line above objects/b at 2');
    expect(at('objects/q', 0.8, objects('a'))).toBe('in k, after q; line above groups/h at 4');
  });

  test('land in a group on its row, and out of all groups on a title', () => {
    for (const y of [0.1, 0.5, 0.9])
      expect(at('groups/g', y, objects('a'))).toBe('in g, last; around groups/g');
    expect(at('section/objects', 0.5, objects('p'))).toBe('in null, last; around section/objects');
  });

  test('land among their own kind on a row of another', () => {
    expect(at('lights/lamp', 0.5, objects('p'))).toBe('in null, last; around section/objects');
    expect(at('lights/lamp', 0.5, objects('a'))).toBe('nowhere');
  });

  test('land nowhere on what has no place for them', () => {
    for (const key of ['scene', 'section/materials', 'materials/m'])
      expect(at(key, 0.5, objects('a'))).toBe('nowhere');
  });
});

describe('groups', () => {
  test('land beside the edges of a group, in its middle within', () => {
    expect(at('groups/g', 0.1, groups('h'))).toBe('in null, before g; line above groups/g at 2');
    expect(at('groups/g', 0.5, groups('h'))).toBe('in g, last; around groups/g');
    // Below an open group is before the first thing in it, below a folded one behind it.
    expect(at('groups/g', 0.9, groups('h'))).toBe('in g, before k; line above groups/k at 3');
    expect(at('groups/g', 0.9, groups('h'), ['groups/g'])).toBe('in null, after g; line above groups/h at 2');
  });

  test('land behind a group to the left of its last thing, as far out as the pointer', () => {
    expect(at('objects/q', 0.9, groups('h'), [], 3)).toBe('in g, after k; line above groups/h at 3');
    expect(at('objects/q', 0.9, groups('h'), [], 1)).toBe('in null, after g; line above groups/h at 2');
    expect(at('objects/q', 0.9, groups('h'), [], 4)).toBe('in k, last; around groups/k');
    expect(at('objects/p', 0.9, groups('h'), [], 1)).toBe('in k, last; around groups/k');
  });

  test('land nowhere in themselves', () => {
    expect(at('groups/k', 0.5, groups('g'))).toBe('nowhere');
    expect(at('objects/q', 0.5, groups('g'))).toBe('nowhere');
  });
});

test('materials land beside materials alone', () => {
  const dragged = { ...nothing, materials: ['n'] };
  expect(at('materials/m', 0.2, dragged)).toBe('in null, before m; line above materials/m at 2');
  expect(at('objects/a', 0.2, dragged)).toBe('nowhere');
  expect(at('materials/m', 0.2, { ...objects('a'), materials: ['n'] })).toBe('nowhere');
});
