import { expect, test } from 'vitest';
import { UsageError } from '../../../src/cli/command.ts';
import { checkFilmSize, completed, parseRenderOptions } from '../../../src/cli/render/options.ts';

/** As parseCall() gives them, with the defaults that it knows. */
const parse = (options: Record<string, string>) =>
  parseRenderOptions({ output: 'a.exr', renderer: 'pathtracer', size: '32x24', device: 'auto', ...options });

test('what is left out has its default, or is left to the document', () => {
  expect(parse({})).toEqual({
    output: 'a.exr',
    format: 'exr',
    renderer: 'pathtracer',
    width: 32,
    height: 24,
    device: 'auto',
    until: null,
    first: 0,
    maxDepth: null,
    preset: null,
    seed: null,
    clamp: null,
    denoise: false,
    aovs: [],
    animation: null,
  });
});

test("the document's settings are taken where the call has none", () => {
  const settings = { samples: 12, error: 0.5, maxDepth: 3, clamp: 2.5, seed: 7 };
  expect(completed(parse({}), settings)).toMatchObject({
    until: { kind: 'samples', count: 12 },
    maxDepth: 3,
    clamp: 2.5,
    seed: 7,
  });
  const given = { spp: '5', 'max-depth': '4', clamp: '0', seed: '0' };
  expect(completed(parse(given), settings)).toMatchObject({
    until: { kind: 'samples', count: 5 },
    maxDepth: 4,
    clamp: 0,
    seed: 0,
  });
  expect(completed(parse({ time: '3' }), settings).until).toEqual({ kind: 'time', seconds: 3 });
});

test.each([
  [{ spp: '7' }, { until: { kind: 'samples', count: 7 }, first: 0 }],
  [{ samples: '8:24' }, { until: { kind: 'samples', count: 16 }, first: 8 }],
  [{ time: '1.5' }, { until: { kind: 'time', seconds: 1.5 } }],
  [{ error: '0.02' }, { until: { kind: 'error', error: 0.02, most: 16_384 } }],
  [{ error: '0.02', spp: '99' }, { until: { kind: 'error', error: 0.02, most: 99 } }],
  [{ aov: 'variance,albedo' }, { aovs: ['albedo', 'variance'] }],
  [
    { clamp: '2.5', seed: '9', 'max-depth': '3' },
    { clamp: 2.5, seed: 9, maxDepth: 3 },
  ],
  [{ output: 'A.PNG' }, { format: 'png' }],
  [{ frames: '10:20' }, { animation: { frames: { from: 10, to: 20 }, degreesPerFrame: 1.5, fps: 24 } }],
  [
    { frames: '0:2', fps: '30', turntable: '-90' },
    { animation: { frames: { from: 0, to: 2 }, degreesPerFrame: -3, fps: 30 } },
  ],
])('%j', (options, expected) => {
  expect(parse(options)).toMatchObject(expected);
});

test.each([
  [{ spp: '0' }, '--spp 0: expected 1 to 2147483648'],
  [{ spp: '2.5' }, '--spp 2.5: expected 1 to'],
  [{ spp: '4', time: '1' }, '--spp and --time: expected one of them'],
  [{ error: '.1', samples: '0:4' }, '--error and --samples: expected one of them'],
  [{ samples: '4:4' }, '--samples 4:4: expected A:B with A < B'],
  [{ samples: '4' }, '--samples 4: expected A:B'],
  [{ samples: '0:2147483649' }, '--samples 0:2147483649: expected A:B'],
  [{ time: '0' }, '--time 0: expected seconds'],
  [{ error: 'low' }, '--error low: expected a number above 0'],
  [{ error: '' }, '--error : expected a number above 0'],
  [{ seed: '4294967296' }, '--seed 4294967296: expected 0 to 4294967295'],
  [{ 'max-depth': '0' }, '--max-depth 0: expected 1 to'],
  [{ clamp: '-1' }, '--clamp -1: expected a radiance, 0 or more'],
  [{ aov: 'albedo,uv' }, '--aov albedo,uv: expected some of albedo,normal,depth,variance'],
  [{ aov: 'albedo', output: 'a.png' }, '--aov albedo: a .png has no layers'],
  [{ renderer: 'blender' }, '--renderer blender: expected pathtracer or realtime'],
  [{ renderer: 'realtime', spp: '4' }, '--spp: only with --renderer pathtracer'],
  [{ device: 'tpu' }, '--device tpu: expected auto, gpu, software'],
  [{ fps: '4' }, '--fps: only with --frames A:B'],
  [{ frames: '3' }, '--frames 3: expected A:B'],
  [{ frames: '0:2', fps: '0' }, '--fps 0: expected frames per second, more than 0'],
])('%j is refused', (options, message) => {
  expect(() => parse(options)).toThrow(UsageError);
  expect(() => parse(options)).toThrow(message);
});

test('a picture that memory does not hold is refused with the figures', () => {
  expect(() => checkFilmSize({ width: 99999, height: 99999 })).toThrow(
    /^--size 99999x99999: takes \d+\.\d GB of memory; at most \d+\.\d GB here$/,
  );
  checkFilmSize({ width: 1280, height: 720 });
});
