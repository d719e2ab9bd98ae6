import { describe, expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { dependsOnTangent } from '../../src/material/tangent-dependence.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { type CsailOptions, directionsOf, writeCsail } from '../io/csail-writer.ts';

/** A known model, written on the grid of the CSAIL data and read back; it is evaluated a million times. */
const original = createQuickEvaluator(shippedModels.get('principled') as Model, {
  roughness: 0.9,
  metallic: 0.5,
  anisotropic: 0.4,
}).term('BRDF');

function spread(i: number, least: number): Vector3 {
  const z = least + (1 - least) * ((i * 0.754877666) % 1);
  const phi = 2 * Math.PI * ((i * 0.569840291) % 1);
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(phi), r * Math.sin(phi), z];
}

describe.each<[string, CsailOptions]>([
  ['all around', { bins: [22, 22, 40, 32] }],
  ['half of phi_diff', { bins: [22, 22, 24, 32], half: true }],
])('a CSAIL file, %s,', (_, options) => {
  const model = loadMeasured(writeCsail(original, options), 'somewhere/brushed.dat');
  const measured = createEvaluator(model);

  test('in the middle of a bin is its sample', () => {
    const bins = options.bins as readonly number[];
    for (let i = 0; i < 2000; i++) {
      const at = [3, 7, 13, 31].map((step, axis) => (i * step) % (bins[axis] as number));
      const { L, V } = directionsOf(at as never, options);
      const expected = original(L, V);
      measured.f(L, V).forEach((value, c) => {
        expect(Math.abs(value / (expected[c] as number) - 1), `bin ${at}`).toBeLessThan(1e-5);
      });
    }
  });

  test('is the model that was measured within 2 %', () => {
    let worst = 0;
    // The grid does not resolve the pole: within half a bin of it the azimuths count as if they mattered.
    const pole = Math.cos(Math.PI / 4 / (options.bins?.[0] as number));
    for (let i = 1; i < 4000; i++) {
      const [L, V] = [spread(i, 0.4), spread(7 * i + 3, 0.4)];
      if (Math.max(L[2], V[2]) > pole) continue;
      const expected = original(L, V);
      const errors = measured.f(L, V).map((x, c) => Math.abs(x / (expected[c] as number) - 1));
      worst = Math.max(worst, ...errors);
    }
    expect(worst).toBeLessThan(0.02);
  });

  test('depends on the tangent, is finite and not negative', () => {
    expect(dependsOnTangent(model)).toBe(true);
    const edge: Vector3[] = [
      [0, 0, 1],
      [1, 0, 1e-6],
      [-1, 0, 1e-6],
      [0, -1, 1e-6],
      [-0.6, 0, 0.8],
    ];
    for (const L of edge)
      for (const V of edge) expect(measured.f(L, V).every((x) => Number.isFinite(x) && x >= 0)).toBe(true);
    expect(measured.f([0.6, 0, -0.8], [0, 0, 1])).toEqual([0, 0, 0]);
  });
});

test('a file of another kind is refused by its name', () => {
  expect(() => loadMeasured(new Uint8Array(100), 'a.txt')).toThrow(
    /^a\.txt: byte 0: no file of measurements that is known here; expected \.binary \(MERL\), \.bsdf \(RGL\), \.dat/,
  );
});
