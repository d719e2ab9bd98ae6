import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { built, called, irradia } from '../support/cli.ts';
import { temporaryFolder } from '../support/folder.ts';

beforeAll(() => built('cli'));

const folder = temporaryFolder();
const file = join(folder, 'half.brdf');
writeFileSync(
  file,
  `analytic
# Half a diffuse reflection.
#
# References
#   J. H. Lambert, 1760,
#   "Photometria".
::begin parameters
color tint 1 .5 .25    # colour
float gain 0 2 1       # factor
bool on 1              # switch
::end parameters
::begin shader
vec3 whole(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return tint; }
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
  return on ? gain * 0.5 * whole(L, V, N, X, Y) : vec3(0.0);
}
::end shader
`,
);

const lines = (text: string) =>
  text
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));

describe('brdf list', () => {
  test('names every model that ships, for people and for machines', async () => {
    const { code, stdout } = await irradia(['brdf', 'list']);
    expect(code).toBe(0);
    expect(
      stdout
        .trimEnd()
        .split('\n')
        .map((line) => line.split(' ')[0]),
    ).toEqual([...shippedModels.keys()]);
    const json = JSON.parse((await called(['brdf', 'list', '--json'])).stdout);
    expect(json).toEqual([...shippedModels.values()].map(({ name, file }) => ({ name, title: file.title })));
  });
});

describe('brdf show', () => {
  test('tells parameters with ranges, terms and references', async () => {
    const { code, stdout } = await irradia(['brdf', 'show', file]);
    expect(code).toBe(0);
    expect(stdout).toContain('float gain = 1 (0 to 2)');
    expect(stdout).toContain('color tint = [1, 0.5, 0.25]');
    expect(stdout).toContain('bool  on = true');
    expect(stdout).toContain('Terms: BRDF, whole');
  });

  test('tells machines the same', async () => {
    const { stdout } = await called(['brdf', 'show', file, '--json']);
    expect(JSON.parse(stdout)).toMatchObject({
      name: 'half',
      title: 'Half a diffuse reflection',
      references: 'J. H. Lambert, 1760,\n"Photometria".',
      parameters: [
        { type: 'color', name: 'tint', default: [1, 0.5, 0.25], description: 'colour' },
        { type: 'float', name: 'gain', min: 0, max: 2, default: 1 },
        { type: 'bool', name: 'on', default: true },
      ],
      terms: ['BRDF', 'whole'],
      sampling: false,
    });
  });

  test('every model that ships has references', async () => {
    for (const name of shippedModels.keys()) {
      const { stdout } = await called(['brdf', 'show', name, '--json']);
      expect(JSON.parse(stdout).references, name).not.toBe('');
    }
  });

  test('says what is wrong with a file, and where', async () => {
    const broken = `${file}.broken.brdf`;
    writeFileSync(
      broken,
      'analytic\n::begin parameters\nfloat x\n::end parameters\n::begin shader\n::end shader\n',
    );
    const { code, stdout, stderr } = await called(['brdf', 'show', broken]);
    expect([code, stdout]).toEqual([1, '']);
    expect(stderr).toMatch(/^irradia: .*half\.brdf\.broken\.brdf:3: .*\n$/);
  });

  test('says that a folder is no model', async () => {
    const { code, stderr } = await called(['brdf', 'show', folder]);
    expect([code, stderr]).toEqual([1, `irradia: ${folder}: is a folder; expected a file\n`]);
  });

  test('names the models when there is none of that name', async () => {
    const { code, stderr } = await called(['brdf', 'show', 'nosuch']);
    expect(code).toBe(1);
    expect(stderr).toMatch(/^irradia: there is no model 'nosuch' .*lambert/);
  });
});

