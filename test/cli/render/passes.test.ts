import { expect, test } from 'vitest';
import { type PassesOptions, renderPasses } from '../../../src/cli/render/passes.ts';
import { FILM_FLOATS, Film } from '../../../src/pathtracer/film.ts';
import type { PathTracer } from '../../../src/pathtracer/path-tracer.ts';

/** A path tracer whose samples have the radiance 0 and 2 in turn, and which fails at a sample. */
function fakeTracer(failAt = Number.POSITIVE_INFINITY) {
  const passes: [first: number, count: number][] = [];
  const film = new Film(1, 1);
  const tracer: PathTracer = {
    device: 'fake',
    load: async () => {},
    start() {},
    async render(first, count, { signal } = {}) {
      signal?.throwIfAborted();
      if (first + count > failAt) throw new Error('a worker died');
      passes.push([first, count]);
      for (let i = first; i < first + count; i++) {
        const value = i % 2 === 0 ? 0 : 2;
        const slots = new Float32Array(FILM_FLOATS);
        slots.set([value, value, value, 1, value ** 2, value ** 2, value ** 2]);
        film.add(slots);
      }
    },
    film: async () => film,
    dispose() {},
  };
  return { tracer, passes };
}

const options = (change: Partial<PassesOptions>): PassesOptions => ({
  first: 0,
  until: { kind: 'samples', count: 21 },
  pixels: 1,
  pathsPerPass: 8,
  signal: new AbortController().signal,
  ...change,
});

test('passes grow to the largest, and end with the last sample', async () => {
  const { tracer, passes } = fakeTracer();
  const { samples, part, stopped, film } = await renderPasses(tracer, options({ first: 100 }));
  expect(passes).toEqual([
    [100, 1],
    [101, 1],
    [102, 2],
    [104, 4],
    [108, 8],
    [116, 5],
  ]);
  expect([samples, part, stopped, film?.count[0]]).toEqual([21, 1, null, 21]);
});

test('a pass has one sample of each pixel at least', async () => {
  const { tracer, passes } = fakeTracer();
  await renderPasses(tracer, options({ pixels: 1000, until: { kind: 'samples', count: 3 } }));
  expect(passes).toEqual([
    [0, 1],
    [1, 1],
    [2, 1],
  ]);
});

test('ends when the error is small enough, and not on the word of a few samples', async () => {
  const { tracer } = fakeTracer();
  // The mean is 1 and so is a sample's standard deviation: that of n samples' mean is 1 / sqrt(n - 1).
  const small = await renderPasses(tracer, options({ until: { kind: 'error', error: 0.1, most: 1000 } }));
  expect(small.error).toBeLessThanOrEqual(0.1);
  expect(small.samples).toBeGreaterThan(100);
  expect(small.samples).toBeLessThan(140);
  const large = await renderPasses(
    fakeTracer().tracer,
    options({ until: { kind: 'error', error: 9, most: 1000 } }),
  );
  expect(large.samples).toBe(16);
  const capped = await renderPasses(
    fakeTracer().tracer,
    options({ until: { kind: 'error', error: 0.1, most: 50 } }),
  );
  expect(capped.samples).toBe(50);
});

test('a time that is over at once gives one sample', async () => {
  const { samples } = await renderPasses(
    fakeTracer().tracer,
    options({ until: { kind: 'time', seconds: 1e-9 } }),
  );
  expect(samples).toBe(1);
});

test('what was finished survives a worker, a lost device and an interruption', async () => {
  const died = await renderPasses(fakeTracer(9).tracer, options({}));
  expect([died.samples, died.film?.count[0]]).toEqual([8, 8]);
  expect(died.stopped).toEqual(new Error('a worker died'));

  const { tracer } = fakeTracer();
  let lose = (_: Error): void => {};
  const lost = new Promise<never>((_, reject) => {
    lose = reject;
  });
  const render: PathTracer['render'] = async (first, count) => {
    if (first < 8) return tracer.render(first, count);
    lose(new Error('the GPU device was lost'));
    return new Promise(() => {});
  };
  const gone = await renderPasses({ ...tracer, render }, options({ lost }));
  expect([gone.samples, gone.film?.count[0]]).toEqual([8, 8]);
  expect(gone.stopped).toEqual(new Error('the GPU device was lost'));

  const controller = new AbortController();
  const interrupted = await renderPasses(
    fakeTracer().tracer,
    options({ signal: controller.signal, onProgress: ({ samples }) => samples === 4 && controller.abort() }),
  );
  expect([interrupted.samples, interrupted.stopped]).toEqual([4, 'signal']);

  const early = await renderPasses(fakeTracer(0).tracer, options({}));
  expect([early.samples, early.film]).toEqual([0, null]);
});
