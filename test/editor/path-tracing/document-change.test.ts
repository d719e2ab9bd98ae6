import { expect, it } from 'vitest';
import { applyChange, changeOf, sameScene } from '../../../src/editor/path-tracing/document-change.ts';
import { addLight, addObject, rename } from '../../../src/scene/commands.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { groupEntities, shift } from '../../../src/scene/group-commands.ts';
import { removeEntities, setLocked, setVisible } from '../../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

function scene() {
  const store = new DocumentStore(createDocument());
  addLight(store, 'point');
  addLight(store, 'directional');
  addObject(store, 'sphere');
  addObject(store, 'box');
  return store;
}

it('a whole document is sent once, an edit only as what it changed; unsent entries stay the same objects', () => {
  const store = scene();
  const first = store.document;
  // As a message to another thread copies it.
  const there = applyChange(null, structuredClone(changeOf(null, first)));
  expect(there).toEqual(first);

  const [light = ''] = Object.keys(first.lights);
  store.edit('Name', (draft) => {
    draft.lights[light]!.name = 'Lamp';
  });
  const change = changeOf(first, store.document);
  expect(change.singles).toEqual({});
  expect(change.collections).toEqual({
    lights: Object.entries(store.document.lights).map(([id, entry]) => (id === light ? [id, entry] : [id])),
  });
  const next = applyChange(there, structuredClone(change));
  expect(next).toEqual(store.document);
  expect(next.objects).toBe(there.objects);
  const other = Object.keys(first.lights)[1]!;
  expect(next.lights[other]).toBe(there.lights[other]);
});

it('takes entries away, and keeps their order', () => {
  const store = scene();
  const before = store.document;
  store.edit('Turn the order', (draft) => {
    const entries = Object.entries(draft.lights).reverse();
    draft.lights = Object.fromEntries(entries);
  });
  const [first = ''] = Object.keys(store.document.lights);
  const turned = applyChange(before, structuredClone(changeOf(before, store.document)));
  expect(Object.keys(turned.lights)).toEqual(Object.keys(before.lights).reverse());
  store.edit('Remove', (draft) => {
    delete draft.lights[first];
  });
  const removed = applyChange(before, structuredClone(changeOf(before, store.document)));
  expect(removed).toEqual(store.document);
});

it('exposure, camera and goals are not the scene’s; materials and fog are', () => {
  const store = scene();
  const before = store.document;
  store.edit('Not the scene', (draft) => {
    draft.view.exposure = 2;
    draft.camera.fov = 30;
    draft.pathTracing.samples = 7;
    draft.name = 'Another';
  });
  expect(sameScene(before, store.document)).toBe(true);
  store.edit('Fog', (draft) => {
    draft.fog.density = 0.1;
  });
  expect(sameScene(before, store.document)).toBe(false);
});

it('names, locks, groups and order are for people: nothing is traced anew', () => {
  const store = scene();
  const before = store.document;
  const [first = '', second = ''] = Object.keys(before.objects);
  const refs = [first, second].map((id) => ({ kind: 'objects', id }) as const);
  groupEntities(store, refs);
  setLocked(store, refs, true);
  shift(store, [{ kind: 'lights', id: Object.keys(before.lights)[0] ?? '' }], 1);
  rename(store, 'objects', first, 'Another');
  rename(store, 'materials', Object.keys(before.materials)[0] ?? '', 'Paint');
  expect(store.document).not.toBe(before);
  expect(sameScene(before, store.document)).toBe(true);
  const named = store.document;
  setVisible(store, refs.slice(0, 1), false);
  expect(sameScene(named, store.document)).toBe(false);
  store.undo();
  setLocked(store, refs, false);
  removeEntities(store, refs.slice(1));
  expect(sameScene(named, store.document)).toBe(false);
});
