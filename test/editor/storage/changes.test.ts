import fc from 'fast-check';
import { expect, it } from 'vitest';
import { loadScene } from '../../../scenes/index.ts';
import { applyChange, type Change, changeBetween } from '../../../src/editor/storage/changes.ts';
import type { StoredDocument } from '../../../src/editor/storage/stored-document.ts';
import { addLight, addObject, setField } from '../../../src/scene/commands.ts';
import { duplicateEntities, removeEntities } from '../../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

const scene = await loadScene('thesis');
// No scene here has assets, so that it is stored as it is.
const stored = (store: DocumentStore) => store.document as unknown as StoredDocument;

const edits: readonly ((store: DocumentStore, at: number) => void)[] = [
  (store) => addObject(store, 'torus'),
  (store) => addLight(store, 'spot'),
  (store, at) => duplicateEntities(store, [{ kind: 'objects', id: pick(store, at) }]),
  (store, at) => removeEntities(store, [{ kind: 'objects', id: pick(store, at) }]),
  (store, at) => setField(store, ['objects', pick(store, at), 'position'], [at, 0, 0]),
  (store, at) => setField(store, ['view', 'exposure'], at % 5),
  (store) => store.undo(),
  (store) => store.redo(),
];

function pick(store: DocumentStore, at: number): string {
  const ids = Object.keys(store.document.objects);
  return ids[at % ids.length] ?? '';
}

it('a text and the changes since are the document, in its own order', () => {
  const step = fc.tuple(fc.nat(edits.length - 1), fc.nat(1000));
  fc.assert(
    fc.property(fc.array(fc.array(step, { maxLength: 3 }), { maxLength: 8 }), (saves) => {
      const store = new DocumentStore(scene);
      let written = stored(store);
      let json = JSON.parse(JSON.stringify(written));
      for (const steps of saves) {
        for (const [which, at] of steps)
          if (Object.keys(store.document.objects).length > 1) edits[which]?.(store, at);
        const change = changeBetween(written, stored(store));
        if (change) json = applyChange(json, JSON.parse(JSON.stringify(change)) as Change);
        written = stored(store);
        expect(JSON.stringify(json)).toBe(JSON.stringify({ ...json, ...written }));
      }
    }),
    { numRuns: 100 },
  );
});

it('one field changes one entity', () => {
  const store = new DocumentStore(scene);
  const before = stored(store);
  setField(store, ['lights', Object.keys(scene.lights)[0] ?? '', 'visible'], false);
  const change = changeBetween(before, stored(store));
  expect(Object.keys(change?.entities ?? {})).toEqual(['lights']);
  expect(Object.keys(change?.entities?.lights ?? {})).toHaveLength(1);
  expect(change?.order).toEqual({});
  expect(changeBetween(before, before)).toBeNull();
});
