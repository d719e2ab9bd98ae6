import { describe, expect, test } from 'vitest';
import { createDocument } from '../../../src/scene/document.ts';
import { putLook } from '../../../src/scene/library-commands.ts';
import { addMaterial } from '../../../src/scene/material-commands.ts';
import { MEAN_ROUGHNESS } from '../../../src/scene/pattern/draw.ts';
import { defaultPattern, readPatternAsset } from '../../../src/scene/pattern/pattern.ts';
import { givePattern, setPattern } from '../../../src/scene/pattern-commands.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

function withMaterial() {
  const store = new DocumentStore(createDocument());
  const id = addMaterial(store, 'principled');
  store.edit('Red', (draft) => {
    draft.materials[id]!.parameters = { baseColor: [0.5, 0.2, 0.1], roughness: 0.4 };
  });
  const material = () => store.document.materials[id]!;
  const patterns = () => Object.values(store.document.assets).map(readPatternAsset);
  return { store, id, material, patterns };
}

describe('a pattern', () => {
  test('that comes to a material keeps its mean colour and roughness, and is one for all of its places', () => {
    const { store, id, material, patterns } = withMaterial();
    const before = store.document;
    givePattern(store, id, { parameter: 'baseColor' }, 'wood', 'Wood');
    givePattern(store, id, { parameter: 'roughness' }, 'wood', 'Wood');
    givePattern(store, id, { map: 'normalMap' }, 'wood', 'Wood');
    expect(patterns()).toEqual([{ ...defaultPattern('wood'), color: [0.5, 0.2, 0.1] }]);
    expect(material().parameters).toEqual({ baseColor: [1, 1, 1], roughness: 0.4 / MEAN_ROUGHNESS });
    expect(material().textures.baseColor).toMatchObject({ texture: 0, colorSpace: 'srgb', channel: null });
    expect(material().textures.roughness).toMatchObject({ texture: 2, colorSpace: 'linear', channel: 'g' });
    expect(material().normalMap).toMatchObject({ texture: 1, colorSpace: 'linear', scale: 1 });
    for (let i = 0; i < 3; i++) store.undo();
    expect(store.document).toBe(before);
  });

  test('in the place of another one takes its colour', () => {
    const { store, id, material, patterns } = withMaterial();
    givePattern(store, id, { parameter: 'baseColor' }, 'wood', 'Wood');
    givePattern(store, id, { parameter: 'baseColor' }, 'marble', 'Marble');
    expect(material().parameters.baseColor).toEqual([1, 1, 1]);
    expect(patterns().map(({ pattern, color }) => [pattern, color])).toContainEqual([
      'marble',
      [0.5, 0.2, 0.1],
    ]);
  });

  test('is changed for the material that is edited alone', () => {
    const { store, id, patterns } = withMaterial();
    givePattern(store, id, { parameter: 'baseColor' }, 'wood', 'Wood');
    const other = addMaterial(store, 'principled');
    store.edit('Same', (draft) => {
      draft.materials[other]!.textures = structuredClone(store.document.materials[id]!.textures);
    });
    const rings = (of: string): unknown => {
      const { asset } = store.document.materials[of]!.textures.baseColor!;
      return readPatternAsset(store.document.assets[asset]!).rings;
    };
    const { asset } = store.document.materials[id]!.textures.baseColor!;
    for (const count of [3, 4]) {
      const at = store.document.materials[id]!.textures.baseColor!.asset;
      setPattern(store, id, at, { ...patterns()[0]!, rings: count }, 'Rings', 'drag');
    }
    expect([rings(id), rings(other)]).toEqual([4, 14]);
    expect(store.document.materials[other]!.textures.baseColor!.asset).toBe(asset);
    store.undo();
    expect(rings(id)).toBe(14);
  });

  test('goes with the look that it belongs to', () => {
    const { store, id, material, patterns } = withMaterial();
    givePattern(store, id, { parameter: 'baseColor' }, 'wood', 'Wood');
    givePattern(store, id, { map: 'normalMap' }, 'wood', 'Wood');
    store.edit('Gold', (draft) =>
      putLook(draft, id, { model: 'principled', parameters: { metallic: 1 }, multipleScattering: false }),
    );
    expect(material().normalMap).toBeNull();
    expect(patterns()).toEqual([]);
  });
});
