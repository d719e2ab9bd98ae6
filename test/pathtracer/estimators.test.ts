import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import type { PathTracer } from '../../src/pathtracer/path-tracer.ts';
import type { RenderSettings } from '../../src/pathtracer/scene/camera.ts';
import { parseDocument } from '../../src/scene/document.ts';
import type { Document } from '../../src/scene/schema.ts';
import { randomParameters } from '../models/hostile.ts';
import { evenLight, material, meanOf, scene, wall } from './scenes.ts';
import { packDocument, render, testTracer, trace } from './tracer.ts';

/** Renderings against each other: what must not depend on how it is estimated, split or repeated. */

const thesis = () => parseDocument(readFileSync('scenes/thesis.json', 'utf8'), 'thesis.json');

/** A corner with a glossy ball, lit by a rectangle, a glowing box and the sky: every light that has an extent. */
function corner(): Document {
  return scene({
    ...evenLight,
    camera: { fov: 50, position: [0, 0.2, 3.5], target: [0, 0, 0] },
    environment: { source: { type: 'constant', color: [0.2, 0.3, 0.4] } },
    lights: {
      panel: {
        type: 'rectangle',
        luminance: 6,
        position: [0, 2, 1],
        target: [0, 0, 0],
        width: 1,
        height: 0.6,
      },
    },
    objects: {
      wall: wall({ position: [0, 0, -1], scale: [3, 3, 1] }),
      floor: wall({ position: [0, -1, 0], rotation: [-90, 0, 0], scale: [3, 3, 1] }),
      ball: {
        name: 'ball',
        material: 'gloss',
        position: [-0.5, -0.4, 0],
        geometry: { type: 'sphere', radius: 0.6 },
      },
      lamp: {
        name: 'lamp',
        material: 'lamp',
        position: [0.9, -0.5, 0.3],
        geometry: { type: 'box', width: 0.3, height: 0.6, depth: 0.3 },
      },
    },
    materials: {
      m: material('cook-torrance', { kd: 0.8, roughness: 0.5 }),
      gloss: material('principled', { metallic: 0.5, roughness: 0.35 }),
      lamp: material(
        'lambert',
        { albedo: [0.3, 0.3, 0.3] },
        { emissive: [1, 0.6, 0.3], emissiveIntensity: 4 },
      ),
    },
  });
}

/** The mean of a small picture and the variance of that, from several seeds. */
async function estimate(
  tracer: PathTracer,
  document: Document,
  strategy: RenderSettings['strategy'],
  seeds: number,
): Promise<{ mean: number; variance: number }> {
  const means: number[] = [];
  for (let seed = 0; seed < seeds; seed++) {
    const settings = { samples: 16, width: 16, height: 16, maxDepth: 3, strategy, seed };
    const film = await render(tracer, document, settings);
    means.push(meanOf(film.mean()).reduce((a, b) => a + b, 0));
  }
  const mean = means.reduce((a, b) => a + b, 0) / seeds;
  return { mean, variance: means.reduce((sum, x) => sum + (x - mean) ** 2, 0) / (seeds - 1) / seeds };
}

describe('estimators', () => {
  it('agree with lights sampled, directions sampled, and both (z-test over 32 seeds)', async () => {
    const document = corner();
    const tracer = testTracer();
    await tracer.load(await packDocument(document));
    const mis = await estimate(tracer, document, 'mis', 32);
    for (const other of ['light', 'brdf'] as const) {
      const { mean, variance } = await estimate(tracer, document, other, 32);
      // 4 deviations: wrong by chance once in 16,000; the seeds are fixed.
      expect(Math.abs(mean - mis.mean) / Math.sqrt(variance + mis.variance), other).toBeLessThan(4);
      // The test would not see much if the estimates were loose.
      expect(Math.sqrt(variance) / mean, other).toBeLessThan(0.02);
      // Weighing both must not be much worse than the better one.
      expect(mis.variance).toBeLessThan(1.5 * variance);
    }
  });

  it.each([
    ['even fog', { height: 0, base: 0 }],
    ['fog that thins with height', { height: 0.4, base: -0.7 }],
  ])('agree in %s', async (_name, shape) => {
    const color: [number, number, number] = [0.9, 0.8, 0.7];
    const document = { ...corner(), fog: { density: 0.3, color, anisotropy: 0.4, ...shape } };
    const tracer = testTracer();
    await tracer.load(await packDocument(document));
    const mis = await estimate(tracer, document, 'mis', 16);
    const brdf = await estimate(tracer, document, 'brdf', 16);
    expect(Math.abs(mis.mean - brdf.mean) / Math.sqrt(mis.variance + brdf.variance)).toBeLessThan(4);
  });
});

