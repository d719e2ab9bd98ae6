import { expect, test } from 'vitest';
import {
  addMaterialFile,
  isMaterialFile,
  readMaterialFile,
  writeMaterialFile,
} from '../../src/io/material-file.ts';
import { createDocument, parseDocument } from '../../src/scene/document.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const source = `analytic
::begin parameters
color tint 1 1 1 # linear
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return tint / 3.14159265; }
::end shader
`;
const document = parseDocument(
  {
    format: 'irradia',
    version: 1,
    assets: {
      wood: { name: 'wood.png', mediaType: 'image/png', data: 'AAAA' },
      other: { name: 'other.png', mediaType: 'image/png', data: 'BBBB' },
    },
    models: { mine: { source } },
    materials: {
      m: {
        name: 'Mine',
        model: 'mine',
        parameters: { tint: [1, 0, 0] },
        textures: { tint: { asset: 'wood' } },
      },
    },
  },
  'test',
);

test('a material comes with its model and its images, under names that are free', () => {
  const json = JSON.parse(writeMaterialFile(document, 'm'));
  expect(isMaterialFile(json)).toBe(true);
  expect(Object.keys(json.assets)).toEqual(['wood']);
  const store = new DocumentStore({
    ...createDocument(),
    models: { mine: { source: source.replace('1 1 1', '0 0 0') } },
    assets: { wood: { name: 'x', mediaType: 'image/png', data: 'CCCC' } },
  });
  let id = '';
  store.edit('Import', (draft) => {
    id = addMaterialFile(draft, readMaterialFile(json, 'm.json'));
  });
  const added = store.document.materials[id]!;
  expect(added).toMatchObject({ name: 'Mine', parameters: { tint: [1, 0, 0] } });
  expect(store.document.models[added.model]).toEqual({ source });
  expect(added.model).not.toBe('mine');
  expect(store.document.assets[added.textures.tint!.asset]).toMatchObject({ data: 'AAAA' });
});

test('the same material brings no second model and no second image', () => {
  const store = new DocumentStore(document);
  store.edit('Import', (draft) => {
    addMaterialFile(draft, readMaterialFile(JSON.parse(writeMaterialFile(document, 'm')), 'm.json'));
  });
  expect(Object.keys(store.document.models)).toEqual(['mine']);
  expect(Object.keys(store.document.assets)).toEqual(['wood', 'other']);
  expect(Object.values(store.document.materials)[1]).toMatchObject({ model: 'mine' });
});

test.each([
  [{ material: { model: 'nothing' } }, /materials\.material\.model/],
  [{ material: { model: 'lambert', parameters: { albedo: 'red' } } }, /albedo/],
  [{}, /materials\.material/],
  [{ material: { model: 'lambert' }, version: 99 }, /version/],
])('what is wrong is told with its path: %j', (fields, message) => {
  expect(() => readMaterialFile({ format: 'irradia-material', version: 1, ...fields }, 'm.json')).toThrow(
    message,
  );
});
