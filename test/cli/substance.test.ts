import { beforeAll, expect, test } from 'vitest';
import { built, called, irradia } from '../support/cli.ts';

beforeAll(() => built('cli'));

test('substance list names them with their colours', async () => {
  const { code, stdout } = await irradia(['substance', 'list']);
  expect(code).toBe(0);
  expect(stdout).toMatch(/^gold +1\.0\d+ +0\.7\d+ +0\.3\d+ {2}Gold, Au$/m);
  const list = JSON.parse((await called(['substance', 'list', '--json'])).stdout) as { source: string }[];
  expect(list.length).toBeGreaterThan(40);
  expect(list.every(({ source }) => /\d{4}/.test(source))).toBe(true);
});

test('substance show tells n and k, the reflection and the parameters', async () => {
  const { code, stdout } = await irradia(['substance', 'show', 'bk7', '--json']);
  expect(code).toBe(0);
  const shown = JSON.parse(stdout);
  expect(shown.lines[1]).toMatchObject({ line: 'D', n: expect.closeTo(1.5167, 4), k: 0 });
  expect(shown.angles[0]).toMatchObject({ angle: 0, exact: shown.f0, schlick: shown.f0 });
  expect(shown.schlick.error).toBeLessThan(0.05);
  const of = (model: string) => shown.parameters.find((found: { model: string }) => found.model === model);
  expect(of('principled').values.specular).toBeCloseTo(0.527, 3);
  expect(of('cook-torrance').values).toEqual({ ior: expect.closeTo(1.5167, 4), metallic: 0 });

  const page = await called(['substance', 'show', 'gold', '--light', 'A']);
  expect(page.stdout).toMatch(/^gold\n\nGold, Au \(conductor\)\nP\. B\. Johnson/);
  expect(page.stdout).toMatch(/F0 under A/);
  expect(page.stdout).toMatch(/principled: metallic 1, baseColor 1 0\.7/);
});

test.each<[string[], number, RegExp]>([
  [['substance'], 2, /substance what\?/],
  [['substance', 'melt'], 2, /there is no command 'substance melt'/],
  [['substance', 'show', 'kryptonite'], 1, /there is no substance 'kryptonite'; there are: aluminium, /],
  [['substance', 'show', 'gold', '--light', 'B'], 2, /--light B: expected D65, E, A/],
])('%j is refused', async (words, expected, message) => {
  const { code, stderr } = await called(words);
  expect([code, stderr]).toEqual([expected, expect.stringMatching(message)]);
});
