/** What a model refers to is found where it lies, among all that came with it. */
import { expect, test } from 'vitest';
import { companionsFrom, findCompanion } from '../../src/io/meshes/companions.ts';

const found = (model: string, reference: string, paths: readonly string[]): string | undefined =>
  findCompanion(companionsFrom(model, new Map(paths.map((path) => [path, path]))), reference)?.content;

test.each([
  ['beside the model, not beside another one', 'b/scene.gltf', 'textures/base.png', 'b/textures/base.png'],
  ['above it', 'a/source/m.gltf', '../textures/base.png', 'a/textures/base.png'],
  [
    'by the end of a path of another machine',
    'm.obj',
    'D:\\work\\a\\Textures\\BASE.png',
    'a/textures/base.png',
  ],
  ['with steps that lead nowhere', 'a/m.gltf', './x/..//textures/./base.png', 'a/textures/base.png'],
  ['by its name alone, the nearest', 'c/d/m.obj', 'maps/wall.png', 'c/wall.png'],
  ['escaped', 'c/m.gltf', 'my%20%C3%BCber%23.png', 'c/my über#.png'],
  ['with a name that looks escaped', 'c/m.obj', '50%25.png', 'c/50%25.png'],
  ['in the case that it has, where both are there', 'e/m.obj', 'Wood.png', 'e/Wood.png'],
])('a file is found %s', (_, model, reference, expected) => {
  const paths = [
    ...['a/textures/base.png', 'b/textures/base.png', 'wall.png', 'c/wall.png', 'c/my über#.png'],
    ...['c/50%25.png', 'e/wood.png', 'e/Wood.png'],
  ];
  expect(found(model, reference, paths)).toBe(expected);
});

test('letters and their accents may come apart, as disks of macOS have them', () => {
  expect(found('m.gltf', 'f%C3%A4rbe.png', ['f\u0061\u0308rbe.png'])).toBeDefined();
});

test('another file is none', () => {
  expect(found('m.gltf', 'base.png', ['a/base.jpg', 'database.png'])).toBeUndefined();
});
