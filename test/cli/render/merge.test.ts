import { describe, expect, test } from 'vitest';
import { mergeParts, partOf } from '../../../src/cli/render/merge.ts';
import { filmToExr } from '../../../src/cli/render/picture.ts';
import { decodeExr } from '../../../src/io/exr.ts';
import { FILM_FLOATS, Film } from '../../../src/pathtracer/film.ts';
import type { Range } from '../../../src/pathtracer/ranges.ts';
import type { RenderRecord } from '../../../src/pathtracer/record.ts';

const SIZE = 5;
const AOVS = ['albedo', 'normal', 'depth', 'variance'] as const;

/** What the kernel would write for a sample: anything, the same for the same number; some samples hit nothing. */
function sample(pixel: number, number: number): Float32Array {
  const random = (i: number) => (Math.sin(12.9898 * pixel + 78.233 * number + 37.719 * i) * 43758.5453) % 1;
  const [r, g, b] = [0, 1, 2].map((i) => 3 * random(i) ** 2) as [number, number, number];
  const hit = random(3) > 0 ? 1 : 0;
  const slots = new Float32Array(FILM_FLOATS);
  slots.set([r, g, b, 1, r * r, g * g, b * b, 0, ...[4, 5, 6].map(random), 0, ...[7, 8, 9].map(random), 0]);
  slots.set([hit * (5 + random(10)), hit], 16);
  return slots;
}

const record: RenderRecord = {
  renderer: 'pathtracer',
  version: '1.2.3',
  document: 'ab'.repeat(32),
  camera: '{}',
  seed: 7,
  maxDepth: 4,
  clamp: 0.5,
  strategy: 'mis',
  name: 'Scène',
  samples: [],
  until: 'samples',
  device: 'fake',
  exposure: -1.5,
  toneMapping: 'agx',
  denoised: false,
};

function part(
  name: string,
  { from, to }: Range,
  change: Partial<RenderRecord> = {},
  size = SIZE,
  aovs: readonly (typeof AOVS)[number][] = AOVS,
) {
  const film = new Film(size, SIZE);
  for (let pixel = 0; pixel < size * SIZE; pixel++) {
    for (let number = from; number < to; number++) film.add(sample(pixel, number), pixel);
  }
  const file = filmToExr(film, { ...record, samples: [{ from, to }], ...change }, aovs);
  return partOf(decodeExr(file, name), name);
}

