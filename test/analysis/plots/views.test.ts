/** The data of the views over more than one angle, against closed forms. */
import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import { albedoSweep, SWEEP_POINTS, sweepAngles } from '../../../src/analysis/plots/albedo-sweep.ts';
import {
  type AzimuthOptions,
  azimuthMapAt,
  azimuthSlice,
} from '../../../src/analysis/plots/azimuth-slice.ts';
import type { Reflectance } from '../../../src/analysis/plots/curve.ts';
import { type LitOptions, litDirections, litPictures } from '../../../src/analysis/plots/lit-picture.ts';
import { lobe } from '../../../src/analysis/plots/lobe.ts';
import { eyeAt, meshSurface, sphereSurface } from '../../../src/analysis/plots/surface.ts';
import { createEvaluator } from '../../../src/glsl/evaluator.ts';
import type { Model } from '../../../src/glsl/model.ts';

const evaluate = (name: string, values: Record<string, unknown>): Reflectance => {
  const evaluator = createEvaluator(shippedModels.get(name) as Model, values);
  return (l, v) => evaluator.f(l, v);
};
const lambert: Reflectance = () => [1 / Math.PI, 0.5 / Math.PI, 0];
const last = <T>(parts: Iterable<T | null>): T => [...parts].findLast((part) => part !== null) as T;

describe('the lobe', () => {
  it('of Lambert is a half sphere of 1/pi, and its cosine with n.l', () => {
    const plain = last(lobe(lambert, { thetaV: 40, phiV: 20, cosine: false }));
    for (let i = 0; i < plain.values.length; i += 3) expect(plain.values[i]).toBeCloseTo(1 / Math.PI, 6);
    const { thetas, phis, values } = last(lobe(lambert, { thetaV: 40, phiV: 20, cosine: true }));
    for (const [row, theta] of thetas.entries()) {
      const exact = Math.cos((theta * Math.PI) / 180) / Math.PI;
      expect(values[3 * row * phis.length]).toBeCloseTo(exact, 6);
    }
  });

  it('has the mirror direction on its grid, and its angles in order', () => {
    const { thetas, phis } = last(lobe(lambert, { thetaV: 40, phiV: 20, cosine: false }));
    expect(thetas).toContain(40);
    expect(phis).toContain(200);
    for (const angles of [thetas, phis]) expect(angles).toEqual([...angles].sort((a, b) => a - b));
  });

  it('of a glossy model is longest in the mirror direction', () => {
    const f = evaluate('cook-torrance', { roughness: 0.1 });
    const { thetas, phis, values } = last(lobe(f, { thetaV: 30, phiV: 0, cosine: false }));
    let most = 0;
    for (let i = 0; i < values.length; i += 3) if (values[i]! > values[3 * most]!) most = i / 3;
    // The cosines below D move the peak a little towards the horizon (off-specular).
    expect(Math.abs((thetas[Math.floor(most / phis.length)] ?? 0) - 30)).toBeLessThan(2);
    expect(phis[most % phis.length]).toBeCloseTo(180, 9);
  });
});

describe('over the azimuth', () => {
  const options: AzimuthOptions = {
    turns: 'half',
    thetaL: 30,
    thetaH: 20,
    thetaD: 10,
    thetaV: 45,
    phiV: 0,
    cosine: false,
  };

  it('an isotropic model is flat under a half vector that turns', () => {
    const curve = azimuthSlice(evaluate('cook-torrance', { roughness: 0.3 }), options);
    for (const { rgb } of curve) expect(rgb[0]).toBeCloseTo(curve[0]?.rgb[0] ?? 0, 9);
  });

  it('an anisotropic one is the same after half a turn and across the tangent, and not flat', () => {
    const f = evaluate('principled', { anisotropic: 0.8, metallic: 1, roughness: 0.4 });
    const at = (phi: number) => azimuthMapAt(f, phi / 360, 0.25, options)[0];
    for (const phi of [10, 35, 80]) {
      expect(at(phi + 180)).toBeCloseTo(at(phi), 9);
      expect(at(360 - phi)).toBeCloseTo(at(phi), 9);
    }
    expect(Math.abs(at(0) - at(90))).toBeGreaterThan(0.1 * at(0));
  });

  it('the light that turns meets the slice of the plane of incidence', () => {
    const f = evaluate('cook-torrance', { roughness: 0.3 });
    const curve = azimuthSlice(f, { ...options, turns: 'light', thetaL: 45 });
    const peak = curve.reduce((a, b) => (b.rgb[0] > a.rgb[0] ? b : a));
    expect(peak.angle).toBe(180);
  });
});

