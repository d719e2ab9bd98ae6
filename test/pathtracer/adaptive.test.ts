import { describe, expect, test } from 'vitest';
import { renderPasses } from '../../src/cli/render/passes.ts';
import { BASE_SAMPLES, openTiles, tileErrors } from '../../src/pathtracer/adaptive.ts';
import { FILM_FLOATS, Film } from '../../src/pathtracer/film.ts';
import { maskedPixels, pixelRuns } from '../../src/pathtracer/tiles.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { packDocument, testSettings, testTracer } from './tracer.ts';

/** A lamp's soft shadow in one corner of a picture that is plain elsewhere. */
const corner = parseDocument(
  {
    format: 'irradia',
    version: 1,
    name: 'corner',
    camera: { fov: 50, position: [0, 0, 4], target: [0, 0, 0] },
    background: { type: 'color', color: [0.3, 0.3, 0.3] },
    environment: { source: { type: 'constant', color: [0.3, 0.3, 0.3] } },
    lights: {
      lamp: { type: 'rectangle', luminance: 30, width: 1, height: 1, position: [1, 1, 2], target: [1, 1, 0] },
    },
    objects: {
      wall: { material: 'white', position: [1.2, 1.2, 0], geometry: { type: 'plane', width: 1, height: 1 } },
      ball: { material: 'white', position: [1.2, 1.2, 0.5], geometry: { type: 'sphere', radius: 0.25 } },
    },
    materials: { white: { model: 'lambert' } },
  },
  'corner',
);
const size = { width: 72, height: 56 };
const pixels = size.width * size.height;

async function tracer() {
  const made = testTracer();
  await made.load(await packDocument(corner));
  made.start(corner.camera, { ...testSettings, ...size });
  return made;
}

describe('tiles', () => {
  test('runs are the pixels of a mask, each once; all of them without one', () => {
    const mask = Uint8Array.from({ length: 20 }, (_, tile) => (tile % 3 === 0 ? 1 : 0));
    const runs = pixelRuns(72, 56, 20, mask);
    const taken = new Uint8Array(pixels);
    for (const { from, to } of runs) {
      expect(to - from).toBeLessThanOrEqual(20);
      for (let pixel = from; pixel < to; pixel++) taken[pixel]! += 1;
    }
    const expected = taken.map((_, pixel) => {
      const [x, y] = [pixel % 72, Math.floor(pixel / 72)];
      return mask[5 * Math.floor(y / 16) + Math.floor(x / 16)]!;
    });
    expect(taken).toEqual(expected);
    expect(taken.reduce((sum, n) => sum + n, 0)).toBe(maskedPixels(72, 56, mask));
    expect(pixelRuns(72, 56, 4096)).toEqual([{ from: 0, to: pixels }]);
  });

  test('a pass of some tiles adds what a pass of all does to them, and nothing to others', async () => {
    const [all, some] = [await tracer(), await tracer()];
    await all.render(0, 2);
    const mask = Uint8Array.from({ length: 20 }, (_, tile) => tile & 1);
    const parts: number[] = [];
    await some.render(0, 2, { tiles: mask, onProgress: (part) => parts.push(part) });
    await some.render(2, 2, { tiles: new Uint8Array(20) });
    const [whole, film] = [await all.film(), await some.film()];
    for (let pixel = 0; pixel < pixels; pixel++) {
      const isTaken = mask[5 * Math.floor(Math.floor(pixel / 72) / 16) + Math.floor((pixel % 72) / 16)] === 1;
      expect(film.count[pixel]).toBe(isTaken ? 2 : 0);
      expect(film.radiance[3 * pixel]).toBe(isTaken ? whole.radiance[3 * pixel] : 0);
    }
    expect(parts.at(-1)).toBe(1);
  });
});

/** A film whose tiles of 16 x 16 have samples of 1 and 1 + 2 spread in turn, hence an error in proportion to it. */
function filmOf(spreads: readonly number[]): Film {
  const film = new Film(16 * spreads.length, 16);
  for (let pixel = 0; pixel < film.count.length; pixel++) {
    const spread = spreads[Math.floor((pixel % film.width) / 16)]!;
    for (let i = 0; i < 4; i++) {
      const value = 1 + (i % 2 === 0 ? -spread : spread);
      const slots = new Float32Array(FILM_FLOATS);
      slots.set([value, value, value, 1, value ** 2, value ** 2, value ** 2]);
      film.add(slots, pixel);
    }
  }
  return film;
}

describe("a tile's error", () => {
  test('is the deviation of its means over the mean; none above E means a picture of E at most', () => {
    const film = filmOf([0, 0.3, 0.6]);
    const errors = tileErrors(film);
    for (const [i, spread] of [0, 0.3, 0.6].entries())
      expect(errors[i]).toBeCloseTo(spread / Math.sqrt(3), 5);
    expect(film.relativeError()).toBeLessThanOrEqual(Math.max(...errors));
    expect(tileErrors(new Film(16, 16))).toEqual(Float32Array.of(Number.POSITIVE_INFINITY));
  });

  test('opens tiles above the goal and noisy ones beside them; those that ended stay so near the goal', () => {
    const film = filmOf([0.1, 0.15, 0.6, 0.15, 0.22, 0.19]);
    const goal = 0.2 / Math.sqrt(3);
    expect([...(openTiles(film, goal, null) ?? [])]).toEqual([0, 1, 1, 1, 1, 1]);
    expect([...(openTiles(film, goal, Uint8Array.of(0, 1, 1, 1, 0, 0)) ?? [])]).toEqual([0, 1, 1, 1, 0, 0]);
    expect(openTiles(film, 1, null)).toBeNull();
  });
});

test('of as many samples, the worst tile has less error than if every pixel had the same; nobody starves', async () => {
  const adaptive = await renderPasses(await tracer(), {
    first: 0,
    until: { kind: 'error', error: 0.12, most: 4096 },
    pixels,
    pathsPerPass: 2 ** 19,
    signal: new AbortController().signal,
  });
  const film = adaptive.film as Film;
  const errors = tileErrors(film);
  expect(Math.max(...errors)).toBeLessThanOrEqual(0.12 * 1.25);
  expect(film.relativeError()).toBeLessThanOrEqual(0.12);
  const counts = [...film.count];
  expect(Math.min(...counts)).toBeGreaterThanOrEqual(BASE_SAMPLES);
  expect(Math.max(...counts)).toBe(adaptive.numbers);
  expect(adaptive.samples).toBeCloseTo(counts.reduce((sum, n) => sum + n, 0) / pixels, 9);
  expect(adaptive.samples).toBeLessThan(adaptive.numbers / 2);

  const uniform = await tracer();
  await uniform.render(0, Math.ceil(adaptive.samples));
  expect(Math.max(...tileErrors(await uniform.film()))).toBeGreaterThan(1.3 * Math.max(...errors));
});
