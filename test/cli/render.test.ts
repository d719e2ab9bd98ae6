import { spawn } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, test, vi } from 'vitest';
import { displayPixels } from '../../src/color/tone-mapping.ts';
import { decodeExr } from '../../src/io/exr.ts';
import { built, type CliResult, called, irradia, irradiaPath } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));
// Each picture is a process of its own, and other tests run beside.
vi.setConfig({ testTimeout: 180_000 });

const folder = temporaryFolder();
const path = (name: string) => join(folder, name);

/** A sphere on a ground under a lamp and a sky, with colours between that bounce. */
const scene = path('scene.json');
writeFileSync(
  scene,
  JSON.stringify({
    format: 'irradia',
    version: 1,
    name: 'Küche',
    camera: { fov: 40, position: [0, 1.5, 4], target: [0, 0.5, 0] },
    environment: { source: { type: 'constant', color: [0.2, 0.3, 0.5] } },
    lights: { lamp: { type: 'point', intensity: 20, position: [2, 3, 1] } },
    objects: {
      ground: { material: 'red', rotation: [-90, 0, 0], geometry: { type: 'plane', width: 6, height: 6 } },
      ball: { material: 'white', position: [0, 0.5, 0], geometry: { type: 'sphere', radius: 0.5 } },
    },
    materials: {
      red: { model: 'lambert', parameters: { albedo: [0.8, 0.2, 0.1] } },
      white: { model: 'lambert' },
    },
    view: { exposure: -0.5, toneMapping: 'agx' },
  }),
);

const call = (output: string, options: string) => [
  'render',
  scene,
  '-o',
  path(output),
  '--size',
  '32x24',
  '--device',
  'software',
  ...options.split(' '),
];

async function render(output: string, options: string) {
  return rendered(output, await called(call(output, options)));
}

/** By a process of its own. */
async function renderApart(output: string, options: string) {
  return rendered(output, await irradia(call(output, options)));
}

function rendered(output: string, { code, stdout, stderr }: CliResult) {
  expect({ code, stdout, stderr }).toEqual({ code: 0, stdout: '', stderr: expect.any(String) });
  return { file: readFileSync(path(output)), stderr };
}

function exr(name: string) {
  const { width, height, channels, attributes = {} } = decodeExr(readFileSync(path(name)), name);
  const plane = (channel: string) => {
    const found = channels.find((one) => one.name === channel);
    if (!found) throw new Error(`no channel ${channel}`);
    return found.pixels;
  };
  return { width, height, names: channels.map((channel) => channel.name), attributes, plane };
}

/** The largest difference of two pictures in any channel. */
function difference(a: string, b: string): number {
  const [one, other] = [exr(a), exr(b)];
  expect(other.names).toEqual(one.names);
  return Math.max(
    ...one.names.flatMap((name) =>
      [...one.plane(name)].map((value, i) => Math.abs(value - other.plane(name)[i]!)),
    ),
  );
}

const shownAs = (name: string) => {
  const { plane } = exr(name);
  const radiance = new Float32Array(3 * 32 * 24).map((_, i) => plane('RGB'[i % 3]!)[Math.floor(i / 3)]!);
  return [...displayPixels(radiance, { exposure: -0.5, toneMapping: 'agx' })];
};

async function pixelsOf(name: string): Promise<number[]> {
  const { default: sharp } = await import('sharp');
  return [...(await sharp(path(name)).raw().toBuffer())];
}

