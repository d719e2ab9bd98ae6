import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { readMerl } from '../../src/io/merl.ts';
import { highlightAlpha } from '../../src/material/generic-sampler.ts';
import { dependsOnTangent } from '../../src/material/tangent-dependence.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { directionsOf, writeMerl } from '../io/merl-writer.ts';

/** A known model, written on the grid of the MERL database and read back; it is evaluated a million times. */
const [cookTorrance, values] = [
  shippedModels.get('cook-torrance') as Model,
  { roughness: 0.25, kd: 0.3, ior: 1.8 },
];
const original = createQuickEvaluator(cookTorrance, values).term('BRDF');
const bytes = writeMerl(original);
const model = loadMeasured(bytes, 'somewhere/red gloss.binary');
const measured = createEvaluator(model);

/** The i-th direction, evenly spread over cosines from `least` to 1. */
function direction(i: number, least: number): Vector3 {
  const z = least + (1 - least) * ((i * 0.754877666) % 1);
  const phi = 2 * Math.PI * ((i * 0.569840291) % 1);
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}

/** The largest relative difference of the two in any colour. */
function difference(L: Vector3, V: Vector3): number {
  const read = measured.f(L, V);
  return Math.max(...original(L, V).map((x, c) => Math.abs((read[c] as number) / x - 1)));
}

test('a measured model is named by its file and has the lookup’s manual page', () => {
  expect(model.name).toBe('red gloss');
  expect(model.file.title).toMatch(/MERL/);
  expect([...shippedModels.keys()]).not.toContain('merl');
});

test('it is the model that was measured, within 2 %', () => {
  for (let i = 1; i < 6000; i++) {
    const [L, V] = [direction(i, 0.1), direction(7 * i + 3, 0.1)];
    expect(difference(L, V), `l ${L}, v ${V}`).toBeLessThan(0.02);
  }
});

test('so it is around the peak, for any angle of incidence', () => {
  for (let i = 1; i < 2000; i++) {
    const V = direction(i, 0.3);
    // The mirror direction, off by up to a few degrees.
    const [x, y, z] = [-V[0] + 0.1 * Math.sin(i), -V[1] + 0.1 * Math.cos(3 * i), V[2]];
    const length = Math.hypot(x, y, z);
    const L: Vector3 = [x / length, y / length, z / length];
    expect(difference(L, V), `l ${L}, v ${V}`).toBeLessThan(0.02);
  }
});

test('in the middle of a bin it is the sample of that bin', () => {
  const data = readMerl(bytes, 'gloss.binary');
  for (let i = 0; i < 3000; i++) {
    const [h, d, p] = [(7 * i) % 70, (13 * i) % 60, (31 * i) % 180];
    const { L, V } = directionsOf(h, d, p);
    if (L[2] < 1e-3 || V[2] < 1e-3) continue;
    measured.f(L, V).forEach((x, c) => {
      const sample = data[((h * 90 + d) * 180 + p) * 3 + c] as number;
      expect(Math.abs(x / sample - 1), `bin ${h} ${d} ${p}`).toBeLessThan(1e-6);
    });
  }
});

test('it is reciprocal, finite and not negative everywhere, and isotropic', () => {
  for (let i = 1; i < 5000; i++) {
    const [L, V] = [direction(i, 0), direction(11 * i + 5, i % 3 === 0 ? 0 : 0.5)];
    const f = measured.f(L, V);
    measured.f(V, L).forEach((x, c) => {
      expect(x).toBeCloseTo(f[c] as number, 9);
    });
    expect(f.every((x) => Number.isFinite(x) && x >= 0)).toBe(true);
  }
  const up: Vector3 = [0, 0, 1];
  const grazing: Vector3 = [Math.sqrt(1 - 1e-12), 0, 1e-6];
  const opposite: Vector3 = [-grazing[0], 0, 1e-6];
  for (const [L, V] of [
    [up, up],
    [grazing, grazing],
    [grazing, opposite],
    [up, grazing],
  ] as const)
    expect(measured.f(L, V).every((x) => Number.isFinite(x) && x > 0)).toBe(true);
  expect(measured.f([0.6, 0, -0.8], up)).toEqual([0, 0, 0]);
  expect(dependsOnTangent(model)).toBe(false);
});

test('the generic sampler finds the width of its highlight', () => {
  expect(highlightAlpha(measured)).toBeCloseTo(highlightAlpha(createEvaluator(cookTorrance, values)), 2);
});
