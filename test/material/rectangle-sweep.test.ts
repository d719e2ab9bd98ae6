import { expect, test } from 'vitest';
import { loadModel, shippedModels } from '../../models/index.ts';
import { createQuickEvaluator } from '../../src/analysis/quick-evaluator.ts';
import { createEvaluator, type Evaluator, LOCAL_FRAME, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { genericSampler, highlightAlpha } from '../../src/material/generic-sampler.ts';
import { lattice } from './broad-light.ts';
import { type Drawn, drawn, type Lit, type Panel, quadrature } from './lit-rectangle.ts';
import { modelNamed } from './lit-sphere.ts';

/**
 * How far the renderer's quadrature over rectangles is from the integral: models, roughnesses, views down to 5 degrees above the
 * surface, and lamps from a tube to a ceiling, around the place that a mirror would show. The horizon cuts many of them.
 *
 * IRRADIA_RECTANGLES=all prints the whole table, in some minutes.
 */
const ALL = process.env.IRRADIA_RECTANGLES === 'all';

/** Width, height and distance in metres; by how many degrees they are turned away from the point. */
const LAMPS = {
  'soft box': [1.6, 1, 2.5, 0],
  ceiling: [4, 4, 2, 0],
  tube: [1.2, 0.04, 2, 0],
  small: [0.1, 0.1, 3, 0],
  turned: [1.2, 1.2, 2, 75],
  near: [1, 1, 0.3, 0],
} as const;
type LampName = keyof typeof LAMPS;
const LAMP_NAMES = Object.keys(LAMPS) as LampName[];

/** Cosines of the view. */
const VIEWS = ALL ? [0.08, 0.3, 0.7, 0.98] : [0.08, 0.5];
/** Places of each lamp, up to two and a half of its half sides away from where a mirror would show its middle. */
const PLACES = ALL ? 24 : 10;
/** Samples of either kind of the integral. */
const MANY = ALL ? 4096 : 1024;
const ROUGHNESSES = ALL ? [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1] : [0.1, 0.4];

/** A file without a sampler. */
const stranger = loadModel(
  `analytic
::begin parameters
float n 1 1000000 40
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  return vec3(.1 + .024 * (n + 2.) * pow(max(dot(N, normalize(L + V)), 0.), n));
}
::end shader
`,
  'stranger.brdf',
);

type Case = readonly [title: string, model: Model, values: Record<string, unknown>];

function cases(): Case[] {
  const looks: [string, Record<string, number>][] = [
    ['cook-torrance', {}],
    ['cook-torrance', { metallic: 1 }],
    ['principled', {}],
    ['principled', { metallic: 1 }],
    ['principled', { metallic: 1, anisotropic: 0.8 }],
    ['principled', { clearcoat: 1 }],
    ['principled-thesis', {}],
    ['principled-thesis', { metallic: 1 }],
    ['principled-bsdf', {}],
    ['principled-bsdf', { metallic: 1 }],
    ['dielectric', {}],
  ];
  return [
    ['lambert', modelNamed('lambert'), {}],
    ...ROUGHNESSES.flatMap((roughness): Case[] => [
      ...looks.map(([name, values]): Case => {
        const all = { ...values, roughness };
        return [`${name} ${JSON.stringify(all)}`, modelNamed(name), all];
      }),
      // As wide as GGX of this roughness is.
      [`without a sampler, ${roughness}`, stranger, { n: 2 / roughness ** 4 }],
    ]),
  ];
}

/** What the renderer evaluates: float32, and the generic sampler where the model has none. */
function reflection(model: Model, values: Record<string, unknown>): Lit['evaluator'] {
  const exact = createEvaluator(model, values);
  const f = createQuickEvaluator(model, values).term('BRDF');
  const generic = { alpha: model.hasSampling ? 1 : highlightAlpha(exact) };
  const sampler: Pick<Evaluator, 'sampleL'> = model.hasSampling
    ? exact
    : createEvaluator(genericSampler, generic);
  const quick = model.hasSampling
    ? createQuickEvaluator(model, values)
    : createQuickEvaluator(genericSampler, generic);
  const pdf = quick.pdf();
  return {
    f: (l, v) => f(l, v) as [number, number, number],
    pdf: (l, v) => pdf(l, v),
    sampleL: (u, v) => sampler.sampleL(u, v),
  };
}

const combined = (...parts: readonly (readonly [number, Vector3])[]): Vector3 => {
  const sum = (c: 0 | 1 | 2) => parts.reduce((total, [weight, v]) => total + weight * v[c], 0);
  return [sum(0), sum(1), sum(2)];
};

/** A lamp whose point (a, b), in half sides, is where the mirror shows it; +y is to its right. */
function placed(lamp: LampName, mirrored: Vector3, a: number, b: number): Panel {
  const [width, height, distance, degrees] = LAMPS[lamp];
  const right: Vector3 = [0, 1, 0];
  const over: Vector3 = [-mirrored[2], 0, mirrored[0]];
  const [sine, cosine] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  const up = combined([cosine, over], [sine, mirrored]);
  return {
    center: combined([distance, mirrored], [(-a * width) / 2, right], [(-b * height) / 2, up]),
    right,
    up,
    facing: combined([-cosine, mirrored], [sine, over]),
    width,
    height,
  };
}

/** The mean distance from the integral as a part of its mean, for each lamp. */
function errors([, model, values]: Case): number[] {
  const evaluator = reflection(model, values);
  const far = new Map(LAMP_NAMES.map((lamp) => [lamp, { distance: 0, sum: 0 }]));
  for (const z of VIEWS) {
    const x = Math.sqrt(1 - z * z);
    const lit: Lit = { evaluator, point: [0, 0, 0], V: [-x, 0, z], frame: LOCAL_FRAME };
    const [few, many]: [Drawn, Drawn] = [drawn(lit), drawn(lit, MANY)];
    for (const [lamp, total] of far) {
      for (let i = 0; i < PLACES; i++) {
        const [a, b] = lattice(i, PLACES).map((u) => 5 * u - 2.5) as [number, number];
        const panel = placed(lamp, [x, 0, z], a, b);
        const shown = quadrature(lit, panel, few);
        const exact = quadrature(lit, panel, many, MANY);
        for (const c of [0, 1, 2] as const) {
          total.distance += Math.abs(shown[c]! - exact[c]!);
          total.sum += exact[c]!;
        }
      }
    }
  }
  return [...far.values()].map(({ distance, sum }) => distance / sum);
}

const mean = (values: readonly number[]) => values.reduce((sum, x) => sum + x, 0) / values.length;
const percent = (x: number) => (100 * x).toFixed(1).padStart(9);

test('every shipped model that reflects is looked at', () => {
  const looked = new Set(cases().map(([, { name }]) => name));
  for (const name of shippedModels.keys()) expect(looked).toContain(name);
});

test('rectangles are within 5 % of the integral in the mean', { timeout: 1_800_000 }, () => {
  const rows = cases().map((one) => [one[0], errors(one)] as const);
  const widest = Math.max(...rows.map(([title]) => title.length));
  if (ALL) {
    console.log(['%'.padEnd(widest), ...LAMP_NAMES.map((name) => name.padStart(9)), '     mean'].join(''));
    for (const [title, row] of rows)
      console.log([title.padEnd(widest), ...[...row, mean(row)].map(percent)].join(''));
    console.log(
      ['mean'.padEnd(widest), ...LAMP_NAMES.map((_, i) => percent(mean(rows.map(([, r]) => r[i]!))))].join(
        '',
      ),
    );
  }
  // A polished coat's lobe is a tenth of a degree wide with a tail over all directions: few samples are its own.
  for (const [title, row] of rows)
    expect(mean(row), title).toBeLessThan(title.includes('clearcoat') ? 0.11 : 0.05);
  expect(mean(rows.flatMap(([, row]) => row))).toBeLessThan(0.03);
});
