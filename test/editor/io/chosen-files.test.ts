/** Of what is dropped together that is opened which is meant. */
import { describe, expect, test } from 'vitest';
import { filesToOpen, strangers } from '../../../src/editor/io/chosen-files.ts';

/** As a drop of a folder gives them; those without a folder came by themselves. */
const files = (...paths: string[]): File[] =>
  paths.map((path) => {
    const file = new File(['x'], path.replace(/^.*\//, ''));
    Object.defineProperty(file, 'webkitRelativePath', { value: path.includes('/') ? path : '' });
    return file;
  });
const opened = (...paths: string[]): string[] =>
  filesToOpen(files(...paths)).map((file) => file.webkitRelativePath || file.name);

describe('of a folder', () => {
  test.each<[string, string[], string[]]>([
    [
      'models of one name in several folders are different models',
      ['z/one/scene.gltf', 'z/one/scene.bin', 'z/two/scene.gltf', 'z/two/t.png'],
      ['z/one/scene.gltf', 'z/two/scene.gltf'],
    ],
    [
      'a model in several formats is opened once, in the one that says most',
      ['Box/glTF/Box.gltf', 'Box/glTF-Binary/Box.glb', 'Box/obj/Box.obj'],
      ['Box/glTF-Binary/Box.glb'],
    ],
    [
      'and in several ways to pack it, once',
      ['Box/glTF/Box.gltf', 'Box/glTF-Draco/Box.gltf', 'Box/glTF-Embedded/Box.gltf'],
      ['Box/glTF/Box.gltf'],
    ],
    ['images of what is not read are not asked about', ['z/a.fbx', 'z/t/a.png', 'z/t/b.png'], []],
    ['one image is', ['z/sky.jpg', 'z/licence.txt'], ['z/sky.jpg']],
    ['.json beside a model is none of ours', ['z/a.glb', 'z/package.json'], ['z/a.glb']],
  ])('%s', (_, given, expected) => expect(opened(...given)).toEqual(expected));
});

test('files that came by themselves are all meant, and what is no known file is told', () => {
  const given = ['a.glb', 'a.obj', 'a.mtl', 'a.png', 'b.fbx', 'scene.bin'];
  expect(opened(...given)).toEqual(['a.glb', 'a.obj']);
  expect(strangers(files(...given)).map(({ name }) => name)).toEqual(['b.fbx']);
});
