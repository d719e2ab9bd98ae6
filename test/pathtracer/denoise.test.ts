import { describe, expect, test } from 'vitest';
import { denoise } from '../../src/pathtracer/denoise/denoise.ts';
import { FILM_FLOATS, Film } from '../../src/pathtracer/film.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { packDocument, render, testTracer } from './tracer.ts';

/** Numbers of 0 to 1 that are the same in each run. */
function randomNumbers(seed: number) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

interface Sample {
  readonly radiance: number;
  readonly albedo?: number;
  readonly depth?: number;
  readonly hit?: boolean;
}

const SIZE = 32;

/** A film of samples that a function gives. */
function filmOf(samples: (pixel: number) => number, sample: (x: number, y: number) => Sample): Film {
  const film = new Film(SIZE, SIZE);
  for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
    for (let i = 0; i < samples(pixel); i++) {
      const {
        radiance: r,
        albedo: a = 0.5,
        depth = 3,
        hit = true,
      } = sample(pixel % SIZE, Math.floor(pixel / SIZE));
      const slots = new Float32Array(FILM_FLOATS);
      slots.set([r, r, r, 1, r * r, r * r, r * r, 0]);
      if (hit) slots.set([a, a, a, 3 * a * a, 0, 0, 1, 0, depth, 1], 8);
      film.add(slots, pixel);
    }
  }
  return film;
}

const meanSquare = (values: Float32Array, truth: (x: number, y: number) => number) =>
  values.reduce((sum, value, i) => {
    const pixel = Math.floor(i / 3);
    return sum + (value - truth(pixel % SIZE, Math.floor(pixel / SIZE))) ** 2;
  }, 0) / values.length;

describe('a noisy wall', () => {
  const random = randomNumbers(1);
  // Exponential: many dark samples, few bright ones, as light has them.
  const noisy = (mean: number) => -mean * Math.log(1 - random());

  test('has a thirtieth of the noise', async () => {
    const film = filmOf(
      () => 8,
      () => ({ radiance: noisy(1) }),
    );
    const before = meanSquare(film.mean(), () => 1);
    const after = meanSquare(await denoise(film), () => 1);
    expect(after).toBeLessThan(before / 30);
  });

  test('keeps its texture, the shadow that falls on it, and what stands before it', async () => {
    const albedo = (x: number) => (x % 4 < 2 ? 0.2 : 0.8);
    const truth = (x: number, y: number) => (y < 16 ? 1 : 0.1) * albedo(x);
    const film = filmOf(
      () => 16,
      (x, y) => ({ radiance: noisy(truth(x, y)), albedo: albedo(x) }),
    );
    const before = meanSquare(film.mean(), truth);
    const out = await denoise(film);
    expect(meanSquare(out, truth)).toBeLessThan(before / 10);
    // Beside the shadow's edge: the same, in the mean over the rows' pixels.
    for (const y of [15, 16]) {
      const row = Array.from({ length: SIZE }, (_, x) => out[3 * (y * SIZE + x)]! / truth(x, y));
      const mean = row.reduce((sum, x) => sum + x, 0) / SIZE;
      expect(mean).toBeGreaterThan(0.85);
      expect(mean).toBeLessThan(1.25);
    }
  });

  test('is not dark where a firefly was, nor bright', async () => {
    const film = filmOf(
      () => 8,
      () => ({ radiance: noisy(1) }),
    );
    const slots = new Float32Array(FILM_FLOATS);
    slots.set([1e4, 1e4, 1e4, 1, 1e8, 1e8, 1e8, 0, 0.5, 0.5, 0.5, 0.75, 0, 0, 1, 0, 3, 1]);
    film.add(slots, 16 * SIZE + 16);
    const out = await denoise(film);
    expect(Math.max(...out)).toBeLessThan(3);
    expect(Math.min(...out)).toBeGreaterThan(0.6);
  });
});

test('a picture without noise stays as it is', async () => {
  const truth = (x: number, y: number) => 1 + Math.sin(x / 2) * Math.cos(y / 3);
  const film = filmOf(
    () => 4,
    (x, y) => ({ radiance: truth(x, y), hit: x > 8, albedo: 0.3 }),
  );
  expect(meanSquare(await denoise(film), truth)).toBeLessThan(1e-8);
});

test('pixels of no, one and many samples; black pictures; pictures of one pixel', async () => {
  const random = randomNumbers(2);
  const mixed = filmOf(
    (pixel) => pixel % 5,
    () => ({ radiance: random(), hit: random() < 0.7, albedo: random() < 0.2 ? 0 : random() }),
  );
  expect((await denoise(mixed)).every((x) => x >= 0 && x < 4)).toBe(true);
  const black = filmOf(
    () => 2,
    () => ({ radiance: 0, hit: false }),
  );
  expect((await denoise(black)).every((x) => x === 0)).toBe(true);
  expect(await denoise(new Film(1, 1))).toEqual(new Float32Array(3));
});

test('the film stays as it was; progress ends with 1; a signal ends the work', async () => {
  const random = randomNumbers(3);
  const film = filmOf(
    () => 4,
    () => ({ radiance: random() }),
  );
  const before = structuredClone(film.radiance);
  const parts: number[] = [];
  await denoise(film, { onProgress: (part) => parts.push(part) });
  expect(film.radiance).toEqual(before);
  expect(parts).toEqual(parts.toSorted((a, b) => a - b));
  expect(parts.at(-1)).toBe(1);
  await expect(denoise(film, { signal: AbortSignal.abort() })).rejects.toThrow('abort');
});

test('a rendered picture has less than half of the error', async () => {
  const document = parseDocument(
    {
      format: 'irradia',
      version: 1,
      name: 'shadow',
      camera: { fov: 40, position: [0, 1.5, 4], target: [0, 0.4, 0] },
      environment: { source: { type: 'constant', color: [0.2, 0.3, 0.5] } },
      lights: {
        lamp: {
          type: 'rectangle',
          luminance: 20,
          width: 1,
          height: 1,
          position: [2, 3, 1],
          target: [0, 0, 0],
        },
      },
      objects: {
        ground: { material: 'red', rotation: [-90, 0, 0], geometry: { type: 'plane', width: 6, height: 6 } },
        ball: { material: 'gloss', position: [0, 0.5, 0], geometry: { type: 'sphere', radius: 0.5 } },
      },
      materials: {
        red: { model: 'lambert', parameters: { albedo: [0.8, 0.2, 0.1] } },
        gloss: { model: 'principled', parameters: { roughness: 0.3, baseColor: [0.2, 0.5, 0.8] } },
      },
    },
    'shadow',
  );
  const tracer = testTracer();
  await tracer.load(await packDocument(document));
  const size = { width: 48, height: 32 };
  const truth = (await render(tracer, document, { samples: 512, seed: 9, ...size })).mean();
  const film = await render(tracer, document, { samples: 8, ...size });
  const error = (picture: Float32Array) =>
    picture.reduce((sum, x, i) => sum + (x - truth[i]!) ** 2 / (truth[i]! ** 2 + 0.01), 0);
  const [before, after] = [error(film.mean()), error(await denoise(film))];
  expect(after).toBeLessThan(before / 2);
});
