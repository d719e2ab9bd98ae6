import { expect, test } from 'vitest';
import { loadScene, sceneNames } from '../../scenes/index.ts';
import { addLight, addObject, setField } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { addableGeometries } from '../../src/scene/geometry-schema.ts';
import { removeEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const objectAt = (store: DocumentStore, id: string) => store.document.objects[id]!.position;
const lightAt = (store: DocumentStore, id: string) => store.document.lights[id]!;
const positions = (store: DocumentStore) => Object.values(store.document.objects).map((o) => o.position);

test('the first object stands on the ground where the camera looks', () => {
  const store = new DocumentStore(createDocument());
  const id = addObject(store, 'sphere');
  expect(objectAt(store, id)).toEqual([0, 0.5, 0]);
});

test('spheres that are added one by one do not touch, and stay close to each other', () => {
  const store = new DocumentStore(createDocument());
  for (let i = 0; i < 12; i++) addObject(store, 'sphere');
  const all = positions(store);
  for (const [i, [x, y, z]] of all.entries()) {
    expect(y).toBe(0.5);
    expect(Math.hypot(x, z)).toBeLessThan(4);
    for (const [a, b, c] of all.slice(0, i)) expect(Math.hypot(x - a, y - b, z - c)).toBeGreaterThan(1);
  }
});

test('a floor is stood on, whatever its height, and a wall is stood before', () => {
  const store = new DocumentStore(createDocument());
  const floor = addObject(store, 'plane');
  setField(store, ['objects', floor, 'rotation'], [-90, 0, 0]);
  setField(store, ['objects', floor, 'position'], [0, -1.25, 0]);
  setField(store, ['objects', floor, 'scale'], [20, 20, 1]);
  const wall = addObject(store, 'box');
  setField(store, ['objects', wall, 'rotation'], [0, 90, 0]);
  setField(store, ['objects', wall, 'scale'], [0.2, 6, 12]);
  setField(store, ['objects', wall, 'position'], [0, 1.75, 0]);
  const id = addObject(store, 'cylinder');
  const [x, y, z] = objectAt(store, id);
  expect(y).toBeCloseTo(-0.75, 6);
  expect(Math.abs(z)).toBeGreaterThan(0.6);
  expect(Math.hypot(x, z)).toBeLessThan(2);
});

test('where something was taken away there is room again', () => {
  const store = new DocumentStore(createDocument());
  const first = addObject(store, 'box');
  addObject(store, 'box');
  const position = objectAt(store, first);
  removeEntities(store, [{ kind: 'objects', id: first }]);
  expect(objectAt(store, addObject(store, 'box'))).toEqual(position);
});

test('lights of one type are added side by side', () => {
  const store = new DocumentStore(createDocument());
  const places = Array.from({ length: 5 }, () => {
    const light = lightAt(store, addLight(store, 'spot'));
    return 'position' in light ? light.position : [];
  });
  expect(places[0]).toEqual([0, 4, 2]);
  expect(new Set(places.map(([x]) => x?.toFixed(2)))).toEqual(
    new Set(['0.00', '0.60', '-0.60', '1.20', '-1.20']),
  );
});

test('a light is added where the camera looks, at the given place if one is given', () => {
  const store = new DocumentStore(createDocument());
  setField(store, ['camera', 'target'], [10, 1, -5]);
  const spot = lightAt(store, addLight(store, 'spot'));
  expect(spot).toMatchObject({ position: [10, 4, -3], target: [10, 0, -5] });
  const point = lightAt(store, addLight(store, 'point', { position: [1, 2, 3] }));
  expect(point).toMatchObject({ position: [1, 2, 3] });
});

test('there is a place for everything in every scene that ships', async () => {
  for (const name of sceneNames) {
    const store = new DocumentStore(await loadScene(name));
    for (const type of addableGeometries) {
      const position = objectAt(store, addObject(store, type));
      const [x, , z] = store.document.camera.target;
      expect(position.every(Number.isFinite)).toBe(true);
      expect(Math.hypot(position[0] - x, position[2] - z), `${name}, ${type}: ${position}`).toBeLessThan(30);
    }
  }
});
