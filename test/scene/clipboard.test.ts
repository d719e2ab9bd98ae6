import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { loadScene } from '../../scenes/index.ts';
import { copyEntities, isClipboardText, pasteEntities } from '../../src/scene/clipboard.ts';
import { addLight, addObject, putAsset } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import type { EntityRef } from '../../src/scene/entity.ts';
import { DocumentError } from '../../src/scene/error.ts';
import { groupEntities } from '../../src/scene/group-commands.ts';
import { addMaterial, addModel, setTexture } from '../../src/scene/material-commands.ts';
import { textureRef } from '../../src/scene/material-schema.ts';
import { setLocked } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const flat = (level: number) => `analytic
# Flat: the same in every direction.
::begin parameters
float level 0 1 ${level}
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(level); }
::end shader
`;

const empty = () => new DocumentStore(createDocument());

/** A cube of a model of its own, with a picture, and a lamp, in a group. */
function withEverything() {
  const store = empty();
  const model = addModel(store, 'flat.brdf', flat(0.5));
  const material = addMaterial(store, model);
  let asset = '';
  store.edit('Add picture', (draft) => {
    asset = putAsset(draft, 'dots.png', 'image/png', 'AQID');
    putAsset(draft, 'not needed.png', 'image/png', 'BBBB');
  });
  setTexture(store, material, 'level', textureRef(asset));
  const object: EntityRef = { kind: 'objects', id: addObject(store, 'box', material) };
  const lamp: EntityRef = { kind: 'lights', id: addLight(store, 'spot') };
  groupEntities(store, [object, lamp], 'Stage');
  return { store, object, lamp, material };
}

describe('pasting', () => {
  test('into another document brings what is needed, and nothing else', () => {
    const { store, object, lamp } = withEverything();
    setLocked(store, [{ kind: 'objects', id: object.id }], true);
    const text = copyEntities(store.document, [lamp, object]);
    expect(isClipboardText(text)).toBe(true);
    const target = empty();
    const pasted = pasteEntities(target, text);
    expect(pasted.map(({ kind }) => kind)).toEqual(['lights', 'objects']);
    const { objects, lights, groups, materials, models, assets } = target.document;
    const { group, ...cube } = objects[pasted[1]?.id ?? '']!;
    expect(cube).toMatchObject({ name: 'Cube', locked: false, geometry: { type: 'box' } });
    expect(lights[pasted[0]?.id ?? '']?.group).toBe(group);
    expect(groups[group ?? '']).toEqual({ name: 'Stage', parent: null });
    expect(materials[cube.material]).toMatchObject({ model: 'flat' });
    expect(models.flat).toEqual({ source: flat(0.5) });
    expect(Object.values(assets).map(({ name }) => name)).toEqual(['dots.png']);
    expect(target.undoLabel).toBe('Paste 1 light and 1 object');
    target.undo();
    expect(target.document).toEqual(createDocument());
  });

  test('into the same document shares materials, models and files that are there', () => {
    const { store, object, material } = withEverything();
    const before = store.document;
    const [copy] = pasteEntities(store, copyEntities(before, [object]));
    expect(store.document.objects[copy?.id ?? '']).toMatchObject({ name: 'Cube 2', material });
    for (const part of ['materials', 'models', 'assets'] as const)
      expect(Object.keys(store.document[part])).toEqual(Object.keys(before[part]));
    // A material that was copied itself is wanted once more, and an object that was copied with it has the copy.
    const both = pasteEntities(store, copyEntities(before, [object, { kind: 'materials', id: material }]));
    expect(both.map(({ kind }) => kind)).toEqual(['objects', 'materials']);
    expect(store.document.objects[both[0]?.id ?? '']?.material).toBe(both[1]?.id);
    expect(both[1]?.id).not.toBe(material);
  });

  test('gives another name to a model whose name another one has', () => {
    const { store, object } = withEverything();
    const target = empty();
    addModel(target, 'flat.brdf', flat(0.9));
    pasteEntities(target, copyEntities(store.document, [object]));
    expect(target.document.models).toEqual({
      flat: { source: flat(0.9) },
      'flat 2': { source: flat(0.5) },
    });
    expect(Object.values(target.document.materials)[0]?.model).toBe('flat 2');
  });

  test('again and again gives what was copied, whatever was copied', async () => {
    const scene = await loadScene('thesis');
    const all: EntityRef[] = (['lights', 'objects', 'materials'] as const).flatMap((kind) =>
      Object.keys(scene[kind]).map((id) => ({ kind, id })),
    );
    fc.assert(
      fc.property(fc.uniqueArray(fc.nat(all.length - 1), { minLength: 1 }), (indices) => {
        const refs = indices.flatMap((i) => all[i] ?? []);
        const target = empty();
        const text = copyEntities(scene, refs);
        const pasted = pasteEntities(target, text);
        expect(pasted).toHaveLength(refs.length);
        // Copied from there it is the same text, but for what was renamed.
        expect(copyEntities(target.document, pasted)).toHaveLength(text.length);
        refs.forEach(({ kind, id }, i) => {
          const copy = target.document[kind][pasted[i]?.id ?? ''];
          expect(copy?.name).toBe(scene[kind][id]?.name);
        });
      }),
      { numRuns: 25 },
    );
  });
});

