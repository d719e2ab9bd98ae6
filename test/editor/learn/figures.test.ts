/** Figures that the lessons' text claims are those that the models have. */
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import { directionalAlbedo } from '../../../src/analysis/albedo.ts';
import { reflectedColor } from '../../../src/analysis/substances/reflectance.ts';
import { substances } from '../../../src/analysis/substances/table.ts';
import { createEvaluator } from '../../../src/glsl/evaluator.ts';

const energy = readFileSync(new URL('../../../lessons/energy/lesson.en.md', import.meta.url), 'utf8');

function albedo(model: string, parameters: Record<string, unknown>, cosine: number): number {
  const evaluator = createEvaluator(shippedModels.get(model)!, { baseColor: [1, 1, 1], ...parameters });
  return directionalAlbedo((l, v) => evaluator.f(l, v), [Math.sqrt(1 - cosine ** 2), 0, cosine]).value[0]!;
}

test('the furnace: a rough metal, the two subsurface lobes, and Burley’s model', () => {
  expect(energy).toContain('31 % head-on');
  expect(albedo('principled', { metallic: 1, roughness: 1 }, 1)).toBeCloseTo(0.31, 2);
  const lobe = { subsurface: 1, roughness: 0.5, specular: 0 };
  expect(energy).toContain('head-on it gives back 2.2');
  expect(albedo('principled-thesis', lobe, 1)).toBeCloseTo(2.2, 1);
  expect(energy).toContain('near its edge 13 times');
  expect(albedo('principled-thesis', lobe, 0.1)).toBeCloseTo(13, 0);
  expect(energy).toContain('gives back 75 % head-on, and at most 1.4 times');
  expect(albedo('principled', lobe, 1)).toBeCloseTo(0.75, 2);
  const edge = [0.3, 0.2, 0.15, 0.1, 0.05].map((cosine) => albedo('principled', lobe, cosine));
  expect(Math.max(...edge)).toBeCloseTo(1.4, 1);
  expect(energy).toContain('4 % too much head-on and 18 % at flat angles');
  expect(albedo('principled', {}, 1)).toBeCloseTo(1.04, 2);
  expect(albedo('principled', {}, 0.1)).toBeCloseTo(1.18, 2);
});

test('gold has the colour that was measured', () => {
  const measured = reflectedColor(substances.get('gold')!, 1);
  for (const name of ['fresnel', 'principled']) {
    const file = name === 'fresnel' ? 'scene.json' : 'lesson.en.md';
    const text = readFileSync(new URL(`../../../lessons/${name}/${file}`, import.meta.url), 'utf8');
    const color = /\[1, (0\.7\d), (0\.3\d)\]/.exec(text)!;
    expect(Number(color[1])).toBeCloseTo(measured[1], 2);
    expect(Number(color[2])).toBeCloseTo(measured[2], 2);
  }
});
