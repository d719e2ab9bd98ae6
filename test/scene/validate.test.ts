import { afterEach, describe, expect, it, vi } from 'vitest';
import { parseDocument } from '../../src/scene/document.ts';
import { type Document, objectShape, type SceneObject } from '../../src/scene/schema.ts';
import { duplicateEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { place } from '../../src/scene/transform-commands.ts';
import { documentIssues } from '../../src/scene/validate.ts';

const COUNT = 50;
const document = parseDocument(
  {
    format: 'irradia',
    version: 1,
    materials: { m: { name: 'm', model: 'principled' } },
    objects: Object.fromEntries(
      Array.from({ length: COUNT }, (_, i) => [
        `o${i}`,
        { name: `O ${i}`, material: 'm', position: [i, 0, 0], geometry: { type: 'sphere', radius: 1 } },
      ]),
    ),
  },
  'test',
);
const refs = Object.keys(document.objects).map((id) => ({ kind: 'objects', id }) as const);

const withObject = (id: string, object: unknown): Document => ({
  ...document,
  objects: { ...document.objects, [id]: object as SceneObject },
});

afterEach(() => vi.restoreAllMocks());

describe('what an edit has to prove of objects', () => {
  const own = document.objects.o3 as SceneObject;
  it.each<[string, unknown]>([
    ['nothing', null],
    ['a list', [own]],
    ['a field more', { ...own, more: 1 }],
    ['a field less', { ...own, name: undefined }],
    ['no such field at all', Object.fromEntries(Object.entries(own).filter(([name]) => name !== 'scale'))],
    ['another field instead', { ...own, scale: undefined, size: [1, 1, 1] }],
    ['two numbers', { ...own, position: [1, 2] }],
    ['no number', { ...own, position: [1, 2, Number.NaN] }],
    ['a number too large', { ...own, rotation: [1e5, 0, 0] }],
    ['a text', { ...own, visible: 'true' }],
    ['a value of another field', { ...own, material: own.geometry }],
    ['a shape with a hole', { ...own, geometry: { ...own.geometry, radius: undefined } }],
    ['an inherited field', Object.assign(Object.create({ scale: [1, 1, 1] }), { ...own, scale: undefined })],
    ['a material that is not there', { ...own, material: 'other' }],
  ])('%s: an object is refused as it is in a whole document', (_, object) => {
    for (const id of ['o3', 'new']) {
      const issues = documentIssues(withObject(id, object));
      expect(issues).not.toEqual([]);
      expect(documentIssues(withObject(id, object), document)).toEqual(issues);
    }
  });

  it('is what it changed, and of copies what is not their original’s', () => {
    const asked = Object.entries(objectShape).map(
      ([name, schema]) => [name, vi.spyOn(schema, 'safeParse')] as const,
    );
    const counts = () =>
      Object.fromEntries(asked.map(([name, { mock }]) => [name, mock.calls.length]).filter(([, n]) => n));
    const store = new DocumentStore(document);
    place(
      store,
      'Move',
      refs.map((ref, i) => ({ ...ref, placement: { position: [i, 1, 0] } })),
    );
    expect(counts()).toEqual({ position: COUNT });
    vi.clearAllMocks();
    duplicateEntities(store, refs);
    expect(counts()).toEqual({ name: COUNT });
    expect(documentIssues(store.document)).toEqual([]);
  });
});
