import { describe, expect, test } from 'vitest';
import { directionalAlbedo } from '../../../src/analysis/albedo.ts';
import { categories, materialOf } from '../../../src/analysis/library/entry.ts';
import { materialLibrary } from '../../../src/analysis/library/library.ts';
import { createQuickEvaluator } from '../../../src/analysis/quick-evaluator.ts';
import { reflectedColor } from '../../../src/analysis/substances/reflectance.ts';
import { substances } from '../../../src/analysis/substances/table.ts';
import { direction } from '../../../src/analysis/vector.ts';
import { multipleScatteringModel } from '../../../src/glsl/model.ts';
import { createDocument } from '../../../src/scene/document.ts';
import { putMaterial } from '../../../src/scene/material-commands.ts';
import { findModel } from '../../../src/scene/models.ts';
import { DocumentStore } from '../../../src/scene/store.ts';

const entries = [...materialLibrary.values()];
const modelOf = (name: string) => findModel({ models: {}, assets: {} }, name)!;

describe('the library of materials', () => {
  test('has materials of every category, each with a source', () => {
    expect(entries.length).toBeGreaterThanOrEqual(50);
    for (const category of categories)
      expect(entries.filter((entry) => entry.category === category).length, category).toBeGreaterThanOrEqual(
        3,
      );
    for (const { id, title, source } of entries) {
      expect(source, id).toMatch(/\S{3}.*\.$/);
      expect(title, id).toMatch(/^[A-Z]/);
    }
    expect(new Set(entries.map(({ title }) => title)).size).toBe(entries.length);
  });

  test('has parameters that its models know, within their ranges', () => {
    for (const { id, look } of entries) {
      const { parameters } = modelOf(look.model);
      for (const [name, value] of Object.entries(look.parameters)) {
        const parameter = parameters.find((known) => known.name === name);
        expect(parameter, `${id}: ${name}`).toBeDefined();
        const [low, high] = parameter?.type === 'float' ? [parameter.min, parameter.max] : [0, 1];
        for (const number of [value].flat()) {
          expect(Number(number), `${id}: ${name}`).toBeGreaterThanOrEqual(low);
          expect(Number(number), `${id}: ${name}`).toBeLessThanOrEqual(high);
        }
      }
    }
  });

  test('can be put into a document', () => {
    const store = new DocumentStore(createDocument());
    store.edit('All', (draft) => {
      for (const entry of entries) putMaterial(draft, materialOf(entry));
    });
    expect(Object.keys(store.document.materials)).toHaveLength(entries.length);
  });

  // As the verdict's law of energy: down to .6 degrees above the horizon, 1e-3 for the quadrature.
  test('gives back no more light than it receives', () => {
    const failures: string[] = [];
    for (const { id, look } of entries) {
      const model = modelOf(look.model);
      const whole = look.multipleScattering ? multipleScatteringModel(model) : model;
      const f = createQuickEvaluator(whole, look.parameters).term(whole.main);
      for (const cosine of [1, 0.2, 0.05, 0.01]) {
        const { value, error } = directionalAlbedo(f, direction(cosine, 0.4), {
          tolerance: 1e-3,
          maxEvaluations: 2000,
        });
        const most = Math.max(...value);
        if (most - error > 1 + 1e-3) failures.push(`${id} at n.v = ${cosine}: ${most.toFixed(3)}`);
      }
    }
    expect(failures).toEqual([]);
  });

  test('has metals in the colour of their n and k', () => {
    const gold = materialLibrary.get('gold-polished')?.look.parameters.baseColor as readonly number[];
    const exact = reflectedColor(substances.get('gold')!, 1);
    for (const [i, c] of gold.entries()) expect(c).toBeCloseTo(Math.min(1, exact[i]!), 12);
  });
});
