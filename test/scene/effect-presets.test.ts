import { expect, test } from 'vitest';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import {
  applyPreset,
  hasDefaultEffects,
  presetNames,
  presetOf,
  withPreset,
} from '../../src/scene/effect-presets.ts';
import { effectNames, effectsDefaults } from '../../src/scene/effects-schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

test.each(presetNames)('%s is valid, is recognised, and is one undo step', (name) => {
  const store = new DocumentStore(createDocument());
  store.edit('Something else', (draft) => {
    draft.effects.shadows.samples = 5;
    draft.effects.bloom.strength = 0.123;
  });
  const before = store.document;
  applyPreset(store, name);
  const { document } = store;
  expect(parseDocument(serializeDocument(document), 'preset')).toEqual(document);
  expect(presetOf(document.effects)).toBe(name);
  // Matters of taste stay.
  expect(document.effects.bloom.strength).toBe(0.123);
  expect(store.undoLabel).toBe(`Effects: ${name}`);
  store.undo();
  expect(store.document).toBe(before);
});

test('a new document has the cheapest preset: nothing on; a changed field is no preset', () => {
  const { effects } = createDocument();
  expect(presetOf(effects)).toBe('low');
  expect(withPreset(effects, 'low')).toEqual(effects);
  expect(hasDefaultEffects(createDocument())).toBe(true);
  const on = effectNames.filter((name) => (effectsDefaults[name] as { enabled?: boolean }).enabled === true);
  // Air is clear: its density is the scene's.
  expect(on).toEqual(['fog']);
  const high = withPreset(effects, 'high');
  expect(presetOf({ ...high, shadows: { ...high.shadows, samples: 33 } })).toBe(null);
});

test('each preset does at least what the cheaper one does', () => {
  const { effects } = createDocument();
  const on = presetNames.map((preset) =>
    effectNames.filter(
      (name) => (withPreset(effects, preset)[name] as { enabled?: boolean }).enabled === true,
    ),
  );
  for (const [i, names] of on.entries()) if (i > 0) expect(names).toEqual(expect.arrayContaining(on[i - 1]!));
  expect(on.map(({ length }) => length)).toEqual([...on.map(({ length }) => length)].sort((a, b) => a - b));
});
