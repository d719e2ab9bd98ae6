import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import sharp from 'sharp';
import { beforeAll, expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createEvaluator, type Vector3 } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { writeCsail } from '../io/csail-writer.ts';
import { writeMerl } from '../io/merl-writer.ts';
import { writeRgl } from '../io/rgl-writer.ts';
import { built, irradia } from '../support/cli.ts';

beforeAll(() => built('cli'));

const folder = mkdtempSync(join(tmpdir(), 'irradia-test-'));
const lambert = createEvaluator(shippedModels.get('lambert') as Model, { albedo: [0.2, 0.4, 0.8] });
const bytes = writeMerl((L, V) => lambert.f(L, V));
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
  const { code, stdout } = await irradia(['brdf', 'eval', file, '--backend', backend], input);
  expect(code).toBe(0);
  for (const line of stdout.trim().split('\n')) {
    const { f } = JSON.parse(line) as { f: number[] };
    [0.2, 0.4, 0.8].forEach((albedo, c) => {
      expect(f[c]).toBeCloseTo(albedo / Math.PI, 6);
    });
  }
});

test('render draws a sphere of it, as of the model that it samples', async () => {
  const draw = async (subject: string, name: string): Promise<number[]> => {
    const path = join(folder, name);
    const how = ['--renderer', 'realtime', '--size', '48x48', '--device', 'software'];
    const result = await irradia(['render', subject, '-o', path, ...how]);
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
  const [got, expected] = [await draw(file, 'measured.png'), await draw(formula, 'formula.png')];
  expect(new Set(expected).size).toBeGreaterThan(60);
  // Of 255: the light from everywhere is sampled.
  got.forEach((value, i) => {
    expect(Math.abs(value - (expected[i] as number)), `byte ${i}`).toBeLessThanOrEqual(3);
  });
});

test.each([
  ['blue.bsdf', () => writeRgl((L, V) => lambert.f(L, V), { thetas: 6, resolution: 24 })],
  ['blue.dat', () => writeCsail((L, V) => lambert.f(L, V), { bins: [4, 4, 8, 8] })],
] as const)('the same commands take %s', async (name, write) => {
  const path = join(folder, name);
  writeFileSync(path, write());
  expect((await irradia(['brdf', 'show', path])).stdout).toMatch(/^blue\n/);
  const query = JSON.stringify({ l: [0.6, 0, 0.8], v: [0, 0, 1] });
  const { stdout } = await irradia(['brdf', 'eval', path], query);
  const { f } = JSON.parse(stdout) as { f: number[] };
  [0.2, 0.4, 0.8].forEach((albedo, c) => {
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
    const { code, stderr } = await irradia(words);
    expect(code).toBe(1);
    expect(stderr).toMatch(
      /^irradia: .*cut\.binary: byte 100000: the file ends here; expected \d+ more bytes.*\n$/,
    );
  }
  const { code, stderr } = await irradia(['render', join(folder, 'nowhere.binary'), '-o', 'x.png']);
  expect([code, stderr]).toEqual([1, expect.stringMatching(/no scene, model or file/)]);
});