describe('merge', () => {
  test('gives what one rendering of all samples gives, in every layer', () => {
    const parts = [
      part('b', { from: 3, to: 4 }),
      part('a', { from: 0, to: 3 }),
      part('c', { from: 4, to: 16 }),
    ];
    const whole = part('whole', { from: 0, to: 16 });
    const { image, record: merged } = mergeParts(parts);
    expect(merged.samples).toEqual([{ from: 0, to: 16 }]);
    expect(image.channels).toHaveLength(14);
    for (const { name, pixels } of image.channels) {
      const expected = whole.image.channels.find((channel) => channel.name === name)?.pixels ?? [];
      pixels.forEach((value, i) => {
        expect(Math.abs(value - expected[i]!), `${name} ${i}`).toBeLessThan(1e-6 * (1 + Math.abs(value)));
      });
    }
  });

  test('keeps the ranges where there is a gap, so that the gap can be filled later', () => {
    const [a, c] = [part('a', { from: 0, to: 4 }), part('c', { from: 8, to: 9 })];
    const { image } = mergeParts([c, a]);
    const again = partOf(image, 'ac');
    expect(again.record.samples).toEqual([
      { from: 0, to: 4 },
      { from: 8, to: 9 },
    ]);
    expect(mergeParts([again, part('b', { from: 4, to: 8 })]).record.samples).toEqual([{ from: 0, to: 9 }]);
  });

  test('weighs every pixel by its own number of samples, where pixels have different ones', () => {
    const film = new Film(SIZE, SIZE);
    const rest = new Film(SIZE, SIZE);
    const whole = new Film(SIZE, SIZE);
    for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
      for (let number = 0; number < 12; number++) {
        if (number >= 8) rest.add(sample(pixel, number), pixel);
        // Every third pixel ended early.
        else if (pixel % 3 > 0 || number < 4) film.add(sample(pixel, number), pixel);
        else continue;
        whole.add(sample(pixel, number), pixel);
      }
    }
    const read = (of: Film, { from, to }: Range) =>
      partOf(decodeExr(filmToExr(of, { ...record, samples: [{ from, to }] }, AOVS), 'x'), 'x');
    const { image } = mergeParts([read(film, { from: 0, to: 8 }), read(rest, { from: 8, to: 12 })]);
    const expected = read(whole, { from: 0, to: 12 }).image;
    expect(image.channels.map(({ name }) => name).sort()).toEqual(
      expected.channels.map(({ name }) => name).sort(),
    );
    for (const { name, pixels } of image.channels) {
      const right = expected.channels.find((channel) => channel.name === name)?.pixels ?? [];
      pixels.forEach((value, i) => {
        expect(Math.abs(value - right[i]!), `${name} ${i}`).toBeLessThan(1e-6 * (1 + Math.abs(value)));
      });
    }
    expect(image.channels.find(({ name }) => name === 'samples')?.pixels.slice(0, 3)).toEqual(
      Float32Array.of(8, 12, 12),
    );
  });

  test('takes the layer with the noise of a denoised picture', () => {
    const film = new Film(SIZE, SIZE);
    for (let pixel = 0; pixel < SIZE * SIZE; pixel++) film.add(sample(pixel, 0), pixel);
    const own = { ...record, samples: [{ from: 0, to: 1 }], denoised: true };
    const file = filmToExr(film, own, [], {
      radiance: new Float32Array(3 * SIZE * SIZE),
      alpha: film.meanAlpha(),
    });
    const { image, record: merged } = mergeParts([
      partOf(decodeExr(file, 'a'), 'a'),
      part('b', { from: 1, to: 2 }, {}, SIZE, []),
    ]);
    expect(merged.denoised).toBe(false);
    expect(image.channels.map(({ name }) => name).sort()).toEqual(['B', 'G', 'R']);
    const red = image.channels.find(({ name }) => name === 'R')?.pixels ?? [];
    expect(red[7]).toBeCloseTo((sample(7, 0)[0]! + sample(7, 1)[0]!) / 2, 5);
  });

  const a = part('a.exr', { from: 0, to: 4 });
  const next = { from: 4, to: 8 };
  test.each([
    [part('b.exr', { from: 3, to: 5 }), 'a.exr and b.exr both have the samples 3:4'],
    [part('b.exr', next, { seed: 8 }), 'b.exr is of another rendering than a.exr: seed: 8, not 7'],
    [part('b.exr', next, { maxDepth: 5 }), 'maximal depth: 5, not 4'],
    [part('b.exr', next, { version: '1.2.4' }), 'version of Irradia: 1.2.4, not 1.2.3'],
    [part('b.exr', next, { document: 'cd'.repeat(32) }), 'document: SHA-256 cdcdcdcdcdcd…, not SHA-256 abab'],
    [part('b.exr', next, { clamp: 0 }), 'clamp: 0, not 0.5'],
    [part('b.exr', next, { camera: '{"fov":3}' }), 'b.exr is of another rendering than a.exr: camera'],
    [part('b.exr', next, {}, 6), 'size: 6x5, not 5x5'],
    [part('b.exr', next, {}, SIZE, ['albedo']), 'channels: it has no depth.A'],
  ])('refuses a part that is none, %#', (b, message) => {
    expect(() => mergeParts([a, b])).toThrow(message);
  });

  test('refuses a file that is not by render', () => {
    const image = { width: 1, height: 1, channels: [] };
    expect(() => partOf(image, 'x.exr')).toThrow('x.exr: the header has no irradia:');
    expect(() => part('r.exr', next, { renderer: 'realtime' })).toThrow('only path traced pictures');
  });
});
