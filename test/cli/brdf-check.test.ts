import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import { PROPERTIES } from '../../src/analysis/verdict/types.ts';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));

const folder = temporaryFolder();
const file = (name: string, header: string, body: string): string => {
  const path = join(folder, `${name}.brdf`);
  const shader = `vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return ${body}; }`;
  writeFileSync(
    path,
    `analytic\n# ${header}\n::begin parameters\n::end parameters\n::begin shader\n${shader}\n::end shader\n`,
  );
  return path;
};

describe('brdf check', () => {
  test('passes what is sound, in a table', async () => {
    const { code, stdout, stderr } = await irradia(['brdf', 'check', 'lambert']);
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(/^energy +pass +albedo up to 1$/m);
    expect(stdout).toMatch(/^GPU = float64 +n\/a$/m);
    expect(stdout).toMatch(/\nSound\.\n$/);
  });

  test('names what is broken and where, and exits with 1', async () => {
    const { code, stdout } = await called(['brdf', 'check', file('bright', 'Bright.', 'vec3(1.0)')]);
    expect(code).toBe(1);
    expect(stdout).toMatch(/^energy +FAIL +albedo up to 3\.14$/m);
    expect(stdout).toMatch(/Worst: the default parameters; v \[/);
    expect(stdout).toMatch(/\nBroken: energy\.\n$/);
  });

  test('accepts what the header gives up', async () => {
    const path = file('glow', 'gives up: energy', 'vec3(1.0)');
    const { code, stdout } = await called(['brdf', 'check', path]);
    expect(code).toBe(0);
    expect(stdout).toMatch(/\nSound; given up, as its header says: energy\.\n$/);
  });

  test('tells machines the same', async () => {
    const path = file('cosine', 'A cosine.', 'vec3(0.1 * L.z)');
    const { code, stdout } = await called(['brdf', 'check', path, '--json']);
    expect(code).toBe(1);
    const verdict = JSON.parse(stdout);
    expect(verdict).toMatchObject({ model: 'cosine', sound: false });
    expect(verdict.checks.map((check: { property: string }) => check.property)).toEqual([...PROPERTIES]);
    expect(verdict.checks[2]).toMatchObject({
      property: 'reciprocity',
      outcome: 'fail',
      figure: expect.any(Number),
      worst: { term: 'BRDF', parameters: {}, l: expect.any(Array), v: expect.any(Array) },
    });
  });

  test('compares the GPU on demand', async () => {
    const { code, stdout } = await irradia(['brdf', 'check', 'lambert', '--backend', 'gpu']);
    expect(code).toBe(0);
    expect(stdout).toMatch(/^GPU = float64 +pass +differs by /m);
  });

  test('draws a law over two parameters', async () => {
    const words = ['brdf', 'check', 'cook-torrance', '--map'];
    const csv = join(folder, 'map.csv');
    const { code, stdout } = await called([...words, 'roughness,ior', '-o', csv]);
    expect(code).toBe(0);
    expect(stdout).toMatch(/^energy of cook-torrance: worst 0\.\d+ at roughness \S+, ior \S+, v \[/);
    expect(readFileSync(csv, 'utf8').split('\n')).toHaveLength(1 + 24 * 24 + 1);
    const png = join(folder, 'map.png');
    expect((await called([...words, 'main', '-o', png])).code).toBe(0);
    expect(readFileSync(png).subarray(1, 4).toString()).toBe('PNG');
    for (const [more, message] of [
      [['roughness', '-o', csv], '--map roughness: expected two parameters with a comma between, or main'],
      [
        ['roughness,albedo', '-o', csv],
        "--map roughness,albedo: cook-torrance has no number 'albedo'; it has",
      ],
      [['main'], '--map: expected -o FILE, a .svg, .png, .csv'],
      [['main', '-o', csv, '--law', 'gravity'], '--law gravity: expected energy or reciprocity'],
    ] as const) {
      const { code: refused, stderr } = await called([...words, ...more]);
      expect([refused, stderr.slice(0, 9 + message.length)]).toEqual([2, `irradia: ${message}`]);
    }
  });

  test('says what is wrong with a call or a header', async () => {
    expect(await called(['brdf', 'check', 'lambert', '--backend', 'abacus'])).toEqual({
      code: 2,
      stdout: '',
      stderr: 'irradia: --backend abacus: expected cpu or gpu\n',
    });
    const path = file('typo', 'gives up: enregy', 'vec3(0.1)');
    const { code, stderr } = await called(['brdf', 'check', path]);
    expect(code).toBe(1);
    expect(stderr).toMatch(/typo\.brdf:2: a model cannot give up 'enregy'/);
  });
});
