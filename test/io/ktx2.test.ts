import { expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { GltfWriter } from '../../src/io/gltf/writer.ts';
import { importGltf } from '../../src/io/gltf.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { readTexels } from '../../src/scene/texels.ts';
import { ktx2 } from './ktx2-writer.ts';

const red = [200, 10, 20, 255];
const blue = [10, 20, 220, 128];
const assets = new AssetLoader(nodeAssets);

function modelWith(image: Uint8Array): Uint8Array {
  const writer = new GltfWriter();
  writer.use('KHR_texture_basisu');
  const source = writer.image(image, 'image/ktx2', 'paint');
  const index = writer.add('textures', { extensions: { KHR_texture_basisu: { source } } });
  const material = writer.add('materials', { pbrMetallicRoughness: { baseColorTexture: { index } } });
  const attributes = {
    POSITION: writer.attribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 'VEC3', true),
    TEXCOORD_0: writer.attribute(new Float32Array([0, 0, 1, 0, 0, 1]), 'VEC2'),
  };
  writer.add('nodes', { mesh: writer.add('meshes', { primitives: [{ attributes, material }] }) });
  return writer.finish();
}

test('a KTX2 texture of a glTF file is RGBA, its rows from the bottom, its size its own', async () => {
  // 6 x 5 texels lie in 2 x 2 blocks.
  const image = ktx2(6, 5, [red, blue, blue, red]);
  const { materials, asset, notes } = await importGltf(modelWith(image), 'a.glb', assets);
  const [material] = materials.values();
  expect(notes).toEqual([]);
  const texels = readTexels(await assets.image(asset!, material!.textures.baseColor!.texture));
  expect([texels.width, texels.height]).toEqual([6, 5]);
  const at = (x: number, y: number) => [...texels.bytes.subarray(4 * (6 * y + x), 4 * (6 * y + x) + 4)];
  expect(at(0, 0)).toEqual(blue);
  expect(at(0, 4)).toEqual(red);
  expect(at(5, 4)).toEqual(blue);
  expect(at(5, 0)).toEqual(red);
});

test.each([
  ['not one', new Uint8Array(200)],
  ['cut off', ktx2(6, 5, [red, blue, blue, red]).slice(0, 190)],
  ['huge', ktx2(70_000, 70_000, [red])],
])('a KTX2 texture that is %s is left out, and said', async (_, image) => {
  const { materials, notes } = await importGltf(modelWith(image), 'a.glb', assets);
  expect([...materials.values()][0]?.textures).toEqual({});
  expect(notes.join()).toContain('textures[0]: the image cannot be read');
});
