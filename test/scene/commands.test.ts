import fc from 'fast-check';
import { beforeEach, describe, expect, test, vi } from 'vitest';
import { loadScene } from '../../scenes/index.ts';
import { addLight, addObject, setField, setGeometryType, setLightType } from '../../src/scene/commands.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentError } from '../../src/scene/error.ts';
import { geometryDefaults } from '../../src/scene/geometry-schema.ts';
import {
  addMaterial,
  addModel,
  removeModel,
  setMaterialModel,
  setParameter,
  setTexture,
} from '../../src/scene/material-commands.ts';
import { textureRef } from '../../src/scene/material-schema.ts';
import { modelNames } from '../../src/scene/models.ts';
import { removeEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { act, everyCommand, flat, type SceneCommand } from './every-command.ts';

let store: DocumentStore;
beforeEach(() => {
  store = new DocumentStore(createDocument());
});

describe('lights', () => {
  test('get free ids and names', () => {
    expect([addLight(store, 'spot'), addLight(store, 'spot')]).toEqual(['spot', 'spot-2']);
    expect(Object.values(store.document.lights).map(({ name }) => name)).toEqual([
      'Spot light',
      'Spot light 2',
    ]);
    expect(store.undoLabel).toBe('Add spot light');
  });

  test('of another type keep what both types have', () => {
    const id = addLight(store, 'point', { intensity: 3, position: [1, 2, 3] });
    setLightType(store, id, 'spot');
    expect(store.document.lights[id]).toMatchObject({
      type: 'spot',
      intensity: 3,
      position: [1, 2, 3],
      cutoff: 30,
    });
  });
});

describe('objects', () => {
  test('bring a material of their own, or share one', () => {
    const box = addObject(store, 'box');
    const { material } = store.document.objects[box]!;
    const cone = addObject(store, 'cone', material);
    expect(Object.keys(store.document.materials)).toEqual([material]);
    expect(store.document.objects[cone]).toMatchObject({
      material,
      geometry: geometryDefaults.cone,
      name: 'Cone',
    });
    store.undo();
    store.undo();
    expect(store.document).toEqual(createDocument());
  });

  test('of another geometry keep what both have', () => {
    const id = addObject(store, 'cylinder');
    setField(store, ['objects', id, 'geometry', 'height'], 3);
    setGeometryType(store, id, 'cone');
    expect(store.document.objects[id]?.geometry).toEqual({ ...geometryDefaults.cone, height: 3 });
  });
});

describe('materials', () => {
  test('of another model keep what it can show of their look', () => {
    const id = addMaterial(store, 'principled');
    setParameter(store, id, 'roughness', 0.9);
    setParameter(store, id, 'baseColor', [1, 0, 0]);
    store.edit('Look at the sheen', (draft) => {
      draft.view.term = { material: id, name: 'sheenLobe' };
    });
    setMaterialModel(store, id, 'cook-torrance');
    expect(store.document.materials[id]).toMatchObject({
      model: 'cook-torrance',
      // A slope of .9^2, and the same colour by its other name.
      parameters: { roughness: 0.81, albedo: [1, 0, 0] },
    });
    expect(store.document.materials[id]?.parameters).not.toHaveProperty('baseColor');
    expect(store.document.view.term).toBeNull();
  });

  test('take the model’s default again when a parameter is reset', () => {
    const id = addMaterial(store);
    setParameter(store, id, 'metallic', 1);
    setParameter(store, id, 'metallic', null);
    expect(store.document.materials[id]?.parameters).toEqual({});
  });

  test('refuse parameters, values, textures and models that do not exist', () => {
    const id = addMaterial(store);
    const before = store.document;
    expect(() => setParameter(store, id, 'shine', 1)).toThrow(/shine.*no such parameter/);
    expect(() => setParameter(store, id, 'roughness', Number.NaN)).toThrow(/roughness/);
    expect(() => setTexture(store, id, 'roughness', textureRef('nothing'))).toThrow(/nothing/);
    expect(() => setMaterialModel(store, id, 'phong')).toThrow(/phong/);
    expect(store.document).toBe(before);
  });

  test('leave their objects to another one when they are deleted', () => {
    const box = addObject(store, 'box');
    const own = store.document.objects[box]!.material;
    const other = addMaterial(store);
    removeEntities(store, [{ kind: 'materials', id: own }]);
    expect(store.document.objects[box]?.material).toBe(other);
    removeEntities(store, [{ kind: 'materials', id: other }]);
    expect(Object.keys(store.document.materials)).toEqual([store.document.objects[box]?.material]);
  });
});

describe('models', () => {
  test('of a person come in under a free name and can be used', () => {
    const name = addModel(store, 'somewhere/lambert.brdf', flat);
    expect(name).toBe('lambert 2');
    const id = addMaterial(store, name);
    setParameter(store, id, 'level', 2);
    expect(modelNames(store.document)[0]).toBe(name);
    expect(() => removeModel(store, name)).toThrow(/model/);
  });

  test('that do not compile are refused with file and line', () => {
    const broken = flat.replace('return', 'retrun');
    expect(() => addModel(store, 'flat.brdf', broken)).toThrow(/flat\.brdf:\d+/);
    expect(store.document.models).toEqual({});
    expect(store.canUndo).toBe(false);
  });
});

describe('DocumentStore', () => {
  test('makes one step of a drag, until it ends', () => {
    const id = addLight(store, 'point');
    const path = ['lights', id, 'intensity'];
    for (const value of [1, 2, 3]) setField(store, path, value);
    store.endMerge();
    setField(store, path, 4);
    store.undo();
    expect(store.document.lights[id]).toMatchObject({ intensity: 3 });
    store.undo();
    expect(store.document.lights[id]).toMatchObject({ intensity: 8 });
    expect(store.undoLabel).toBe('Add point light');
    expect(store.redoLabel).toBe('Change intensity');
  });

  test('changes nothing when a recipe throws or its result is not valid', () => {
    const id = addLight(store, 'point');
    const before = store.document;
    const listener = vi.fn();
    store.subscribe(listener);
    expect(() =>
      store.edit('Half an edit', (draft) => {
        draft.name = 'Changed';
        throw new Error('no');
      }),
    ).toThrow('no');
    expect(() => setField(store, ['lights', id, 'intensity'], -1)).toThrow(DocumentError);
    expect(() => setField(store, ['lights', id, 'nothing'], 1)).toThrow(/does not exist/);
    expect(() =>
      store.edit('Lose a field', (draft) => delete (draft as Partial<typeof draft>).camera),
    ).toThrow(/camera/);
    expect(store.document).toBe(before);
    expect(store.undoLabel).toBe('Add point light');
    expect(listener).not.toHaveBeenCalled();
  });

  test('has no step for an edit that changes nothing, and no redo after a new edit', () => {
    addLight(store, 'point');
    store.edit('Nothing', () => {});
    expect(store.undoLabel).toBe('Add point light');
    store.undo();
    addLight(store, 'spot');
    expect(store.canRedo).toBe(false);
  });

  test('shares what an edit did not touch', () => {
    const [a, b] = [addObject(store, 'box'), addObject(store, 'cone')];
    const before = store.document;
    setField(store, ['objects', a, 'position', 0], 1);
    expect(store.document.objects[b]).toBe(before.objects[b]);
    expect(store.document.materials).toBe(before.materials);
    expect(store.document.objects[a]).not.toBe(before.objects[a]);
  });

  test('tells its listeners what happened', () => {
    const events: string[] = [];
    const stop = store.subscribe(({ reason, label }) => events.push(`${reason}: ${label}`));
    addLight(store, 'ambient');
    store.undo();
    store.redo();
    store.open(createDocument('Other'));
    stop();
    addLight(store, 'ambient');
    expect(events).toEqual([
      'edit: Add ambient light',
      'undo: Add ambient light',
      'redo: Add ambient light',
      'open: Open Other',
    ]);
  });
});

const steps: readonly SceneCommand[] = [
  (target) => target.undo(),
  (target) => target.undo(),
  (target) => target.redo(),
];

/** What was done and undone: 16 commands, each with the numbers that choose what it is done to. */
const histories = fc.array(
  fc.tuple(
    fc.nat(everyCommand.length + steps.length - 1),
    fc.array(fc.nat(), { minLength: 3, maxLength: 3 }),
  ),
  { maxLength: 16 },
);

test('whatever is done and undone, a file holds the document, and saving it again gives the same bytes', async () => {
  const scene = await loadScene('thesis');
  fc.assert(
    fc.property(histories, (history) => {
      const target = new DocumentStore(scene);
      for (const [action, numbers] of history) {
        act(target, [...everyCommand, ...steps][action], numbers);
        const text = serializeDocument(target.document);
        const opened = parseDocument(text, 'again.json');
        expect(serializeDocument(opened)).toBe(text);
        expect(opened).toEqual(positiveZero(target.document));
      }
    }),
    { numRuns: 25 },
  );
});

/** With 0 for -0, which is what JSON makes of it. */
const positiveZero = (document: unknown): unknown => JSON.parse(JSON.stringify(document));

test('whatever is done, undo and redo bring back the exact documents', async () => {
  const scene = await loadScene('thesis');
  fc.assert(
    fc.property(histories, (history) => {
      const target = new DocumentStore(scene);
      const texts = [serializeDocument(scene)];
      for (const [action, numbers] of history) {
        // Undone and redone below.
        if (action >= everyCommand.length) continue;
        const before = target.document;
        act(target, [...everyCommand, ...steps][action], numbers);
        if (target.document !== before) texts.push(serializeDocument(target.document));
      }
      // The result is a document that a file can hold.
      const last = texts.at(-1)!;
      expect(serializeDocument(parseDocument(last, 'again.json'))).toBe(last);
      for (const text of texts.slice(0, -1).reverse()) {
        target.undo();
        expect(serializeDocument(target.document)).toBe(text);
      }
      expect(target.document).toBe(scene);
      expect(target.canUndo).toBe(false);
      for (const text of texts.slice(1)) {
        target.redo();
        expect(serializeDocument(target.document)).toBe(text);
      }
      expect(target.canRedo).toBe(false);
    }),
    { numRuns: 30 },
  );
});
