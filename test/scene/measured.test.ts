import { beforeEach, describe, expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { removeUnused, setField } from '../../src/scene/commands.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentError } from '../../src/scene/error.ts';
import { addMaterial, removeModel, setMaterialModel } from '../../src/scene/material-commands.ts';
import { measuredAsset } from '../../src/scene/measured.ts';
import { addMeasuredModel } from '../../src/scene/measured-commands.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { findModel, modelNames } from '../../src/scene/models.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { writeMerl } from '../io/merl-writer.ts';

const bytes = writeMerl((L, V) => [0.25, 0.1 + L[2] * V[2], 0.5]);
const asset = measuredAsset(bytes, 'folder/grey paint.binary');

let store: DocumentStore;
beforeEach(() => {
  store = new DocumentStore(createDocument());
});

/** What a model's value is along the normal. */
function headOn(name: string): readonly number[] {
  const model = findModel(store.document, name);
  return model ? createEvaluator(model).f([0, 0, 1], [0, 0, 1]) : [];
}

describe('a measured model', () => {
  test('is kept in 12 MB and can be used like any other', () => {
    const name = addMeasuredModel(store, asset);
    expect(name).toBe('grey paint');
    expect(modelNames(store.document)[0]).toBe(name);
    expect(store.document.models[name]).toEqual({ measured: 'grey-paint' });
    expect(asset.data.length).toBeLessThan(12e6);
    expect(headOn(name)[0]).toBeCloseTo(0.25, 3);
    expect(headOn(name)[1]).toBeCloseTo(1.1, 2);
    expect(addMeasuredModel(store, { ...asset })).toBe('grey paint 2');
    // The same bytes are kept once, and read once.
    expect(Object.keys(store.document.assets)).toHaveLength(1);
    expect(findModel(store.document, 'grey paint 2')).toBe(findModel(store.document, name));
  });

  test('is undone and redone, mirrored, saved and read again', () => {
    const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: expect.unreachable });
    store.subscribe(({ document }) => mirror.apply(document));
    const id = addMaterial(store);
    mirror.apply(store.document);
    const name = addMeasuredModel(store, asset);
    setMaterialModel(store, id, name);
    expect(mirror.materialFor(id)?.model.data).toHaveLength(1_458_000 * 3);
    const model = findModel(store.document, name);
    store.undo();
    expect(mirror.materialFor(id)?.model.data).toBeNull();
    store.undo();
    expect([store.document.models, store.document.assets]).toEqual([{}, {}]);
    store.redo();
    store.redo();
    // Its data are not read again.
    expect(mirror.materialFor(id)?.model).toBe(model);
    mirror.dispose();

    const text = serializeDocument(store.document);
    const again = parseDocument(text, 'again.json');
    expect(again).toEqual(store.document);
    const [a, b] = [findModel(again, name), model].map((m) => Buffer.from(m?.data?.buffer as ArrayBuffer));
    expect((a as Buffer).equals(b as Buffer)).toBe(true);
  });

  test('keeps its file among those that are in use', () => {
    const name = addMeasuredModel(store, asset);
    removeUnused(store);
    expect(Object.keys(store.document.assets)).toHaveLength(1);
    removeModel(store, name);
    removeUnused(store);
    expect(store.document.assets).toEqual({});
  });

  test('follows its file when that is replaced', () => {
    const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: expect.unreachable });
    const name = addMeasuredModel(store, asset);
    const id = addMaterial(store, name);
    mirror.apply(store.document);
    const before = mirror.materialFor(id)?.model;
    const darker = measuredAsset(
      writeMerl(() => [0.1, 0.1, 0.1]),
      'dark.binary',
    );
    setField(store, ['assets', 'grey-paint'], darker);
    mirror.apply(store.document);
    expect(mirror.materialFor(id)?.model).not.toBe(before);
    expect(headOn(name)[0]).toBeCloseTo(0.1, 3);
    mirror.dispose();
  });
});

describe('a document with measurements', () => {
  const header = { format: 'irradia', version: 1 };
  const models = { paint: { measured: 'file' } };
  const file = (content: Uint8Array) => ({
    file: {
      name: 'paint.binary',
      mediaType: 'application/octet-stream',
      data: Buffer.from(content).toString('base64'),
    },
  });

  test('may hold the file as it came', () => {
    const document = parseDocument({ ...header, models, assets: file(bytes) }, 'a.json');
    expect(findModel(document, 'paint')?.data?.[0]).toBeCloseTo(0.25, 6);
  });

  test.each<[string, object, RegExp]>([
    ['models.paint.measured', { models }, /there is no asset "file"/],
    [
      'models.paint.measured',
      { models, assets: file(bytes.subarray(0, 1000)) },
      /paint\.binary: byte 1000: /,
    ],
    ['models.paint', { models: { paint: {} } }, /expected \{ source \} or \{ measured \}/],
    ['models.paint', { models: { paint: { ...models.paint, source: '' } } }, /expected \{ source \} or/],
  ])('that is wrong at %s is refused', (path, content, message) => {
    let error: unknown;
    try {
      parseDocument({ ...header, ...content }, 'a.json');
    } catch (caught) {
      error = caught;
    }
    expect(error).toBeInstanceOf(DocumentError);
    expect(error).toMatchObject({ path, message: expect.stringMatching(message) });
  });

  test('does not lose the file while a model names it', () => {
    addMeasuredModel(store, asset);
    const remove = () =>
      store.edit('Delete the file', (draft) => {
        delete draft.assets['grey-paint'];
      });
    expect(remove).toThrow(/models\["grey paint"\]\.measured: there is no asset "grey-paint"/);
  });
});
