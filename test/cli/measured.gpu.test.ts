import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import sharp from 'sharp';
import { beforeAll, expect, test } from 'vitest';
import type { Reflectance } from '../../src/analysis/plots/curve.ts';
import type { Vector3 } from '../../src/glsl/evaluator.ts';
import { writeCsail } from '../io/csail-writer.ts';
import { writeMerl } from '../io/merl-writer.ts';
import { writeRgl } from '../io/rgl-writer.ts';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));

const folder = temporaryFolder();
/** Of Lambert's law. */
const ALBEDO = [0.2, 0.4, 0.8] as const;
const lambert: Reflectance = () => [ALBEDO[0] / Math.PI, ALBEDO[1] / Math.PI, ALBEDO[2] / Math.PI];
const bytes = writeMerl(lambert);
const file = join(folder, 'blue.binary');
writeFileSync(file, bytes);

test('brdf show tells what the file is and how it is read', async () => {
  const { code, stdout } = await irradia(['brdf', 'show', file]);
  expect(code).toBe(0);
  expect(stdout).toMatch(/^blue\n/);
  expect(stdout).toMatch(/Matusik/);
  expect(stdout).toMatch(/Sampling: generic/);
});

test.each(['cpu', 'gpu'])('brdf eval reads its samples, on the %s', async (backend) => {
  const queries: { l: Vector3; v: Vector3 }[] = [
    { l: [0, 0, 1], v: [0, 0, 1] },
    { l: [0.6, 0, 0.8], v: [0, -0.8, 0.6] },
  ];
  const input = queries.map((query) => JSON.stringify(query)).join('\n');
  const { code, stdout } = await called(['brdf', 'eval', file, '--backend', backend], input);
  expect(code).toBe(0);
  for (const line of stdout.trim().split('\n')) {
    const { f } = JSON.parse(line) as { f: number[] };
    ALBEDO.forEach((albedo, c) => {
      expect(f[c]).toBeCloseTo(albedo / Math.PI, 6);
    });
  }
});

test('render draws a sphere of it, as of the model that it samples', async () => {
  const draw = async (run: typeof irradia, subject: string, name: string): Promise<number[]> => {
    const path = join(folder, name);
    const how = ['--renderer', 'realtime', '--size', '48x48', '--device', 'software'];
    const result = await run(['render', subject, '-o', path, ...how]);
    expect(result).toEqual({ code: 0, stdout: '', stderr: '' });
    return [...(await sharp(path).raw().toBuffer())];
  };
  const formula = join(folder, 'formula.brdf');
  writeFileSync(
    formula,
    `analytic
::begin parameters
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  return dot(N, L) > 0.0 && dot(N, V) > 0.0 ? vec3(.2, .4, .8) / 3.14159265 : vec3(0.0);
}
::end shader
`,
  );
  const got = await draw(irradia, file, 'measured.png');
  const expected = await draw(called, formula, 'formula.png');
  expect(new Set(expected).size).toBeGreaterThan(60);
  // Of 255: the light from everywhere is sampled.
  expect(got).toHaveLength(expected.length);
  expect(Math.max(...got.map((value, i) => Math.abs(value - expected[i]!)))).toBeLessThanOrEqual(3);
});

test.each([
  ['blue.bsdf', () => writeRgl(lambert, { thetas: 6, resolution: 24 })],
  ['blue.dat', () => writeCsail(lambert, { bins: [4, 4, 8, 8] })],
] as const)('the same commands take %s', async (name, write) => {
  const path = join(folder, name);
  writeFileSync(path, write());
  expect((await called(['brdf', 'show', path])).stdout).toMatch(/^blue\n/);
  const query = JSON.stringify({ l: [0.6, 0, 0.8], v: [0, 0, 1] });
  const { stdout } = await called(['brdf', 'eval', path], query);
  const { f } = JSON.parse(stdout) as { f: number[] };
  ALBEDO.forEach((albedo, c) => {
    expect(f[c]).toBeCloseTo(albedo / Math.PI, 2);
  });
  const picture = join(folder, `${name}.png`);
  const render = ['render', path, '-o', picture, '--size', '32x32', '--spp', '16', '--device', 'software'];
  expect((await irradia(render)).code).toBe(0);
  const { channels } = await sharp(picture).stats();
  const [red, , blue] = channels.map(({ max }) => max) as [number, number, number];
  expect(blue).toBeGreaterThan(red + 40);
});

test('a broken file is refused with a message and not with a stack', async () => {
  const cut = join(folder, 'cut.binary');
  writeFileSync(cut, bytes.subarray(0, 100_000));
  for (const words of [
    ['brdf', 'show', cut],
    ['render', cut, '-o', join(folder, 'no.png')],
  ]) {
    const { code, stderr } = await called(words);
    expect(code).toBe(1);
    expect(stderr).toMatch(
      /^irradia: .*cut\.binary: byte 100000: the file ends here; expected \d+ more bytes.*\n$/,
    );
  }
  const { code, stderr } = await called(['render', join(folder, 'nowhere.binary'), '-o', 'x.png']);
  expect([code, stderr]).toEqual([1, expect.stringMatching(/no scene, model or file/)]);
});
