import { expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import {
  readLinear,
  readScreen,
  renderTiles,
  type TileReader,
} from '../../../src/editor/panels/export/tiles.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { testRenderer } from '../../support/gpu.ts';

const document = parseDocument(
  {
    format: 'irradia',
    version: 1,
    camera: { fov: 45, position: [1, 1.5, 3], target: [0, 0.3, 0] },
    background: { type: 'color', color: [0.1, 0.2, 0.3] },
    lights: { sun: { type: 'directional', illuminance: 3, position: [2, 4, 3] }, sky: { type: 'ambient' } },
    materials: { paint: { model: 'principled', parameters: { baseColor: [0.8, 0.2, 0.1] } } },
    objects: {
      ring: { material: 'paint', position: [0, 0.5, 0], geometry: { type: 'torus' } },
      floor: { material: 'paint', rotation: [-90, 0, 0], geometry: { type: 'plane', width: 6, height: 6 } },
    },
  },
  'test',
);

const { renderer: three } = await testRenderer(32, 32);
const renderer = new RealtimeRenderer(three);
const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: expect.fail });
mirror.apply(document);
await mirror.settled();

async function picture(read: TileReader, largest: number): Promise<Float32Array> {
  const size = { width: 150, height: 90 };
  const whole = new Float32Array(4 * size.width * size.height);
  await renderTiles({
    renderer,
    mirror,
    document,
    size,
    read,
    largest,
    signal: new AbortController().signal,
    onTile(tile, pixels) {
      for (let y = 0; y < tile.height; y++)
        whole.set(
          pixels.subarray(4 * tile.width * y, 4 * tile.width * (y + 1)),
          4 * ((tile.y + y) * size.width + tile.x),
        );
    },
  });
  return whole;
}

test.each([
  ['as a screen shows it', readScreen, 1],
  ['linear', readLinear, 0.01],
] as const)('a picture in tiles is the picture in one: %s', async (_, read, tolerance) => {
  const one = await picture(read, 1000);
  const tiled = await picture(read, 50);
  expect(new Set(one).size).toBeGreaterThan(20);
  // At a few edges a sample falls to the other side: GPUs round corners of triangles to parts of a pixel.
  const different = tiled.filter((value, i) => Math.abs(value - one[i]!) > tolerance).length;
  expect(different / tiled.length).toBeLessThan(0.005);
});
