/** A model's source in the document, as it is being written. */
import { describe, expect, it } from 'vitest';
import { directiveOffers, offersInGlsl } from '../../src/editor/panels/source/completions.ts';
import {
  applySource,
  copyShipped,
  faultOf,
  type Remembered,
  sourceOf,
} from '../../src/editor/panels/source/edit-model.ts';
import { createDocument } from '../../src/scene/document.ts';
import { addMaterial } from '../../src/scene/material-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const model = (parameters: string, value: string) => `analytic
# A test
::begin parameters
${parameters}
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    return vec3(${value});
}
::end shader
`;

describe('the fault of a text', () => {
  it('is at its line and column, without the name of the file', () => {
    expect(faultOf(model('float a 0 1 .5', 'a'), 'm')).toBeNull();
    const fault = faultOf(model('float a 0 1 .5', 'missing'), 'm');
    expect(fault).toMatchObject({ line: 8, column: 17 });
    expect(fault?.message).toMatch(/^[^:]*missing/);
  });

  it('in an included file is where it is included', () => {
    const text = model('float a 0 1 .5', 'a').replace('vec3 BRDF', '::include lib/nothing.glsl\nvec3 BRDF');
    expect(faultOf(text, 'm')).toMatchObject({ line: 7 });
  });
});

describe('editing', () => {
  const start = () => {
    const store = new DocumentStore(createDocument());
    const material = addMaterial(store, 'lambert');
    return { store, material, name: copyShipped(store, material) };
  };

  it('begins with a copy of a model that ships: one step', () => {
    const { store, material, name } = start();
    expect(store.document.materials[material]?.model).toBe(name);
    expect(sourceOf(store.document, name)).toBe(sourceOf(store.document, 'lambert'));
    store.undo();
    expect(store.document.materials[material]?.model).toBe('lambert');
    expect(store.document.models).toEqual({});
  });

  it('is one step for all that was typed in a row', () => {
    const { store, name } = start();
    const before = sourceOf(store.document, name);
    const remembered: Remembered = new Map();
    for (const value of ['a', '2.0 * a', '3.0 * a'])
      applySource(store, name, model('float a 0 1 .5', value), 'typing', remembered);
    expect(sourceOf(store.document, name)).toContain('3.0 * a');
    store.undo();
    expect(sourceOf(store.document, name)).toBe(before);
  });

  it('gives a parameter its value back when its line comes back, and not when its type is another', () => {
    const { store, material, name } = start();
    const remembered: Remembered = new Map();
    const apply = (parameters: string) => applySource(store, name, model(parameters, '1.0'), 'k', remembered);
    apply('float a 0 1 .5\nfloat b 0 1 .5');
    store.edit('Set', (draft) => {
      draft.materials[material]!.parameters = { a: 0.25, b: 0.75 };
    });
    const values = () => store.document.materials[material]?.parameters;
    apply('float b 0 1 .5');
    expect(values()).toEqual({ b: 0.75 });
    apply('color a 1 1 1\nfloat b 0 1 .5');
    expect(values()).toEqual({ b: 0.75 });
    apply('float a 0 1 .5\nfloat b 0 1 .5');
    expect(values()).toEqual({ a: 0.25, b: 0.75 });
  });
});

describe('completion', () => {
  it('knows parameters, functions of the file and the library with their comments, and GLSL', () => {
    const text = `${model('float a 0 1 .5', 'a')}\n// Twice.\nfloat twice(float x) {\n return 2.0 * x;\n}\n`;
    const offers = offersInGlsl(text, [
      { type: 'float', name: 'a', min: 0, max: 1, default: 0.5, description: 'What it does.' },
    ]);
    const offer = (label: string) => offers.find((each) => each.label === label);
    expect(offer('a')).toMatchObject({ kind: 'property', info: 'What it does.' });
    expect(offer('twice')).toMatchObject({ kind: 'function', detail: '(float x) float', info: 'Twice.' });
    expect(offer('F_Schlick')?.info).toMatch(/The reflectance[\s\S]*lib\/schlick\.glsl/);
    expect(offer('smoothstep')?.kind).toBe('function');
    expect(new Set(offers.map(({ label }) => label)).size).toBe(offers.length);
    expect(directiveOffers().map(({ label }) => label)).toContain('::include lib/schlick.glsl');
  });
});
