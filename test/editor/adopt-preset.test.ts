import { expect, test } from 'vitest';
import { PresetOfDevice } from '../../src/editor/viewport/adopt-preset.ts';
import { createDocument } from '../../src/scene/document.ts';
import { applyPreset, presetOf } from '../../src/scene/effect-presets.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

/** A page whose GPU takes so long for a plain frame, and what is done while effects are compiled. */
function page({ milliseconds = 1, adapter = {}, kept = null as object | null, meanwhile = () => {} } = {}) {
  const store = new DocumentStore(createDocument());
  const prepared: Document[] = [];
  let measured = 0;
  const device = {
    adapterInfo: { vendor: 'acme', architecture: '', device: '', description: '', ...adapter },
  };
  const preset = new PresetOfDevice(
    { store, workspace: { kept, amend: (document: Document) => store.open(document) } } as never,
    { three: { backend: { device } } } as never,
    {
      async measureFrame() {
        measured++;
        return milliseconds;
      },
      async prepare(document: Document) {
        prepared.push(document);
        meanwhile();
      },
    } as never,
  );
  return { store, preset, prepared, measured: () => measured };
}

test('a fresh scene gets what the device draws without effort: compiled first, no undo step, measured once', async () => {
  const { store, preset, prepared, measured } = page();
  await preset.adopt(store.document);
  expect(presetOf(store.document.effects)).toBe('high');
  expect(prepared.map(({ effects }) => presetOf(effects))).toEqual(['high']);
  expect(store.canUndo).toBe(false);
  store.open(createDocument());
  await preset.adopt(store.document);
  expect(presetOf(store.document.effects)).toBe('high');
  expect(measured()).toBe(1);
});

test.each([
  { isFallbackAdapter: true },
  { architecture: 'swiftshader' },
  { description: 'llvmpipe (LLVM 15.0.6, 256 bits)' },
])('a GPU made of software keeps the plain frame, unmeasured: %o', async (adapter) => {
  const { store, preset, measured } = page({ adapter });
  const { document } = store;
  await preset.adopt(document);
  expect(store.document).toBe(document);
  expect(measured()).toBe(0);
});

test('a slow device keeps the plain frame', async () => {
  const { store, preset, prepared } = page({ milliseconds: 12 });
  const { document } = store;
  await preset.adopt(document);
  expect(store.document).toBe(document);
  expect(prepared).toEqual([]);
});

test('what somebody kept, changed, or gave effects is left as it is; a look around is kept', async () => {
  const kept = page({ kept: {} });
  await kept.preset.adopt(kept.store.document);
  expect(presetOf(kept.store.document.effects)).toBe('low');

  const own = page();
  applyPreset(own.store, 'medium');
  await own.preset.adopt(own.store.document);
  expect(presetOf(own.store.document.effects)).toBe('medium');

  const changed = page({
    meanwhile: () =>
      changed.store.edit('Rename', (draft) => {
        draft.name = 'Mine';
      }),
  });
  await changed.preset.adopt(changed.store.document);
  expect(presetOf(changed.store.document.effects)).toBe('low');

  const turned = page({
    meanwhile: () =>
      turned.store.edit('Orbit', (draft) => {
        draft.camera.position = [1, 2, 3];
      }),
  });
  await turned.preset.adopt(turned.store.document);
  expect(presetOf(turned.store.document.effects)).toBe('high');
  expect(turned.store.document.camera.position).toEqual([1, 2, 3]);
});
