/** The code of a material makes that material, with nothing but the package. */
import { afterEach, expect, test, vi } from 'vitest';
import { materialCode } from '../../../src/editor/panels/export/material-code.ts';
import * as irradia from '../../../src/index.ts';
import { createDocument, parseDocument } from '../../../src/scene/document.ts';
import { measuredAsset } from '../../../src/scene/measured.ts';
import { addMeasuredModel } from '../../../src/scene/measured-commands.ts';
import { DocumentStore } from '../../../src/scene/store.ts';
import { writeMerl } from '../../io/merl-writer.ts';

afterEach(() => vi.unstubAllGlobals());

/** Runs what the clipboard has, as a module would. */
async function run(code: string | null): Promise<irradia.BrdfMaterial> {
  const body = (code ?? '').replace(/^import (\{.*?\}) from 'irradia';$/m, 'const $1 = irradia;');
  const AsyncFunction = (async () => {}).constructor as FunctionConstructor;
  return (await AsyncFunction('irradia', `${body}\nreturn material;`)(irradia)) as irradia.BrdfMaterial;
}

const withMaterial = (material: object, models: object = {}) =>
  parseDocument(
    { format: 'irradia', version: 1, materials: { m: { name: 'M', ...material } }, models },
    'd.json',
  );

test.each([...irradia.shippedModels.keys()])(
  'of the model %s, with values that are not the defaults',
  async (model) => {
    const { parameters } = irradia.shippedModels.get(model)!;
    const values = Object.fromEntries(
      parameters.map(({ name, type }) => [
        name,
        type === 'color' ? [0.25, 0.5, 0.75] : type === 'bool' ? true : 0.25,
      ]),
    );
    const document = withMaterial({
      ...{ model, parameters: values, emissive: [1, 0.5, 0], emissiveIntensity: 12, doubleSided: true },
      ...{ alphaMode: 'blend', opacity: 0.5 },
    });
    const material = await run(materialCode(document, 'm'));
    expect(material.model.name).toBe(model);
    for (const { name } of parameters) {
      const found = material.get(name);
      expect(typeof found === 'object' ? [...found] : found).toEqual(values[name]);
    }
    expect(material.emissive.toArray()).toEqual([1, 0.5, 0]);
    expect(material).toMatchObject({ emissiveIntensity: 12, side: 2, transparent: true, opacity: 0.5 });
  },
);

test('of a model of the document’s own, fetched by its name; with a mask', async () => {
  const source =
    '::begin parameters\nfloat k 0 1 .5\n::end parameters\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(k); }\n::end shader\n';
  vi.stubGlobal('fetch', async () => new Response(`analytic\n${source}`));
  const document = withMaterial(
    { model: 'flat', parameters: { k: 0.125 }, alphaMode: 'mask', alphaCutoff: 0.75 },
    { flat: { source: `analytic\n${source}` } },
  );
  const material = await run(materialCode(document, 'm'));
  expect([material.model.name, material.get('k'), material.alphaTest]).toEqual(['flat', 0.125, 0.75]);
});

test('of measurements, fetched by their file', async () => {
  const bytes = writeMerl(() => [0.1, 0.2, 0.3]);
  vi.stubGlobal('fetch', async () => new Response(bytes));
  const store = new DocumentStore(createDocument());
  const model = addMeasuredModel(store, measuredAsset(bytes, 'gold.binary'));
  store.edit('use it', (draft) => {
    draft.materials.m = { ...structuredClone(withMaterial({ model: 'lambert' }).materials.m!), model };
  });
  const code = materialCode(store.document, 'm');
  expect(code).toContain('fetch("gold.binary")');
  expect((await run(code)).model.data).not.toBeNull();
});
