import { describe, expect, test } from 'vitest';
import { directionalAlbedo } from '../../../src/analysis/albedo.ts';
import { materialLibrary } from '../../../src/analysis/library/library.ts';
import { sparsely } from '../../../src/analysis/library/sparse.ts';
import { BLURS, studioMaps, studioRadiance } from '../../../src/analysis/library/studio.ts';
import { createThrough } from '../../../src/analysis/library/through.ts';
import { hasGrain, roundLobes, shade, thumbnail } from '../../../src/analysis/library/thumbnail.ts';
import { createQuickEvaluator } from '../../../src/analysis/quick-evaluator.ts';
import { integrateReflection } from '../../../src/analysis/reflection-quadrature.ts';
import { direction, type Vec3 } from '../../../src/analysis/vector.ts';
import { findModel } from '../../../src/scene/models.ts';

function subject(id: string) {
  const { look } = materialLibrary.get(id)!;
  const model = findModel({ models: {}, assets: {} }, look.model)!;
  const f = createQuickEvaluator(model, look.parameters).term('BRDF');
  return { model, parameters: look.parameters, multipleScattering: false, f };
}

const white = BLURS.map(() => new Float32Array(studioMaps()[0]!.length).fill(1));

describe('a small picture of a material', () => {
  test.each(['paper-white', 'plastic-red', 'gold-satin', 'chromium', 'velvet', 'car-silver'])(
    '%s in an even light shows its directional albedo',
    (id) => {
      const { f, ...of } = subject(id);
      for (const cosine of [0.9, 0.6, 0.3]) {
        const n: Vec3 = [Math.sqrt(1 - cosine * cosine), 0, cosine];
        const { value } = directionalAlbedo(f, direction(cosine, 0));
        const found = shade(roundLobes(of, f)(n), white);
        for (let c = 0; c < 3; c++) expect(Math.abs(found[c]! / value[c]! - 1)).toBeLessThan(0.08);
      }
    },
  );

  test.each(['paper-white', 'plastic-grey', 'gold-satin', 'copper-hammered'])(
    '%s in the studio is the shading equation',
    (id) => {
      const { f, ...of } = subject(id);
      const at = roundLobes(of, f);
      // By the exact integral over the studio's own light; seen along z.
      for (const [x, y] of [
        [-0.3, 0.35],
        [0.2, -0.4],
        [0.5, 0.3],
      ] as const) {
        const n: Vec3 = [x, y, Math.sqrt(1 - x * x - y * y)];
        const placed = at(n);
        const v: Vec3 = [placed.x[2], placed.y[2], n[2]];
        const exact = integrateReflection(
          (l) => {
            const world = [0, 1, 2].map(
              (k) => l[0] * placed.x[k]! + l[1] * placed.y[k]! + l[2] * n[k]!,
            ) as unknown as Vec3;
            const light = studioRadiance(world, 0);
            const rgb = f(l, v);
            return light.map((value, c) => value * rgb[c]! * l[2]);
          },
          v,
          { tolerance: 5e-3, maxEvaluations: 20_000 },
        ).value;
        const found = shade(placed);
        for (let c = 0; c < 3; c++)
          expect(Math.abs(found[c]! - exact[c]!)).toBeLessThan(0.08 * exact[c]! + 0.01);
      }
    },
  );

  test('a clear sphere loses no light', () => {
    const { model, parameters, f } = subject('water');
    const v = direction(0.8, 0);
    const through = createThrough(model, parameters)!(v);
    let sum = 0;
    for (let i = 0; i < through.count; i++) sum += through.values[6 * i + 4]!;
    expect(sum + directionalAlbedo(f, v).value[1]!).toBeGreaterThan(0.9);
    expect(sum + directionalAlbedo(f, v).value[1]!).toBeLessThan(1.1);
  });

  test('knows which surfaces have a grain', () => {
    expect(hasGrain(subject('aluminium-brushed').f)).toBe(true);
    expect(hasGrain(subject('aluminium-polished').f)).toBe(false);
  });

  test('is the same each time, opaque in the middle and clear beside the sphere', () => {
    const { model, parameters } = subject('paint-red');
    const make = () => thumbnail({ model, parameters, multipleScattering: false }, 32);
    const pixels = make();
    expect(pixels).toEqual(make());
    const alpha = (column: number, row: number) => pixels[4 * (row * 32 + column) + 3];
    expect(alpha(16, 16)).toBe(255);
    expect(alpha(0, 0)).toBe(0);
    const [r = 0, g = 0] = pixels.slice(4 * (16 * 32 + 16));
    expect(r).toBeGreaterThan(2 * g);
  });

  test('computes every pixel where there is an edge, and few where there is none', () => {
    let asked = 0;
    const edge = (column: number, row: number): readonly [number, number, number] => {
      asked += 1;
      return column > 2 * row ? [1, 1, 1] : [0, 0, 0];
    };
    const pixels = sparsely(32, edge);
    const few = asked;
    expect(few).toBeLessThan(700);
    for (let row = 0; row < 32; row++)
      for (let column = 0; column < 32; column++)
        expect(pixels[3 * (row * 32 + column)]).toBe(edge(column, row)[0]);
  });
});
