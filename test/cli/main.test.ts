import { beforeAll, expect, test } from 'vitest';
import { built, called, irradia } from '../support/cli.ts';

beforeAll(() => built('cli'));

test('--help lists the commands', async () => {
  const { code, stdout } = await irradia(['--help']);
  expect(code).toBe(0);
  for (const name of ['serve', 'render', 'merge', 'brdf list', 'brdf show', 'brdf eval']) {
    expect(stdout).toContain(`  irradia ${name}`);
  }
});

test('what went wrong has its exit code', async () => {
  const folder = 'irradia: -o no/such/folder/a.png: there is no folder no/such/folder\n';
  const [option, place] = [
    await irradia(['serve', '--port', '-1']),
    await irradia(['render', 'lambert', '-o', 'no/such/folder/a.png']),
  ];
  expect(option).toEqual({ code: 2, stdout: '', stderr: 'irradia: --port -1: expected 0 to 65535\n' });
  expect(place).toEqual({ code: 1, stdout: '', stderr: folder });
});

test.each([
  [['serve', '--help'], 'irradia serve [SCENE]'],
  [['render', '-h'], 'irradia render SCENE|MODEL|FILE'],
  [['brdf', '--help'], 'irradia brdf list'],
  [['brdf', 'eval', '--help'], 'irradia brdf eval MODEL|FILE'],
])('%j explains itself', async (words, usage) => {
  const { code, stdout, stderr } = await called(words);
  expect([code, stderr]).toEqual([0, '']);
  expect(stdout).toContain(usage);
});

test('--version is the version of the package', async () => {
  const { code, stdout } = await irradia(['--version']);
  expect(code).toBe(0);
  expect(stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
});

test.each([
  [['brdf', 'list', '--jsn'], "brdf list: Unknown option '--jsn'"],
  [['brdf', 'eval', 'lambert', '--backend', 'tpu'], '--backend tpu: expected cpu or gpu'],
  [['brdf', 'show'], 'brdf show: expected `irradia brdf show MODEL|FILE [--json]`'],
  [['brdf', 'shwo'], "there is no command 'brdf shwo'"],
  [['brdf'], 'brdf what?'],
  [['render', 'lambert'], 'render: expected -o FILE.png or -o FILE.exr'],
  [['render', 'lambert', '-o', 'a.jpg'], '-o a.jpg: expected a .png or an .exr'],
  [['render', 'lambert', '-o', 'a.png', '--size', '10'], '--size 10: expected WIDTHxHEIGHT'],
  [['render', 'lambert', '-o', 'a.png', '--size', '-3x10'], '--size -3x10: expected WIDTHxHEIGHT'],
  [['render', 'lambert', '-o', 'a.exr', '--seed', '-1'], '--seed -1: expected 0 to 4294967295'],
  [['merge', 'a.exr'], 'merge: expected -o OUT.exr or -o OUT.png'],
  [
    ['render', 'lambert', '-o', 'a.png', '--size', '--device', 'gpu'],
    "Option '--size' argument is ambiguous;",
  ],
  [['serve', '--port', '-1'], '--port -1: expected 0 to 65535'],
  [['serve', '--port', 'http'], '--port http: expected 0 to 65535'],
])('%j is refused', async (words, problem) => {
  const { code, stdout, stderr } = await called(words);
  expect([code, stdout]).toEqual([2, '']);
  expect(stderr).toMatch(/^irradia: /);
  expect(stderr).toContain(problem);
});

test.each([
  [['redner'], "there is no scene 'redner'"],
  [['render', 'nosuch', '-o', 'a.png'], "there is no scene, model or file 'nosuch'"],
  [['render', 'lambert', '-o', 'no/such/folder/a.png'], 'there is no folder no/such/folder'],
  [['render', 'lambert', '-o', 'README.md/a.png'], 'there is no folder README.md'],
  [['render', 'models', '-o', 'a.png'], 'models: is a folder; expected a file'],
  [['merge', 'nosuch.exr', '-o', 'a.exr'], 'nosuch.exr: there is no such file'],
  [['merge', 'README.md', '-o', 'a.exr'], 'README.md: byte 4: not an OpenEXR file'],
  [['brdf', 'eval', 'models'], 'models: is a folder; expected a file'],
])('%j fails', async (words, problem) => {
  const { code, stdout, stderr } = await called(words);
  expect([code, stdout]).toEqual([1, '']);
  expect(stderr).toContain(`irradia: `);
  expect(stderr).toContain(problem);
});