describe('samples', () => {
  it('are the same bits for the same seed, and others for another', async () => {
    const settings = { samples: 4, width: 24, height: 16 };
    const [a, b, c] = [
      await trace(thesis(), settings),
      await trace(thesis(), settings),
      await trace(thesis(), { ...settings, seed: 1 }),
    ];
    expect(a!.radiance).toEqual(b!.radiance);
    expect(a!.radiance).not.toEqual(c!.radiance);
  });

  it('of two halves of a range add up to the whole', async () => {
    const document = thesis();
    const tracer = testTracer();
    await tracer.load(await packDocument(document));
    const size = { width: 24, height: 16 };
    const whole = await render(tracer, document, { samples: 12, ...size });
    tracer.start(document.camera, { maxDepth: 8, seed: 0, strategy: 'mis', clamp: 0, ...size });
    await tracer.render(0, 5);
    await tracer.render(5, 7);
    const halves = await tracer.film();
    expect(halves.count).toEqual(whole.count);
    for (const [i, x] of whole.radiance.entries()) expect(halves.radiance[i]!).toBeCloseTo(x, 4);
  });

  it('leave blue noise: neighbours complement one another', async () => {
    // A wall under a panel: a smooth picture, so that all that differs from the reference is noise.
    const document = scene({
      camera: { fov: 30, position: [0, 0, 3], target: [0, 0, 0] },
      lights: {
        panel: {
          type: 'rectangle',
          luminance: 5,
          position: [0, 0, 1],
          target: [0, 0, 0],
          width: 1.5,
          height: 1.5,
        },
      },
      objects: { wall: wall() },
      materials: { m: material('lambert') },
    });
    const side = 64;
    const size = { width: side, height: side, maxDepth: 1 };
    const reference = (await trace(document, { samples: 256, seed: 4, ...size })).mean();
    for (const samples of [1, 4]) {
      const picture = (await trace(document, { samples, ...size })).mean();
      const error = picture.map((x, i) => x - reference[i]!).filter((_, i) => i % 3 === 0);
      const variance = error.reduce((sum, e) => sum + e * e, 0) / error.length;
      // Means over 4 x 4 pixels: of white noise they have 1/16 of the variance.
      let blocks = 0;
      for (let y = 0; y < side; y += 4) {
        for (let x = 0; x < side; x += 4) {
          let sum = 0;
          for (let i = 0; i < 16; i++) sum += error[(y + (i >> 2)) * side + x + (i & 3)]!;
          blocks += (sum / 16) ** 2 / (side / 4) ** 2;
        }
      }
      expect(blocks / (variance / 16), `${samples} samples`).toBeLessThan(0.3);
    }
  });

  it('converge: four times as many have about half the error', async () => {
    const document = corner();
    const tracer = testTracer();
    await tracer.load(await packDocument(document));
    const size = { width: 16, height: 16, maxDepth: 3 };
    const reference = (await render(tracer, document, { samples: 2048, seed: 9, ...size })).mean();
    const errorOf = async (samples: number) => {
      const picture = (await render(tracer, document, { samples, ...size })).mean();
      return Math.sqrt(picture.reduce((sum, x, i) => sum + (x - reference[i]!) ** 2, 0) / picture.length);
    };
    const ratio = (await errorOf(16)) / (await errorOf(64));
    // Independent samples would give 2, well-spread ones more.
    expect(ratio).toBeGreaterThan(1.6);
  });
});

