import { describe, expect, test } from 'vitest';
import { CIE_1931, WAVELENGTHS } from '../../src/color/cie-1931.ts';
import { LIGHTS, lightSpectrum } from '../../src/color/light.ts';
import { inverse, transform } from '../../src/color/matrix.ts';
import { XYZ_TO_RGB } from '../../src/color/rec709.ts';
import { colorWeights, reflectanceColor } from '../../src/color/spectrum.ts';

/** Chromaticity of a spectrum at WAVELENGTHS. */
function chromaticity(spectrum: readonly number[]): [number, number] {
  const [X, Y, Z] = ([0, 1, 2] as const).map((c) =>
    CIE_1931.reduce((sum, row, i) => sum + row[c] * (spectrum[i] as number), 0),
  ) as [number, number, number];
  return [X / (X + Y + Z), Y / (X + Y + Z)];
}

describe('the tables', () => {
  test('have the published chromaticities of the lights', () => {
    // CIE 015:2018, table of chromaticities for the 2 degree observer.
    for (const [light, x, y] of [
      ['D65', 0.31272, 0.32903],
      ['E', 1 / 3, 1 / 3],
      ['A', 0.44758, 0.40745],
    ] as const) {
      const [gotX, gotY] = chromaticity(lightSpectrum(light));
      expect(gotX, light).toBeCloseTo(x, 4);
      expect(gotY, light).toBeCloseTo(y, 4);
    }
  });

  test('have the published sums', () => {
    // Each function has the same integral: 106.857 nm (CIE 015:2018, 1 nm tables).
    for (const c of [0, 1, 2] as const) {
      const sum = CIE_1931.reduce((total, row) => total + row[c], 0) * 5;
      expect(Math.abs(sum / 106.857 - 1)).toBeLessThan(5e-4);
    }
    expect([WAVELENGTHS[0], WAVELENGTHS.at(-1), WAVELENGTHS.length]).toEqual([380, 780, 81]);
  });
});

describe('the colour of a reflectance', () => {
  test.each(LIGHTS)('is 1 1 1 under %s where all light comes back', (light) => {
    reflectanceColor(() => 1, light).forEach((c) => {
      expect(c).toBeCloseTo(1, 12);
    });
    reflectanceColor(() => 0.18, light).forEach((c) => {
      expect(c).toBeCloseTo(0.18, 12);
    });
  });

  test('is the sum of its samples by their weights, whatever the sampling', () => {
    const line = (nm: number) => 0.2 + (0.5 * (nm - 380)) / 400;
    const expected = reflectanceColor(line);
    for (const wavelengths of [
      [380, 780],
      [360, 512.3, 1000],
      [100, 380, 382, 383.5, 600, 780, 900],
    ]) {
      const weights = colorWeights(wavelengths);
      expected.forEach((value, c) => {
        const sum = wavelengths.reduce((s, nm, i) => s + line(nm) * (weights[i]?.[c] as number), 0);
        expect(sum).toBeCloseTo(value, 12);
      });
    }
  });

  test('stays level beyond its samples', () => {
    expect(colorWeights([550])[0]?.map((c) => Math.round(c * 1e9) / 1e9)).toEqual([1, 1, 1]);
    const [low, high] = colorWeights([300, 350]);
    expect(low).toEqual([0, 0, 0]);
    expect(high?.[1]).toBeCloseTo(1, 12);
  });

  test('of a narrow band has the hue of the band', () => {
    const band = (from: number, to: number) => reflectanceColor((nm) => (nm >= from && nm <= to ? 1 : 0));
    const [red, green, blue] = [band(620, 780), band(520, 560), band(400, 470)];
    expect(red[0]).toBeGreaterThan(10 * Math.max(Math.abs(red[1]), Math.abs(red[2])));
    expect(green[1]).toBeGreaterThan(3 * Math.max(green[0], green[2]));
    expect(blue[2]).toBeGreaterThan(5 * Math.max(blue[0], blue[1]));
  });
});

test('a matrix times its inverse changes nothing', () => {
  const there = transform(XYZ_TO_RGB, [0.3, 0.5, 0.7]);
  transform(inverse(XYZ_TO_RGB), there).forEach((value, i) => {
    expect(value).toBeCloseTo([0.3, 0.5, 0.7][i] as number, 14);
  });
});
