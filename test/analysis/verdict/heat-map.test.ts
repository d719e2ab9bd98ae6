import { describe, expect, test } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import { directionalAlbedo } from '../../../src/analysis/albedo.ts';
import { cellParameters, heatMap, worstCell } from '../../../src/analysis/verdict/heat-map.ts';
import { heatColor, heatMapCsv, heatMapSvg } from '../../../src/analysis/verdict/heat-map-picture.ts';
import { createEvaluator } from '../../../src/glsl/evaluator.ts';
import type { Model } from '../../../src/glsl/model.ts';
import { model, term } from './faults.ts';

const shipped = (name: string) => shippedModels.get(name) as Model;

describe('a heat map of energy', () => {
  test('has the albedo of adaptive quadrature', async () => {
    for (const name of ['principled', 'cook-torrance']) {
      const map = await heatMap(shipped(name), { property: 'energy', size: 3 });
      expect(map.cells).toHaveLength(9);
      let compared = 0;
      for (const [i, { value, v }] of map.cells.entries()) {
        const set = cellParameters(map, i % 3, Math.floor(i / 3));
        const evaluator = createEvaluator(shipped(name), set);
        const { value: albedo } = directionalAlbedo((l, w) => evaluator.f(l, w), v, {
          tolerance: 1e-3,
          maxEvaluations: 5000,
        });
        compared++;
        const off = Math.abs(value - Math.max(...albedo));
        expect(off, `${name} ${i}`).toBeLessThan(0.007 * Math.max(1, value));
      }
      expect(compared).toBeGreaterThanOrEqual(5);
    }
  });

  test('is drawn over the parameters that matter most, or those that are named', async () => {
    const thesis = shipped('principled-thesis');
    const main = await heatMap(thesis, { property: 'energy', size: 4 });
    expect([main.x.name, main.y.name]).toContain('subsurface');
    const { cell, column, row } = worstCell(main);
    expect(cell.value).toBeGreaterThan(30);
    expect(cellParameters(main, column, row)).toMatchObject({ subsurface: 1, baseColor: [1, 1, 1] });
    const named = await heatMap(thesis, {
      property: 'energy',
      size: 2,
      axes: ['metallic', 'roughness'],
      parameters: { baseColor: [0.5, 0.5, 0.5] },
    });
    expect(cellParameters(named, 1, 0)).toMatchObject({
      metallic: 1,
      roughness: 0,
      baseColor: [0.5, 0.5, 0.5],
    });
    await expect(heatMap(thesis, { property: 'energy', axes: ['metallic', 'baseColor'] })).rejects.toThrow(
      "principled-thesis has no number 'baseColor'; it has subsurface,",
    );
    await expect(heatMap(shipped('lambert'), { property: 'energy' })).rejects.toThrow('no two numbers');
  });
});

test('a heat map of reciprocity shows where a model breaks it', async () => {
  const lopsided = model({
    parameters: 'float amount 0 1 0\nfloat gain 0 1 .5',
    terms: term('unused', 'return vec3(0.0);'),
    body: 'return vec3(gain * (0.1 + amount * 0.1 * NdotL));',
  });
  const { cells } = await heatMap(lopsided, { property: 'reciprocity', axes: ['amount', 'gain'], size: 2 });
  expect(cells.map(({ value }) => value > 1e-6)).toEqual([false, false, false, true]);
});

describe('its picture', () => {
  test('is blue within the law and red beyond', () => {
    const [r, , b] = heatColor('energy', 0.5, 3);
    expect(b).toBeGreaterThan(r);
    const [red, , blue] = heatColor('energy', 3, 3);
    expect(red).toBeGreaterThan(blue);
    expect(heatColor('energy', 1, 3)).not.toEqual(heatColor('energy', 1.05, 3));
  });

  test('is a file with axes, and a table', async () => {
    const map = await heatMap(shipped('cook-torrance'), {
      property: 'energy',
      axes: ['roughness', 'ior'],
      size: 3,
    });
    const svg = heatMapSvg(map);
    expect(svg).toMatch(/^<svg /);
    expect(svg.match(/<rect /g)?.length).toBeGreaterThanOrEqual(9 + 5);
    expect(svg).toContain('>cook-torrance: largest albedo<');
    expect(svg).toContain('>roughness<');
    const lines = heatMapCsv(map).trimEnd().split('\n');
    expect(lines[0]).toBe('roughness,ior,energy');
    expect(lines).toHaveLength(10);
    expect(lines[9]).toMatch(/^1,3,0\.\d+$/);
  });
});
