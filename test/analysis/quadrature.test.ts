import { describe, expect, it } from 'vitest';
import { directionalAlbedo } from '../../src/analysis/albedo.ts';
import { integrateHemisphere, integrateRectangle } from '../../src/analysis/quadrature.ts';
import { direction } from '../../src/analysis/vector.ts';

describe('integrateRectangle', () => {
  it('is exact for polynomials', () => {
    const { value, evaluations } = integrateRectangle(
      (x, y) => [x ** 5 * y ** 4, 1],
      { x: -1, y: 0, width: 3, height: 2 },
      { tolerance: 1e9 },
    );
    expect(value[0]).toBeCloseTo((63 / 6) * (32 / 5), 10);
    expect(value[1]).toBeCloseTo(6, 12);
    expect(evaluations).toBe(49);
  });

  it('finds a step by splitting', () => {
    const inDisc = (x: number, y: number) => [x * x + y * y < 1 ? 1 : 0];
    const { value, error } = integrateRectangle(
      inDisc,
      { x: 0, y: 0, width: 1, height: 1 },
      { tolerance: 1e-3 },
    );
    expect(error).toBeLessThan(1e-3);
    expect(value[0]).toBeCloseTo(Math.PI / 4, 3);
  });

  it('stops at its limit and says how wrong it may be', () => {
    const { error, evaluations } = integrateRectangle(
      (x) => [x > 1 / 3 ? 1 : 0],
      { x: 0, y: 0, width: 1, height: 1 },
      { tolerance: 1e-12, maxEvaluations: 5000 },
    );
    expect(evaluations).toBeLessThan(50_000);
    expect(error).toBeGreaterThan(1e-12);
  });
});

describe('integrateHemisphere', () => {
  it('integrates the powers of the cosine', () => {
    for (const n of [0, 1, 2, 5, 20]) {
      const { value } = integrateHemisphere(([, , z]) => [z ** n], { tolerance: 1e-9 });
      expect(value[0]).toBeCloseTo((2 * Math.PI) / (n + 1), 8);
    }
  });

  it('integrates what is not symmetric about the normal', () => {
    const { value } = integrateHemisphere(([x, y, z]) => [x * x, x * y, Math.max(x, 0) * z], {
      tolerance: 1e-7,
    });
    expect(value[0]).toBeCloseTo((2 * Math.PI) / 3, 6);
    expect(value[1]).toBeCloseTo(0, 6);
    expect(value[2]).toBeCloseTo(2 / 3, 6);
  });

  it('finds a peak of a thousandth of a radian when told where it is', () => {
    // A von Mises-Fisher lobe: its integral over the sphere is 1.
    const kappa = 1e6;
    for (const axis of [direction(1, 0), direction(0.3, 2), direction(0.05, 4.5)]) {
      const lobe = ([x, y, z]: readonly [number, number, number]) => [
        (kappa / (2 * Math.PI)) * Math.exp(kappa * (x * axis[0] + y * axis[1] + z * axis[2] - 1)),
      ];
      const { value } = integrateHemisphere(lobe, { focus: [axis], tolerance: 1e-6 });
      expect(value[0]).toBeCloseTo(1, 5);
    }
  });
});

describe('directionalAlbedo', () => {
  it("of Lambert's law is the albedo, from everywhere", () => {
    const lambert = () => [0.8 / Math.PI, 0.5 / Math.PI, 0] as const;
    for (const cosTheta of [1, 0.5, 0.01]) {
      const { value } = directionalAlbedo(lambert, direction(cosTheta, 1));
      expect(value[0]).toBeCloseTo(0.8, 4);
      expect(value[1]).toBeCloseTo(0.5, 4);
      expect(value[2]).toBe(0);
    }
  });
});
