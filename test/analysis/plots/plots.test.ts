import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import { albedoCurve } from '../../../src/analysis/plots/albedo-curve.ts';
import { channelOf } from '../../../src/analysis/plots/channel.ts';
import type { Reflectance } from '../../../src/analysis/plots/curve.ts';
import { differenceSlice } from '../../../src/analysis/plots/difference-slice.ts';
import { directionsFrom, halfDifferenceOf } from '../../../src/analysis/plots/half-difference.ts';
import { halfSlice } from '../../../src/analysis/plots/half-slice.ts';
import { imageAngles, imageSliceAt } from '../../../src/analysis/plots/image-slice.ts';
import { lightSlice } from '../../../src/analysis/plots/light-slice.ts';
import { pictures } from '../../../src/analysis/plots/picture.ts';
import { viewerSlice } from '../../../src/analysis/plots/viewer-slice.ts';
import { createRandom } from '../../../src/analysis/random.ts';
import { createEvaluator } from '../../../src/glsl/evaluator.ts';
import type { Model } from '../../../src/glsl/model.ts';

const evaluate = (name: string, values: Record<string, unknown>, term = 'BRDF'): Reflectance => {
  const evaluator = createEvaluator(shippedModels.get(name) as Model, values);
  return (l, v) => evaluator.f(l, v, undefined, term);
};
const lambert = evaluate('lambert', { albedo: [1, 0.5, 0.25] });
const view = { thetaV: 40, phiV: 20, cosine: false };

describe('the half and difference angles', () => {
  it('come back from the directions that they give', () => {
    const random = createRandom(3);
    for (let i = 0; i < 200; i++) {
      const angles = {
        thetaH: (0.01 + 0.97 * random()) * (Math.PI / 2),
        phiH: (2 * random() - 1) * 3.1,
        thetaD: (0.01 + 0.97 * random()) * (Math.PI / 2),
        phiD: (2 * random() - 1) * 3.1,
      };
      const { l, v } = directionsFrom(angles);
      expect(Math.hypot(...l)).toBeCloseTo(1, 12);
      const back = halfDifferenceOf(l, v);
      for (const key of ['thetaH', 'phiH', 'thetaD', 'phiD'] as const) {
        expect(back[key]).toBeCloseTo(angles[key], 10);
      }
    }
  });
});

describe('the slices', () => {
  it('of Lambert are 1/pi everywhere, and its cosine with n.l', () => {
    for (const curve of [
      lightSlice(lambert, view),
      halfSlice(lambert, { thetaD: 30, phiH: 10, cosine: false }),
      differenceSlice(lambert, { thetaH: 20, phiH: 10, cosine: false }),
    ]) {
      expect(curve.length).toBeGreaterThan(150);
      for (const { rgb } of curve.slice(1, -1)) expect(rgb[0]).toBeCloseTo(1 / Math.PI, 12);
    }
    for (const { angle, rgb } of lightSlice(lambert, { ...view, cosine: true }).slice(1, -1)) {
      expect(rgb[1]).toBeCloseTo((0.5 / Math.PI) * Math.cos((angle * Math.PI) / 180), 12);
    }
  });

  it('over theta_v hold the light still: its place in f, and its cosine', () => {
    // 2 cos(theta_l) + cos(theta_v): not reciprocal, so that an exchange shows.
    const oneWay: Reflectance = (l, v) => [2 * l[2] + v[2], 0, 0];
    const cos = (angle: number) => Math.cos((angle * Math.PI) / 180);
    for (const cosine of [false, true]) {
      const curve = viewerSlice(oneWay, { thetaL: 35, phiL: 50, cosine });
      expect(curve.map(({ angle }) => angle)).toContain(35);
      for (const { angle, rgb } of curve.slice(1, -1))
        expect(rgb[0]).toBeCloseTo((2 * cos(35) + cos(angle)) * (cosine ? cos(35) : 1), 12);
    }
  });

  it('have the angles in order, the mirror direction among them', () => {
    const angles = lightSlice(lambert, view).map((point) => point.angle);
    expect(angles).toEqual([...angles].sort((a, b) => a - b));
    expect(angles).toContain(40);
    expect(angles[0]).toBe(-89.99);
    expect(angles.at(-1)).toBe(89.99);
  });

  it('show the distribution of Beckmann with its peak 1/(pi r^2) and its value beside it', () => {
    const r = 0.2;
    const d = evaluate('cook-torrance', { roughness: r }, 'distribution');
    const curve = halfSlice(d, { thetaD: 0, phiH: 0, cosine: false });
    expect(curve[0]?.rgb[0]).toBeCloseTo(1 / (Math.PI * r * r), 9);
    for (const { angle, rgb } of curve.filter((point) => point.angle < 50)) {
      const theta = (angle * Math.PI) / 180;
      const exact = Math.exp(-((Math.tan(theta) / r) ** 2)) / (Math.PI * r * r * Math.cos(theta) ** 4);
      expect(rgb[0]).toBeCloseTo(exact, 9);
    }
    const peak = lightSlice(d, view).reduce((a, b) => (b.rgb[0] > a.rgb[0] ? b : a));
    expect(peak.angle).toBeCloseTo(40, 9);
  });
});

describe('the directional albedo', () => {
  it('of Lambert is its albedo at every angle', () => {
    const curves = [...albedoCurve(lambert, 0)];
    const last = curves.at(-1) ?? [];
    expect(curves[1]?.length).toBe(2);
    expect(last[0]?.angle).toBe(0);
    expect(last.at(-1)?.angle).toBe(89);
    for (const { rgb } of last) {
      expect(rgb[0]).toBeCloseTo(1, 3);
      expect(rgb[2]).toBeCloseTo(0.25, 3);
    }
  });
});

describe('the image slice', () => {
  it('has the square-root axis and the values of the slices', () => {
    const options = { phiD: 90, cosine: false, squareRoot: true };
    expect(imageAngles(0.5, 0.5, options)).toEqual({ thetaH: 22.5, thetaD: 45 });
    expect(imageAngles(0.5, 0.5, { squareRoot: false })).toEqual({ thetaH: 45, thetaD: 45 });
    const d = evaluate('cook-torrance', { roughness: 0.3 }, 'distribution');
    const theta = (Math.PI / 2) * 0.3 ** 2;
    const exact = Math.exp(-((Math.tan(theta) / 0.3) ** 2)) / (Math.PI * 0.09 * Math.cos(theta) ** 4);
    expect(imageSliceAt(d, 0.3, 0.6, options)[0]).toBeCloseTo(exact, 9);
  });

  it('is made at growing sizes, with rows from the top', () => {
    const made = [...pictures([2, 64], (x, y) => [x, y, 0])].filter((picture) => picture !== null);
    expect(made.map(({ size }) => size)).toEqual([2, 64]);
    expect([...(made[0]?.pixels ?? [])]).toEqual([
      0.25, 0.75, 0, 0.75, 0.75, 0, 0.25, 0.25, 0, 0.75, 0.25, 0,
    ]);
  });
});

it('the luminance is that of Rec. 709', () => {
  expect(channelOf([1, 1, 1], 'luminance')).toBeCloseTo(1, 12);
  expect(channelOf([1, 2, 3], 'green')).toBe(2);
});
