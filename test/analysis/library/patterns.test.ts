import { describe, expect, test } from 'vitest';
import { materialLibrary } from '../../../src/analysis/library/library.ts';
import { fileOf } from '../../../src/analysis/library/patterns.ts';
import { thumbnail } from '../../../src/analysis/library/thumbnail.ts';
import { srgbToLinear } from '../../../src/color/srgb.ts';
import { addMaterialFile } from '../../../src/io/material-file.ts';
import { decodeBase64 } from '../../../src/scene/base64.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { findModel } from '../../../src/scene/models.ts';
import { COLOR } from '../../../src/scene/pattern/asset.ts';
import { drawPattern, MEAN_ROUGHNESS } from '../../../src/scene/pattern/draw.ts';
import { readPattern } from '../../../src/scene/pattern/pattern.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

const grained = [...materialLibrary.values()].filter((entry) => Object.keys(fileOf(entry).assets).length > 0);
const patternOf = (id: string) => {
  const [asset] = Object.values(fileOf(materialLibrary.get(id)!).assets);
  return readPattern(decodeBase64(asset!.data), id);
};

describe('materials of the library with a pattern', () => {
  test('are the wood, the cloth, the stone and the brushed metals', () => {
    expect(grained.length).toBeGreaterThan(25);
    expect(new Set(grained.map(({ category }) => category))).toEqual(
      new Set(['metals', 'fabrics', 'wood', 'stone', 'ceramics', 'ground']),
    );
  });

  test.each(grained.map((entry) => [entry.id, entry] as const))(
    '%s keeps its colour and its gloss',
    (id, entry) => {
      const { material } = fileOf(entry);
      const { look } = entry;
      const name = look.model === 'principled' ? 'baseColor' : 'albedo';
      const share = (parameters: typeof look.parameters) => Number(parameters.kd ?? 1);
      const { roughness, kd: _, [name]: color, ...rest } = material.parameters;
      for (const [key, value] of Object.entries(rest)) expect(value, key).toEqual(look.parameters[key]);
      if (material.textures.roughness)
        expect(Number(roughness) * MEAN_ROUGHNESS).toBeCloseTo(Number(look.parameters.roughness), 3);
      else expect(roughness).toBe(look.parameters.roughness);
      const wanted = look.parameters[name] as readonly number[];
      if (!material.textures[name]) {
        expect(color).toEqual(wanted);
        return;
      }
      expect(color).toEqual([1, 1, 1]);
      const { data } = drawPattern({ ...patternOf(id), size: 64 }, COLOR);
      for (const c of [0, 1, 2]) {
        let sum = 0;
        for (let i = c; i < data.length; i += 4) sum += srgbToLinear(data[i]! / 255);
        const mean = (share(material.parameters) * sum) / (data.length / 4);
        expect(Math.abs(mean - share(look.parameters) * wanted[c]!), `${c}`).toBeLessThan(
          0.003 * mean + 2e-4,
        );
      }
    },
  );

  test('come into a document, each with its pattern once', () => {
    const store = new DocumentStore(createDocument());
    store.edit('All', (draft) => {
      for (const entry of [...grained, ...grained]) addMaterialFile(draft, fileOf(entry));
    });
    const patterns = new Set(grained.map((entry) => JSON.stringify(patternOf(entry.id))));
    expect(Object.keys(store.document.assets)).toHaveLength(patterns.size);
    expect(JSON.stringify(store.document.assets).length / patterns.size).toBeLessThan(600);
  });

  test('lie square on a ball and on a box', () => {
    const [ball, box] = [true, false].map((isBall) => fileOf(materialLibrary.get('granite')!, isBall));
    expect(ball!.material.textures.baseColor?.repeat).toEqual([2, 1]);
    expect(box!.material.textures.baseColor?.repeat).toEqual([1, 1]);
  });

  test.each(['granite', 'canvas'])(
    '%s has a small picture as bright as without, with what it is made of',
    (id) => {
      const SIZE = 40;
      const entry = materialLibrary.get(id)!;
      const { material, assets } = fileOf(entry);
      const subject = (parameters: typeof entry.look.parameters) => ({
        model: findModel({ models: {}, assets: {} }, material.model)!,
        parameters,
        multipleScattering: false,
      });
      const refs = Object.entries({
        ...material.textures,
        ...(material.normalMap && { normalMap: material.normalMap }),
      });
      const patterns = refs.map(([place, ref]) => ({ place, data: assets[ref.asset]!.data, ref, scale: 1 }));
      const plain = thumbnail(subject(entry.look.parameters), SIZE);
      const patterned = thumbnail({ ...subject(material.parameters), patterns }, SIZE);
      let [sum, differences, count] = [0, 0, 0];
      for (let i = 0; i < plain.length; i += 4) {
        if (plain[i + 3]! < 255) continue;
        count += 1;
        sum += patterned[i + 1]! - plain[i + 1]!;
        differences += Math.abs(patterned[i + 1]! - plain[i + 1]!);
      }
      expect(Math.abs(sum / count)).toBeLessThan(10);
      expect(differences / count).toBeGreaterThan(3);
    },
  );
});
