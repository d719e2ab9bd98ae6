import sharp from 'sharp';
import { expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { pageHarness } from '../../support/page.ts';

const harness = await pageHarness(new URL('./page-pack.page.ts', import.meta.url));

test('a page packs a scene into the same words as Node, down to the colours of what is transparent', async () => {
  // 16 x 4 pixels of every kind of alpha; rows from the top.
  const pixels = Uint8Array.from({ length: 16 * 4 * 4 }, (_, i) => (i * 37 + (i % 4 === 3 ? 1 : 0)) % 256);
  const png = (
    await sharp(pixels, { raw: { width: 16, height: 4, channels: 4 } })
      .png()
      .toBuffer()
  ).toString('base64');
  const document = {
    format: 'irradia',
    version: 1,
    assets: { image: { name: 'image', mediaType: 'image/png', data: png } },
    materials: {
      m: {
        model: 'lambert',
        textures: { albedo: { asset: 'image', colorSpace: 'srgb' } },
        emissive: [1, 1, 1],
      },
    },
    // Few triangles: each glows, and has its place in the tree of lights.
    objects: {
      o: { material: 'm', geometry: { type: 'torus', radialSegments: 16, tubularSegments: 24 } },
    },
    lights: { ambient: { type: 'ambient' }, spot: { type: 'spot' } },
  };
  const page = await harness.run<{ texels: number[]; width: number; words: number[]; triangles: number }>({
    png,
    document,
  });
  expect(page.width).toBe(16);
  const rows = [3, 2, 1, 0].flatMap((row) => [...pixels.subarray(64 * row, 64 * row + 64)]);
  expect(page.texels).toEqual(rows);
  const packed = await new ScenePacker(new AssetLoader(nodeAssets)).pack(parseDocument(document, 'test'));
  expect(page.triangles).toBe(packed.triangles);
  // Sines and cosines of the two engines may differ in their last bit.
  expect(page.words.length).toBe(packed.words.length);
  const far = page.words.filter((word, i) => Math.abs(word - packed.words[i]!) > 64).length;
  expect(far / page.words.length).toBeLessThan(0.01);
});
