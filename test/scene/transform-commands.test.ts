/** Moving many things at once, and taking a drag back. */
import { expect, it } from 'vitest';
import { addLight, addObject, setField } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { place } from '../../src/scene/transform-commands.ts';

function scene() {
  const store = new DocumentStore(createDocument());
  const box = addObject(store, 'box');
  const spot = addLight(store, 'spot');
  const point = addLight(store, 'point');
  return { store, box, spot, point };
}

it('places objects and lights in one step, each with what it has', () => {
  const { store, box, spot, point } = scene();
  const before = store.document;
  place(store, 'Move 3 things', [
    { kind: 'objects', id: box, placement: { position: [1, 2, 3], rotation: [0, 90, 0] } },
    { kind: 'lights', id: spot, placement: { position: [4, 5, 6], target: [0, 1, 0] } },
    // A point light has no target.
    { kind: 'lights', id: point, placement: { position: [7, 8, 9], target: [0, 1, 0] } },
  ]);
  const { objects, lights } = store.document;
  expect(objects[box]).toMatchObject({ position: [1, 2, 3], rotation: [0, 90, 0] });
  expect(lights[spot]).toMatchObject({ position: [4, 5, 6], target: [0, 1, 0] });
  expect(lights[point]).toMatchObject({ position: [7, 8, 9] });
  expect(lights[point]).not.toHaveProperty('target');
  store.undo();
  expect(store.document).toBe(before);
});

it('a drag is one step; one that is abandoned was never there, and what could be redone still can', () => {
  const { store, box } = scene();
  const start = store.document;
  setField(store, ['objects', box, 'name'], 'Crate');
  const renamed = store.document;
  store.undo();
  const drag = (x: number) =>
    place(store, 'Move box', [{ kind: 'objects', id: box, placement: { position: [x, 0, 0] } }], 'drag');
  drag(1);
  drag(2);
  expect(store.canRedo).toBe(false);
  store.abandon('another drag');
  expect(store.document.objects[box]?.position).toEqual([2, 0, 0]);
  store.abandon('drag');
  expect(store.document).toBe(start);
  store.redo();
  expect(store.document).toBe(renamed);
  drag(3);
  drag(4);
  store.endMerge();
  store.abandon('drag');
  expect(store.document.objects[box]?.position).toEqual([4, 0, 0]);
  store.undo();
  expect(store.document).toBe(renamed);
});

it('an abandoned drag tells whoever follows the document', () => {
  const { store, box } = scene();
  const before = store.document;
  place(store, 'Move box', [{ kind: 'objects', id: box, placement: { position: [1, 0, 0] } }], 'drag');
  const seen: unknown[] = [];
  store.subscribe(({ document }) => seen.push(document));
  store.abandon('drag');
  expect(seen).toEqual([before]);
});