it('no document gives a NaN or a negative pixel (1,000 random ones)', { timeout: 120_000 }, async () => {
  const random = createRandom(77);
  const tracer = testTracer();
  const models = [...shippedModels.values()];
  const between = (low: number, high: number) => low + (high - low) * random();
  const point = (): [number, number, number] => [between(-2, 2), between(-2, 2), between(-2, 2)];
  const color = () => [random(), random(), random()];
  const shapes = [
    () => ({ type: 'sphere', radius: between(0.05, 1), widthSegments: 8, heightSegments: 6 }),
    () => ({ type: 'box', width: between(0.1, 2), height: between(0.1, 2), depth: between(0.1, 2) }),
    () => ({ type: 'torus', radius: 0.5, tube: between(0.02, 0.4), radialSegments: 6, tubularSegments: 8 }),
    () => ({ type: 'plane', width: between(0.1, 4), height: between(0.1, 4) }),
  ];
  const lights = [
    () => ({ type: 'point', intensity: between(0, 50), position: point() }),
    () => ({
      type: 'spot',
      intensity: between(0, 50),
      position: point(),
      target: point(),
      cutoff: between(1, 89),
      exponent: between(0, 60),
      penumbra: random(),
    }),
    () => ({ type: 'directional', illuminance: between(0, 5), position: point(), target: point() }),
    () => ({
      type: 'rectangle',
      luminance: between(0, 20),
      position: point(),
      target: point(),
      width: between(0.01, 2),
      height: between(0.01, 2),
    }),
    () => ({ type: 'ambient', luminance: random() }),
    () => ({ type: 'hemisphere', luminance: random() }),
  ];
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)] as T;
  for (let i = 0; i < 1000; i++) {
    const entries = models.map((model, m) => {
      const emissive = random() < 0.15 ? { emissive: color(), emissiveIntensity: between(0, 10) } : {};
      const alpha = random() < 0.1 ? { alphaMode: 'blend', opacity: random() } : {};
      const parameters = randomParameters(random, model.parameters);
      return [
        `m${m}`,
        material(model.name, parameters, { doubleSided: random() < 0.5, ...emissive, ...alpha }),
      ] as const;
    });
    // Every model in every document: another set would be another kernel to compile.
    const objects = models.map((_, m) => [
      `o${m}`,
      {
        name: 'o',
        material: `m${m}`,
        geometry: pick(shapes)(),
        position: point(),
        rotation: [between(-180, 180), between(-180, 180), between(-180, 180)],
        scale: [between(-2, 2), between(-2, 2), between(-2, 2)],
      },
    ]);
    const document = scene({
      camera: {
        fov: between(5, 120),
        position: point(),
        target: point(),
        fStop: random() < 0.3 ? between(0.5, 16) : 0,
      },
      ...(random() < 0.3 ? evenLight : {}),
      ...(random() < 0.2
        ? { fog: { density: between(0, 2), color: color(), anisotropy: between(-0.9, 0.9) } }
        : {}),
      objects: Object.fromEntries(objects),
      materials: Object.fromEntries(entries),
      lights: Object.fromEntries(Array.from({ length: 3 }, (_, l) => [`l${l}`, pick(lights)()])),
    });
    await tracer.load(await packDocument(document));
    const film = await render(tracer, document, { samples: 1, width: 6, height: 6, seed: i });
    const bad = film.radiance.findIndex((x) => !(x >= 0 && x < Number.POSITIVE_INFINITY));
    if (bad >= 0) expect.fail(`${film.radiance[bad]} in document ${i}: ${JSON.stringify(document)}`);
  }
});
