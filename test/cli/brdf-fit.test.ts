import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));

const folder = temporaryFolder();
const gloss = join(folder, 'gloss.brdf');
writeFileSync(
  gloss,
  `analytic
# A gloss.
::begin parameters
color tint 1 1 1
float power 1 100 10
bool on 1
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  return on ? tint * pow(max(dot(N, normalize(L + V)), 0.0), power) : vec3(0.0);
}
::end shader
`,
);
const saved = join(folder, 'red.bparam');
writeFileSync(
  saved,
  'bparam brdfs/gloss.brdf\n::begin parameters\nfloat power 1 100 40\ncolor tint .5 .25 .125\n::end parameters\n',
);

describe('brdf fit', () => {
  test('finds parameters, and gives them as a table and as code', async () => {
    const { code, stdout, stderr } = await irradia(['brdf', 'fit', saved, '--model', gloss]);
    expect([code, stderr]).toEqual([0, '']);
    expect(stdout).toMatch(/^gloss as gloss\n/);
    expect(stdout).toMatch(/^power +40 +± /m);
    expect(stdout).toMatch(/^tint\.g +0\.25 +± /m);
    expect(stdout).toMatch(/^on +true +tried both$/m);
    expect(stdout).toMatch(/^by cube root \* /m);
    expect(stdout).toContain(
      'new BrdfMaterial(loadModel(source, "gloss.brdf"), {\n  tint: [0.5, 0.25, 0.125],\n  power: 40,\n})',
    );
  });

  test('tells machines the same, keeps what is fixed, and writes a material', async () => {
    const output = join(folder, 'material.json');
    const words = ['brdf', 'fit', 'lambert', '--parameters', '{"albedo": [0.5, 0.4, 0.2]}', '--model', gloss];
    const { code, stdout } = await called([
      ...words,
      '--fix',
      'power=3',
      '--fix',
      'on=true',
      '--json',
      '-o',
      output,
    ]);
    expect(code).toBe(0);
    const fit = JSON.parse(stdout);
    expect(fit).toMatchObject({ model: 'gloss', parameters: { power: 3, on: true } });
    expect(fit.errors.cubeRoot).toBeLessThan(fit.defaults.cubeRoot);
    expect(fit.candidates).toHaveLength(4);
    expect(JSON.parse(readFileSync(output, 'utf8'))).toEqual({
      name: 'lambert',
      model: 'gloss',
      parameters: fit.parameters,
    });
  });

  test('names the class of a shipped model', async () => {
    const { stdout } = await called(['brdf', 'fit', gloss, '--model', 'lambert']);
    expect(stdout).toMatch(
      /import \{ LambertMaterial \} from 'irradia';\n\nconst material = new LambertMaterial\(\{/,
    );
  });

  test.each([
    [[gloss], 'irradia: brdf fit: --model names what is fitted\n'],
    [[gloss, '--model', gloss, '--fix', 'tint=1'], 'irradia: --fix tint=1: expected three numbers, r,g,b\n'],
    [
      [gloss, '--model', gloss, '--fix', 'gain=1'],
      "irradia: --fix gain=1: gloss has no parameter 'gain'; it has tint, power, on\n",
    ],
    [[gloss, '--model', gloss, '--seed', 'x'], 'irradia: --seed x: expected a whole number\n'],
    [
      [gloss, '--model', gloss, '--parameters', '[]'],
      'irradia: --parameters: expected an object such as {"roughness": 0.3}\n',
    ],
  ])('says what is wrong with a call: %j', async (words, stderr) => {
    expect(await called(['brdf', 'fit', ...words])).toEqual({ code: 2, stdout: '', stderr });
  });
});

describe('a .bparam file', () => {
  test('is the model that it names, with the saved values', async () => {
    const { stdout } = await called(['brdf', 'show', saved]);
    expect(stdout).toMatch(/^gloss\n/);
    expect(stdout).toContain('float power = 40 (1 to 100)');
    const answer = await called(['brdf', 'eval', saved], '{"l": [0, 0, 1], "v": [0, 0, 1]}\n');
    expect(JSON.parse(answer.stdout)).toEqual({ f: [0.5, 0.25, 0.125] });
  });

  test('finds a shipped model, and says what it cannot use or find', async () => {
    const write = (name: string, source: string) => {
      const path = join(folder, name);
      writeFileSync(
        path,
        `bparam ${source}\n::begin parameters\nfloat foo 0 1 0\ncolor albedo 0 0 0\n::end parameters\n`,
      );
      return path;
    };
    const query = '{"l": [0, 0, 1], "v": [0, 0, 1]}\n';
    const shipped = await called(['brdf', 'eval', write('a.bparam', 'lambert.brdf')], query);
    expect(shipped.stderr).toMatch(/a\.bparam: lambert has no such parameters: foo\n$/);
    expect(JSON.parse(shipped.stdout)).toEqual({ f: [0, 0, 0] });
    const missing = await called(['brdf', 'show', write('b.bparam', 'other.brdf')]);
    expect(missing.code).toBe(1);
    expect(missing.stderr).toMatch(/b\.bparam has values for other\.brdf; there is no such file beside it/);
  });
});