describe('brdf eval', () => {
  const up = { l: [0, 0, 1], v: [0, 0, 1] };

  test.each(['cpu', 'gpu'])('answers each line in its place, on the %s', async (backend) => {
    const input = [
      up,
      { ...up, parameters: { gain: 2, tint: [1, 2, 4] } },
      { ...up, parameters: { on: false } },
      { ...up, v: [0, 0.71, 0.71] },
    ];
    const text = input.map((query) => `${JSON.stringify(query)}\n`).join('');
    const { code, stdout, stderr } = await irradia(['brdf', 'eval', file, '--backend', backend], text);
    expect(stderr).toBe('');
    expect(lines(stdout)).toEqual([
      { f: [0.5, 0.25, 0.125] },
      { f: [1, 2, 4] },
      { f: [0, 0, 0] },
      { f: [0.5, 0.25, 0.125] },
    ]);
    expect(code).toBe(0);
  });

  test('a bad line gets an error in its place, the others their answers, and the exit code is 1', async () => {
    const bad = [
      'nonsense',
      '[]',
      '',
      JSON.stringify({ l: [0, 0, 1] }),
      JSON.stringify({ ...up, l: [0, 0, 0] }),
      JSON.stringify({ ...up, v: [0, 3, 4] }),
      JSON.stringify({ ...up, l: [0, 0, '1'] }),
      JSON.stringify({ ...up, parameters: { rouhgness: 1 } }),
      JSON.stringify({ ...up, parameters: { tint: 1 } }),
      JSON.stringify({ ...up, light: up.l }),
    ];
    const good = JSON.stringify(up);
    const { code, stdout } = await called(['brdf', 'eval', file], [good, ...bad, good].join('\n'));
    const answers = lines(stdout);
    expect(answers).toHaveLength(bad.length + 2);
    expect([answers[0], answers.at(-1)]).toEqual([{ f: [0.5, 0.25, 0.125] }, { f: [0.5, 0.25, 0.125] }]);
    for (const answer of answers.slice(1, -1)) expect(answer).toEqual({ error: expect.any(String) });
    expect(answers[2].error).toContain('expected an object');
    expect(answers[5].error).toBe('l: the length is 0; expected a unit vector');
    expect(answers[6].error).toBe('v: the length is 5; expected a unit vector');
    expect(answers[8].error).toContain('rouhgness');
    expect(answers[10].error).toContain('unknown field "light"');
    expect(code).toBe(1);
  });

  test('evaluates one term', async () => {
    const { stdout } = await called(['brdf', 'eval', file, '--term', 'whole'], JSON.stringify(up));
    expect(lines(stdout)).toEqual([{ f: [1, 0.5, 0.25] }]);
    const { code, stderr } = await called(['brdf', 'eval', file, '--term', 'hole']);
    expect([code, stderr]).toEqual([2, "irradia: half has no term 'hole'; it has BRDF, whole\n"]);
  });

  test('both back ends agree over more lines than fit one batch', async () => {
    const count = 10_000;
    const text = Array.from({ length: count }, (_, i) => {
      const angle = 1.5 * Math.sin(i);
      const l = [Math.sin(angle) * Math.cos(i), Math.sin(angle) * Math.sin(i), Math.cos(angle)];
      return `${JSON.stringify({ l, v: [0.6, 0, 0.8], parameters: { roughness: (i % 97) / 97, clearcoat: 0.5 } })}\n`;
    }).join('');
    const cpu = lines((await irradia(['brdf', 'eval', 'principled'], text)).stdout);
    const gpu = lines((await irradia(['brdf', 'eval', 'principled', '--backend', 'gpu'], text)).stdout);
    expect([cpu.length, gpu.length]).toEqual([count, count]);
    const worst = cpu.map(({ f }, i) => {
      const scale = Math.max(f[0], 1e-4);
      return Math.abs(gpu[i].f[0] - f[0]) / scale;
    });
    expect(worst.filter((error) => error > 1e-3)).toEqual([]);
  });

  test('a value that is not finite is an error of its line', async () => {
    const infinite = `${file}.infinite.brdf`;
    const body = 'vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(1.0 / (1.0 - L.z)); }';
    writeFileSync(
      infinite,
      `analytic\n::begin parameters\n::end parameters\n::begin shader\n${body}\n::end shader\n`,
    );
    const { code, stdout } = await called(['brdf', 'eval', infinite], JSON.stringify(up));
    expect(lines(stdout)).toEqual([{ error: expect.stringContaining('not finite') }]);
    expect(code).toBe(1);
  });
});
