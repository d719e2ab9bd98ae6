import { mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { savePicture, saveWhole } from '../../../src/cli/render/save.ts';
import { temporaryFolder } from '../../support/folder.ts';

const folder = temporaryFolder();
const data = Uint8Array.of(1, 2, 3);

test('a file is replaced as a whole, and what a link points to instead of the link', () => {
  const path = join(folder, 'a.exr');
  writeFileSync(path, 'before');
  symlinkSync(path, join(folder, 'link.exr'));
  saveWhole(join(folder, 'link.exr'), '-o link.exr', data);
  expect([...readFileSync(path)]).toEqual([1, 2, 3]);
  expect(readdirSync(folder).sort()).toEqual(['a.exr', 'link.exr']);
});

test('where the place has become impossible, the picture is kept elsewhere and the message says where', () => {
  const gone = join(folder, 'gone');
  mkdirSync(gone);
  rmSync(gone, { recursive: true });
  let message = '';
  try {
    savePicture(join(gone, 'b.exr'), '-o b.exr', data);
  } catch (error) {
    message = (error as Error).message;
  }
  const [, refuge = ''] = /^-o b\.exr: .+; the picture is in (.+)$/.exec(message) ?? [];
  expect([...readFileSync(refuge)]).toEqual([1, 2, 3]);
  rmSync(refuge);
});

test('a place that cannot be replaced leaves no half file beside it', () => {
  const taken = join(folder, 'taken');
  mkdirSync(join(taken, 'c.exr', 'full'), { recursive: true });
  expect(() => saveWhole(join(taken, 'c.exr'), '-o c.exr', data)).toThrow(/^-o c\.exr: /);
  expect(readdirSync(taken)).toEqual(['c.exr']);
});