describe('render by the path tracer', () => {
  test('an EXR has linear radiance, layers, and in its header what was rendered', async () => {
    const { stderr } = await renderApart(
      'a.exr',
      '--spp 4 --seed 3 --max-depth 5 --aov depth,albedo,normal,variance',
    );
    // A machine that is busy has told before how far it is.
    expect(stderr).toMatch(/(^|\n)4 samples, [\d.]+ Mpaths\/s, [\d.:]+( s)?, error [\d.]+\n$/);
    const { width, height, names, attributes, plane } = exr('a.exr');
    expect([width, height]).toEqual([32, 24]);
    const layers = [
      'albedo.B',
      'albedo.G',
      'albedo.R',
      'depth.A',
      'depth.Z',
      'normal.X',
      'normal.Y',
      'normal.Z',
    ];
    expect(names.sort()).toEqual(['B', 'G', 'R', ...layers, 'variance.B', 'variance.G', 'variance.R']);
    expect(attributes).toMatchObject({
      'irradia:samples': '0:4',
      'irradia:seed': 3,
      'irradia:maxDepth': 5,
      'irradia:name': 'Küche',
      'irradia:renderer': 'pathtracer',
    });
    expect(attributes['irradia:document']).toMatch(/^[0-9a-f]{64}$/);
    expect(attributes.software).toBe(`Irradia ${attributes['irradia:version']}`);
    // The middle of the picture is the ball's front: white, 3.5 m away, turned to the camera.
    const middle = 12 * 32 + 16;
    expect(plane('depth.Z')[middle]).toBeGreaterThan(3.4);
    expect(plane('depth.Z')[middle]).toBeLessThan(3.9);
    expect(plane('depth.A')[middle]).toBe(1);
    expect(plane('normal.Z')[middle]).toBeGreaterThan(0.9);
    expect(plane('albedo.R')[middle]).toBeCloseTo(plane('albedo.G')[middle] as number, 5);
    expect(plane('R')[middle]).toBeGreaterThan(0);
    expect(plane('variance.R')[middle]).toBeGreaterThanOrEqual(0);
  });

  test('parts merge to the whole, of which a PNG is what the lab shows', async () => {
    await render('from0.exr', '--samples 0:4');
    await render('from4.exr', '--samples 4:8');
    await render('whole.exr', '--spp 8');
    await render('whole.png', '--spp 8');
    expect(await pixelsOf('whole.png')).toEqual(shownAs('whole.exr'));

    const merge = (parts: readonly string[], output: string, run = called) =>
      run(['merge', ...parts.map(path), '-o', path(output)]);
    const parts = ['from4.exr', 'from0.exr'];
    const done = { code: 0, stdout: '', stderr: '' };
    expect(await merge(parts, 'merged.exr')).toEqual(done);
    expect(exr('merged.exr').attributes['irradia:samples']).toBe('0:8');
    expect(difference('merged.exr', 'whole.exr')).toBeLessThan(1e-5);
    expect(await merge(parts, 'merged.png', irradia)).toEqual(done);
    expect(await pixelsOf('merged.png')).toEqual(shownAs('merged.exr'));

    const refused = await merge(['from0.exr', 'whole.exr'], 'no.exr');
    expect(refused).toMatchObject({ code: 1, stderr: expect.stringContaining('both have the samples 0:4') });
    expect(existsSync(path('no.exr'))).toBe(false);
  });

  test('the same seed gives the same bits, another one another picture; --error ends it', async () => {
    await renderApart('again.exr', '--spp 8');
    await render('other.exr', '--error 0.5 --seed 1');
    expect(readFileSync(path('again.exr')).equals(readFileSync(path('whole.exr')))).toBe(true);
    expect(difference('other.exr', 'whole.exr')).toBeGreaterThan(0.01);
    const { attributes } = exr('other.exr');
    expect(attributes['irradia:until']).toBe('error 0.5, 16384 samples');
    expect(Number(String(attributes['irradia:samples']).slice(2))).toBeGreaterThanOrEqual(16);
  });

  test('frames turn the camera; those that are there are not rendered again, half ones and others are', async () => {
    const frames = async (options: string) => {
      const { code, stderr } = await called(call('turn.png', options));
      expect(code).toBe(0);
      return stderr;
    };
    const written = (name: string) => statSync(path(name)).mtimeMs;
    await frames('--frames 0:2 --spp 2 --fps 1 --turntable 90');
    const before = written('turn.0000.png');
    expect(readFileSync(path('turn.0000.png')).equals(readFileSync(path('turn.0001.png')))).toBe(false);
    truncateSync(path('turn.0001.png'), 300);
    const resumed = await frames('--frames 0:3 --spp 2 --fps 1 --turntable 90');
    expect(resumed).toContain('1 of 3 frames are there');
    expect(resumed).toMatch(/turn\.0001\.png is rendered anew: .*the file ends/);
    expect(resumed).toMatch(/turn\.0002\.png: 2 samples/);
    expect(written('turn.0000.png')).toBe(before);
    const others = await frames('--frames 0:1 --spp 3 --fps 1 --turntable 90');
    expect(others).toContain(
      'turn.0000.png is rendered anew: it was rendered for samples 0:2, not samples 0:3',
    );
    expect(readdirSync(folder).filter((name) => name.endsWith('.part'))).toEqual([]);
  });
});

describe('an interruption', () => {
  /** Interrupts a rendering that would take hours as soon as it says how far it is. */
  function interrupted(output: string, options: string): Promise<{ code: number | null; stderr: string }> {
    const child = spawn(process.execPath, [irradiaPath, ...call(output, options)]);
    let stderr = '';
    return new Promise((resolve) => {
      child.stderr.on('data', (data) => {
        if (stderr === '') child.kill('SIGINT');
        stderr += data;
      });
      child.on('close', (code) => resolve({ code, stderr }));
    });
  }

  test('writes what there is', async () => {
    const { code, stderr } = await interrupted('long.exr', '--spp 100000000');
    expect(code).toBe(130);
    expect(stderr).toMatch(/interrupted: .*long\.exr has what was finished, \d+ samples? of each pixel\n$/);
    const [, to] = /^0:(\d+)$/.exec(String(exr('long.exr').attributes['irradia:samples'])) ?? [];
    expect(Number(to)).toBeGreaterThan(0);
  });

  test('leaves no half frame of an animation', async () => {
    const { code, stderr } = await interrupted('walk.png', '--frames 0:3 --spp 100000000');
    expect(code).toBe(130);
    expect(stderr).toMatch(/interrupted: .*walk\.0000\.png was not finished and not written\n$/);
    expect(existsSync(path('walk.0000.png'))).toBe(false);
  });
});
