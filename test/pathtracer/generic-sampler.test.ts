import { describe, expect, it, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { type ChiSquaredResult, chiSquaredTest, sidakLevel } from '../../src/analysis/chi-squared.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { type Sampler, testSampler } from '../../src/analysis/sampler-test.ts';
import { direction, type Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues, Rgb } from '../../src/brdf/model.ts';
import { resolveParameters } from '../../src/brdf/values.ts';
import type { Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { GenericTables } from '../../src/pathtracer/scene/generic-table.ts';
import { Pace } from '../../src/pathtracer/scene/pace.ts';
import { loadMeasured } from '../../src/scene/measured.ts';
import { writeMerl } from '../io/merl-writer.ts';
import {
  genericSamplerOf,
  modelWithoutSampler,
  placesWith,
  samplerOfTable,
  textWithoutSampler,
} from './generic.ts';
import { casesOf, DULL, SHARP } from './generic-materials.ts';
import { compareNoise, noiseRatio } from './generic-noise.ts';
import { evenLight, material, meanOf, narrowCamera, scene, wall } from './scenes.ts';
import { trace } from './tracer.ts';

/** The shipped models as if they had no sampler. */

const VIEWS: readonly Vec3[] = [direction(0.7, 0.5), direction(0.15, 4)];
const [dull, sharp] = [casesOf(DULL), casesOf(SHARP)];
// All together are wrong by chance once in a thousand seeds; the seed is fixed.
const level = sidakLevel(1e-3, dull.length * VIEWS.length + sharp.length);

test('every shipped model is looked at', () => {
  expect(Object.keys(DULL).sort()).toEqual([...shippedModels.keys()].sort());
});

describe('directions come as their density says', () => {
  it.each(dull)('of $name $parameters', async ({ name, parameters }) => {
    const model = modelWithoutSampler(name);
    const sampler = await genericSamplerOf(model, parameters);
    const sphere = model.file.transmission !== null;
    for (const v of VIEWS) {
      const { pValue, mass } = testSampler(sampler.seenFrom(v), {
        samples: 6000,
        random: createRandom(43),
        cells: sphere ? [16, 16] : [8, 16],
        sphere,
        focus: [[-v[0], -v[1], v[2]]],
        // The density is even within a table's cell: finer than this there is nothing to find.
        maxEvaluations: 2500,
      });
      expect(pValue, `seen from ${v}`).toBeGreaterThan(level);
      expect(mass).toBeLessThan(1.01);
    }
  });

  it.each(sharp)('of $name $parameters, seen from above', async ({ name, parameters }) => {
    const sampler = (await genericSamplerOf(modelWithoutSampler(name), parameters)).seenFrom([0, 0, 1]);
    const { pValue, mass } = testAroundNormal(sampler, 6000);
    expect(pValue).toBeGreaterThan(level);
    expect(mass).toBeLessThan(1.01);
  });
});

/** As testSampler(), in rings about the normal, above and below, that are the narrower the nearer they are to it. */
function testAroundNormal(sampler: Sampler, samples: number): ChiSquaredResult & { mass: number } {
  const [rings, sectors, points] = [24, 4, 12];
  const expected: number[] = [];
  const directionOf = (x: number, phi: number, side: number): Vec3 => {
    const t = x ** 4;
    const s = (2 * t) / (1 + t * t);
    return [s * Math.cos(phi), s * Math.sin(phi), (side * (1 - t * t)) / (1 + t * t)];
  };
  for (const side of [1, -1]) {
    for (let cell = 0; cell < rings * sectors; cell++) {
      let sum = 0;
      for (let i = 0; i < points * points; i++) {
        const x = (Math.floor(cell / sectors) + (Math.floor(i / points) + 0.5) / points) / rings;
        const phi = (2 * Math.PI * ((cell % sectors) + ((i % points) + 0.5) / points)) / sectors;
        // d omega = sin theta d theta d phi with tan(theta/2) = x^4.
        sum += (sampler.pdf(directionOf(x, phi, side)) * 16 * x ** 7) / (1 + x ** 8) ** 2;
      }
      expected.push(sum * ((2 * Math.PI) / (rings * sectors * points * points)));
    }
  }
  const mass = expected.reduce((sum, share) => sum + share, 0);
  const counts = new Array<number>(expected.length + 1).fill(0);
  const random = createRandom(46);
  for (let i = 0; i < samples; i++) {
    const l = sampler.sample([random(), random()]);
    if (l === null) {
      counts[expected.length]!++;
      continue;
    }
    const x = (Math.hypot(l[0], l[1]) / (1 + Math.abs(l[2]))) ** 0.25;
    const turn = Math.atan2(l[1], l[0]) / (2 * Math.PI);
    const sector = Math.min(Math.floor((turn < 0 ? turn + 1 : turn) * sectors), sectors - 1);
    const ring = Math.min(Math.floor(x * rings), rings - 1);
    counts[(l[2] > 0 ? 0 : rings * sectors) + ring * sectors + sector]!++;
  }
  const result = chiSquaredTest(
    counts,
    [...expected, Math.max(0, 1 - mass)].map((share) => share * samples),
  );
  return { ...result, mass };
}

describe('beside the sampler of the model’s file', () => {
  // One of them is black.
  const lit = [...dull, ...sharp].filter(({ parameters: { baseColor, metallic } }) => {
    return !(metallic === 1 && Array.isArray(baseColor) && baseColor[0] === 0);
  });
  const SAMPLES = 1000;

  it.each(lit)(
    '$name $parameters: the same light, with at most 4 times the noise',
    async ({ name, parameters }) => {
      for (const comparison of await compareNoise(name, parameters, SAMPLES)) {
        const { view, light, own, generic } = comparison;
        const where = `${light} light, seen from ${view}`;
        expect(noiseRatio(comparison), where).toBeLessThan(4);
        const chance = Math.hypot(own.deviation, generic.deviation) / Math.sqrt(SAMPLES);
        expect(Math.abs(own.mean - generic.mean), where).toBeLessThan(5 * chance + 1e-3 * own.mean);
      }
    },
  );

  it.each([
    ['principled', { metallic: 1, roughness: 0.4, anisotropic: 0.8 }],
    ['principled', { roughness: 0.2, clearcoat: 1 }],
  ] as const)('a rendering shows the same wall of %s %j', async (name, parameters) => {
    const parts = {
      ...evenLight,
      lights: {
        l: { name: 'l', type: 'rectangle', position: [-2, 1, 3], target: [0, 0, 0], luminance: 20 },
      },
      camera: narrowCamera(0.7),
      objects: { wall: wall() },
      models: { bare: { source: textWithoutSampler(name) } },
    };
    const [own, bare] = await Promise.all(
      [name, 'bare'].map(async (model) => {
        const document = scene({ ...parts, materials: { m: material(model, parameters) } });
        return meanOf((await trace(document, { samples: 64, maxDepth: 1 })).mean());
      }),
    );
    for (const [c, x] of bare!.entries()) expect(Math.abs(x / own![c]! - 1)).toBeLessThan(0.01);
  });

  it('a ball of rough glass in an even light is as bright', async () => {
    const [own, bare] = await Promise.all(
      ['dielectric', 'bare'].map(async (model) => {
        const document = scene({
          ...evenLight,
          camera: { fov: 20, position: [0, 0, 4], target: [0, 0, 0] },
          objects: { s: { name: 's', material: 'm', geometry: { type: 'sphere', radius: 1 } } },
          models: { bare: { source: textWithoutSampler('dielectric') } },
          materials: { m: material(model, { roughness: 0.4 }) },
        });
        return meanOf((await trace(document, { samples: 48, maxDepth: 16 })).mean());
      }),
    );
    for (const [c, x] of bare!.entries()) expect(Math.abs(x / own![c]! - 1)).toBeLessThan(0.01);
  });
});

describe('tables', () => {
  const bare = modelWithoutSampler('cook-torrance');
  const get = async (tables: GenericTables, materials: readonly ParameterValues[]) => {
    const pace = new Pace();
    const made = await tables.get(
      materials.map((parameters) => ({
        model: bare,
        places: placesWith(resolveParameters(bare.file, parameters)),
        isTextured: false,
      })),
      pace,
    );
    pace.end();
    return made;
  };

  it('are made once for as long as a material with these parameters is there', async () => {
    const tables = new GenericTables();
    const [a, b, c] = await get(tables, [{}, { roughness: 0.9 }, {}]);
    expect(c).toBe(a);
    expect(b).not.toBe(a);
    const [second, first] = await get(tables, [{ roughness: 0.9 }, {}]);
    expect([second === b, first === a]).toEqual([true, true]);
    const [again] = await get(tables, [{ roughness: 0.9 }]);
    expect(again).toBe(b);
    expect((await get(tables, [{}]))[0]).not.toBe(a);
  });

  it('of a textured roughness know it at several places: a narrow highlight is found', async () => {
    const pace = new Pace();
    const rough = resolveParameters(bare.file, { kd: 0, roughness: 0.9 });
    const smooth = resolveParameters(bare.file, { kd: 0, roughness: 0.05 });
    const [table] = await new GenericTables().get(
      [{ model: bare, places: [rough, smooth, rough, rough], isTextured: true }],
      pace,
    );
    pace.end();
    const sampler = samplerOfTable(bare, table!, smooth).seenFrom([0, 0, 1]);
    // A quarter of the places reflects into the narrow highlight.
    expect(sampler.pdf([0, 0, 1])).toBeGreaterThan(20);
    // And every direction may come.
    expect(sampler.pdf([0.995, 0, 0.0998749])).toBeGreaterThan(0.1 * (0.0998749 / Math.PI) * 0.5);
  });

  it('are null for models that bring a sampler', async () => {
    const pace = new Pace();
    const model = shippedModels.get('lambert') as Model;
    const material = { model, places: placesWith(resolveParameters(model.file, {})), isTextured: false };
    expect(await new GenericTables().get([material], pace)).toEqual([null]);
    pace.end();
  });
});

test('measured data are drawn as they were measured', async () => {
  // Grey below GGX's highlight of alpha .2.
  const f = (l: Vector3, v: Vector3): Rgb => {
    const h = [l[0] + v[0], l[1] + v[1], l[2] + v[2]] as const;
    const cosine2 = h[2] ** 2 / (h[0] ** 2 + h[1] ** 2 + h[2] ** 2);
    const d = 0.2 ** 2 / (Math.PI * (cosine2 * (0.2 ** 2 - 1) + 1) ** 2);
    const value = 0.1 / Math.PI + 0.05 * d;
    return [value, value, value];
  };
  const model = loadMeasured(writeMerl(f), 'gloss.binary');
  const v = direction(0.6, 1);
  const sampler = (await genericSamplerOf(model, {})).seenFrom(v);
  const random = createRandom(45);
  const weights = Array.from({ length: 1000 }, () => {
    const l = sampler.sample([random(), random()]);
    return l === null ? 0 : (f(l, v)[1] * l[2]) / sampler.pdf(l);
  });
  const mean = weights.reduce((sum, weight) => sum + weight, 0) / weights.length;
  const variance = weights.reduce((sum, weight) => sum + (weight - mean) ** 2, 0) / weights.length;
  expect(Math.sqrt(variance) / mean).toBeLessThan(0.2);
});