it('the albedo over a parameter is linear in the albedo of Lambert', () => {
  const at =
    (value: number): Reflectance =>
    () => [value / Math.PI, 0, 0];
  const sweep = last(albedoSweep(at, { min: 0, max: 0.8, phiV: 0 }));
  expect(sweep).toHaveLength(SWEEP_POINTS);
  for (const [i, { value, albedos }] of sweep.entries()) {
    expect(value).toBeCloseTo((0.8 * i) / (SWEEP_POINTS - 1), 12);
    expect(albedos).toHaveLength(sweepAngles.length);
    for (const [albedo] of albedos) expect(albedo).toBeCloseTo(value, 3);
  }
});

describe('the lit sphere', () => {
  const options: LitOptions = { thetaV: 0, phiV: 0, thetaL: 30, phiL: 90, doubleTheta: false };

  it('of Lambert has the cosine of the light as its radiance', () => {
    const { size, pixels, alpha } = last(litPictures(lambert, sphereSurface, options));
    const half = Math.floor(size / 2);
    const i = half * size + half;
    expect(alpha?.[i]).toBe(1);
    expect(alpha?.[0]).toBe(0);
    // In the middle the normal is +z, and the light 30 degrees from it.
    expect(pixels[3 * i]).toBeCloseTo(Math.cos(Math.PI / 6), 2);
    expect(pixels[3 * i + 1]).toBeCloseTo(Math.cos(Math.PI / 6) / 2, 2);
  });

  it('shows the plots point at its pole, wherever the viewer is', () => {
    const eye = eyeAt(50, 70);
    const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, x, i) => sum + x * b[i]!, 0);
    expect(Math.acos(eye.back[2]) * (180 / Math.PI)).toBeCloseTo(50, 9);
    expect(Math.atan2(eye.back[1], eye.back[0]) * (180 / Math.PI)).toBeCloseTo(70, 9);
    for (const [a, b] of [
      [eye.right, eye.up],
      [eye.up, eye.back],
      [eye.right, eye.back],
    ] as const)
      expect(dot(a, b)).toBeCloseTo(0, 12);
  });

  it('doubles theta: the half vector is then where theta_l says', () => {
    const { eye, l } = litDirections({ ...options, thetaV: 40, doubleTheta: true });
    const h = l.map((value, i) => value + eye.back[i]!);
    expect(Math.atan2(Math.hypot(h[0]!, h[1]!), h[2]!) * (180 / Math.PI)).toBeCloseTo(30, 9);
  });

  it('is the same from triangles as from its equation', () => {
    const rings = 48;
    const positions: number[] = [];
    const index: number[] = [];
    for (let i = 0; i <= rings; i++) {
      for (let j = 0; j <= 2 * rings; j++) {
        const [theta, phi] = [(Math.PI * i) / rings, (Math.PI * j) / rings];
        positions.push(Math.sin(theta) * Math.cos(phi), Math.cos(theta), -Math.sin(theta) * Math.sin(phi));
        if (i === rings || j === 2 * rings) continue;
        const a = i * (2 * rings + 1) + j;
        const b = a + 2 * rings + 1;
        index.push(a, b, a + 1, b, b + 1, a + 1);
      }
    }
    const vertices = new Float32Array(positions);
    const mesh = { positions: vertices, normals: vertices, tangents: null, index: new Uint32Array(index) };
    const eye = eyeAt(35, 20);
    const [exact, made] = [sphereSurface(eye, 64), meshSurface(mesh, eye, 64)];
    const covered = (surface: { covered: Uint8Array }) => surface.covered.reduce((sum, one) => sum + one, 0);
    expect(Math.abs(covered(made) - covered(exact))).toBeLessThan(0.01 * covered(exact));
    const i = 3 * (20 * 64 + 40);
    for (let c = 0; c < 3; c++) {
      expect(made.normals[i + c]).toBeCloseTo(exact.normals[i + c]!, 2);
      expect(made.tangents[i + c]).toBeCloseTo(exact.tangents[i + c]!, 2);
    }
  });
});
