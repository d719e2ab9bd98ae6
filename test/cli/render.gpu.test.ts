import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import sharp from 'sharp';
import { beforeAll, describe, expect, test } from 'vitest';
import { decodeExr } from '../../src/io/exr.ts';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));

const folder = temporaryFolder();
const write = (name: string, value: unknown): string => {
  const path = join(folder, name);
  writeFileSync(path, typeof value === 'string' ? value : JSON.stringify(value));
  return path;
};

/** The interactive renderer in software, so that every machine draws the same. */
async function render(subject: string, output: string, size: string, run = called): Promise<string> {
  const path = join(folder, output);
  const options = ['--renderer', 'realtime', '--size', size, '--device', 'software'];
  const result = await run(['render', subject, '-o', path, ...options]);
  expect(result).toEqual({ code: 0, stdout: '', stderr: '' });
  return path;
}

async function readPng(path: string) {
  const { data, info } = await sharp(path).raw().toBuffer({ resolveWithObject: true });
  return { width: info.width, height: info.height, pixels: [...data] };
}

function readExr(path: string) {
  const { width, height, channels, attributes } = decodeExr(readFileSync(path), path);
  const at = (x: number, y: number) =>
    ['R', 'G', 'B'].map((name) => channels.find((channel) => channel.name === name)?.pixels[y * width + x]);
  return { width, height, attributes, at };
}

/** A white plane that fills the view, lit from the camera by `illuminance` lx. */
const plane = (illuminance: number, exposure: number) => ({
  format: 'irradia',
  version: 1,
  camera: { fov: 40, position: [0, 0, 2], target: [0, 0, 0] },
  lights: { sun: { type: 'directional', illuminance, position: [0, 0, 5], target: [0, 0, 0] } },
  objects: { wall: { material: 'white', geometry: { type: 'plane', width: 50, height: 50 } } },
  materials: { white: { model: 'half' } },
  models: {
    half: {
      source: `analytic
::begin parameters
color albedo .5 .25 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return albedo / 3.141592653589793; }
::end shader`,
    },
  },
  view: { exposure, toneMapping: 'none' },
});

describe('render --renderer realtime', () => {
  test('draws a scene that ships, of the size that was asked for', async () => {
    const { width, height, pixels } = await readPng(await render('thesis', 'thesis.png', '96x54', irradia));
    expect([width, height]).toEqual([96, 54]);
    expect(new Set(pixels).size).toBeGreaterThan(60);
  });

  test('an EXR holds the radiance of the shading equation, whatever the exposure', async () => {
    const bright = readExr(await render(write('bright.json', plane(20, 4)), 'bright.exr', '31x20'));
    const dark = readExr(await render(write('dark.json', plane(20, -4)), 'dark.exr', '31x20'));
    expect([bright.width, bright.height]).toEqual([31, 20]);
    expect(bright.attributes?.software).toMatch(/^Irradia \d/);
    for (const [x, y] of [
      [0, 0],
      [15, 10],
      [30, 19],
    ] as const) {
      expect(bright.at(x, y)).toEqual(dark.at(x, y));
      const expected = [0.5, 0.25, 1].map((albedo) => (albedo / Math.PI) * 20);
      bright.at(x, y).forEach((value, i) => {
        expect(value).toBeCloseTo(expected[i] as number, 4);
      });
    }
  });

  test('a PNG shows the exposed picture in sRGB', async () => {
    const { pixels } = await readPng(
      await render(write('png.json', plane(Math.PI / 2, 1)), 'plane.png', '16x9'),
    );
    // The radiance is 1/2 of the albedo, the exposure doubles it: sRGB of .5, .25 and 1.
    expect(pixels.slice(0, 4)).toEqual([188, 137, 255, 255]);
  });

  test('shows a model, and a .brdf file, on a sphere', async () => {
    const { pixels } = await readPng(await render('cook-torrance', 'model.png', '40x40'));
    expect(new Set(pixels).size).toBeGreaterThan(40);
    const file = write('two words.brdf', plane(1, 0).models.half.source);
    const shown = await readPng(await render(file, 'file.png', '40x40'));
    const centre = (20 * 40 + 20) * 4;
    const [red = 0, green = 0, blue = 0] = shown.pixels.slice(centre);
    expect(blue).toBeGreaterThan(red);
    expect(red).toBeGreaterThan(green);
  });

  test('writes nothing when a part of the scene is missing, and says which', async () => {
    const broken = {
      ...plane(1, 0),
      assets: { map: { name: 'bark.png', mediaType: 'image/png', data: 'bm8gUE5H' } },
      materials: { white: { model: 'half', textures: { albedo: { asset: 'map' } } } },
    };
    const output = join(folder, 'missing.png');
    const { code, stderr } = await called([
      'render',
      write('missing.json', broken),
      '-o',
      output,
      '--size',
      '8x8',
      '--renderer',
      'realtime',
    ]);
    expect(code).toBe(1);
    expect(stderr).toMatch(/^irradia: .*bark\.png/);
    expect(existsSync(output)).toBe(false);
  });

  test('refuses a document that is wrong, and says where', async () => {
    const file = write('wrong.json', {
      ...plane(1, 0),
      objects: { wall: { material: 'black', geometry: 7 } },
    });
    const { code, stderr } = await called(['render', file, '-o', join(folder, 'wrong.png')]);
    expect(code).toBe(1);
    expect(stderr).toMatch(/^irradia: .*wrong\.json.*objects\.wall\.geometry/s);
    expect(stderr).not.toContain('    at ');
  });

  test('refuses a picture that no GPU can hold', async () => {
    const output = join(folder, 'huge.png');
    const words = ['render', 'lambert', '-o', output, '--size', '99999x1', '--renderer', 'realtime'];
    const { code, stderr } = await called(words);
    expect(code).toBe(1);
    expect(stderr).toMatch(/^irradia: --size 99999x1: at most \d+ pixels a side for png\n$/);
  });
});
