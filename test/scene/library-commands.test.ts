import { describe, expect, test } from 'vitest';
import { addObject, putAsset } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { giveMaterial, putMaterialOnce, setLook, setValues } from '../../src/scene/library-commands.ts';
import { addMaterial, putMaterial } from '../../src/scene/material-commands.ts';
import { textureRef } from '../../src/scene/material-schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

function withSphere() {
  const store = new DocumentStore(createDocument());
  const sphere = addObject(store, 'sphere');
  return { store, sphere, materialOf: () => store.document.objects[sphere]!.material };
}

const gold = { name: 'Gold', parameters: { metallic: 1 }, multipleScattering: true };
const red = { name: 'Red', parameters: { roughness: 0.2 } };

describe('a material from elsewhere', () => {
  test('comes in and is assigned in one step', () => {
    const { store, sphere, materialOf } = withSphere();
    const before = store.document;
    const id = giveMaterial(store, 'Gold', [sphere], { put: (draft) => putMaterial(draft, gold) });
    expect(materialOf()).toBe(id);
    expect(store.document.materials[id]).toMatchObject(gold);
    expect(store.undoLabel).toBe('Assign Gold');
    store.undo();
    expect(store.document).toBe(before);
  });

  test('is there once, however often it is chosen', () => {
    const { store, sphere, materialOf } = withSphere();
    const give = () =>
      giveMaterial(store, 'Gold', [sphere], { put: (draft) => putMaterialOnce(draft, gold) });
    expect(give()).toBe(give());
    const { undoLabel } = store;
    give();
    expect(store.undoLabel).toBe(undoLabel);
    expect(materialOf()).toBe(give());
  });

  test('goes again where it was only tried, and stays where it is used or has been changed', () => {
    const { store, sphere } = withSphere();
    const isTry = ({ name, parameters }: { name: string; parameters: object }) =>
      name === 'Gold' && JSON.stringify(parameters) === JSON.stringify(gold.parameters);
    const give = (values: typeof red, objects: string[]) =>
      giveMaterial(store, values.name, objects, { put: (draft) => putMaterialOnce(draft, values), isTry });
    const tried = give(gold as never, [sphere]);
    give(red, [sphere]);
    expect(store.document.materials[tried]).toBeUndefined();
    const used = give(gold as never, [sphere, addObject(store, 'box')]);
    give(red, [sphere]);
    expect(store.document.materials[used]).toBeDefined();
  });
});

describe('another look', () => {
  test('replaces model, values and textures; the name stays', () => {
    const { store } = withSphere();
    const id = addMaterial(store, 'lambert');
    const { name } = store.document.materials[id]!;
    const look = { model: 'cook-torrance', parameters: { kd: 0.3 }, multipleScattering: true };
    store.edit('Texture', (draft) => {
      draft.materials[id]!.textures.albedo = textureRef(putAsset(draft, 'dots.png', 'image/png', 'AAAA'));
    });
    setLook(store, [id], 'Look', look);
    expect(store.document.materials[id]).toMatchObject({ ...look, name });
    expect(store.document.materials[id]?.textures).toEqual({});
  });

  test('takes the term that is looked at away where the model has none of that name', () => {
    const { store } = withSphere();
    const id = addMaterial(store, 'principled');
    store.edit('Term', (draft) => {
      draft.view.term = { material: id, name: 'sheenLobe' };
    });
    setLook(store, [id], 'Look', { model: 'lambert', parameters: {}, multipleScattering: false });
    expect(store.document.view.term).toBeNull();
  });
});

test('all values at once: defaults are not stored, and values in a row with one key are one step', () => {
  const { store } = withSphere();
  const id = addMaterial(store, 'principled');
  const before = store.document;
  setValues(store, id, 'Blend', { roughness: 0.5, metallic: 0.4 }, 'key');
  setValues(store, id, 'Blend', { roughness: 0.5, metallic: 0.7 }, 'key');
  expect(store.document.materials[id]!.parameters).toEqual({ metallic: 0.7 });
  store.undo();
  expect(store.document).toBe(before);
});