describe('a text from elsewhere', () => {
  const text = () => {
    const { store, object, lamp } = withEverything();
    return copyEntities(store.document, [object, lamp]);
  };

  test('is not ours unless it says so', () => {
    for (const other of [
      '',
      'hello',
      '{"format":"irradia","version":1}',
      '[]',
      'x{"format":"irradia-clipboard"',
    ])
      expect(isClipboardText(other)).toBe(false);
  });

  test.each([
    ['{"format":"irradia-clipboard"', 'clipboard: not JSON'],
    ['[]', /not copied from Irradia/],
    ['{"format":"irradia-clipboard","version":2}', /another version/],
    ['{"format":"irradia-clipboard","version":1}', /not an Irradia document/],
    [
      '{"format":"irradia-clipboard","version":1,"document":{"format":"irradia","version":1}}',
      /nothing was copied/,
    ],
    [
      '{"format":"irradia-clipboard","version":1,"document":{"format":"irradia","version":1,"objects":{"a":{"material":"m","geometry":{"type":"box"}}}}}',
      /no material "m"/,
    ],
  ])('is refused: %s', (broken, message) => {
    const target = empty();
    const before = target.document;
    expect(() => pasteEntities(target, broken)).toThrow(message);
    expect(target.document).toBe(before);
  });

  test('whatever is changed in it, is pasted whole or refused whole with a DocumentError', () => {
    const json = JSON.parse(text());
    const paths: (string | number)[][] = [];
    const walk = (value: unknown, path: (string | number)[]) => {
      if (path.length > 0) paths.push(path);
      if (typeof value === 'object' && value !== null)
        for (const [key, child] of Object.entries(value)) walk(child, [...path, key]);
    };
    walk(json, []);
    const values = fc.oneof(
      fc.constantFrom(null, -1, 1e300, '', '__proto__', 'constructor', [], {}, true, 'a'.repeat(300)),
      fc.jsonValue({ maxDepth: 2 }),
    );
    let pasted = 0;
    fc.assert(
      fc.property(fc.constantFrom(...paths), values, (path, value) => {
        const broken = structuredClone(json);
        const holder = path.slice(0, -1).reduce((at, key) => at[key], broken);
        holder[path.at(-1) as string] = value;
        const target = empty();
        const before = target.document;
        try {
          const refs = pasteEntities(target, JSON.stringify(broken));
          expect(refs.length).toBeGreaterThan(0);
          pasted += 1;
          for (const { kind, id } of refs) expect(target.document[kind]).toHaveProperty(id);
        } catch (error) {
          if (!(error instanceof DocumentError)) throw error;
          expect(target.document).toBe(before);
          expect(target.canUndo).toBe(false);
        }
      }),
      { numRuns: 300 },
    );
    expect(pasted).toBeGreaterThan(0);
  });
});
