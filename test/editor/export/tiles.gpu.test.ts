import { expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import {
  around,
  marginOf,
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

const camera = { fov: 45, position: [1, 1.5, 3], target: [0, 0.3, 0] };
const content = {
  format: 'irradia',
  version: 1,
  camera,
  background: { type: 'color', color: [0.1, 0.2, 0.3] },
  lights: { sun: { type: 'directional', illuminance: 3, position: [2, 4, 3] }, sky: { type: 'ambient' } },
  materials: { paint: { model: 'principled', parameters: { baseColor: [0.8, 0.2, 0.1] } } },
  objects: {
    ring: { material: 'paint', position: [0, 0.5, 0], geometry: { type: 'torus' } },
    floor: { material: 'paint', rotation: [-90, 0, 0], geometry: { type: 'plane', width: 6, height: 6 } },
  },
};
const document = parseDocument(content, 'test');

const { renderer: three } = await testRenderer(32, 32);
const renderer = new RealtimeRenderer(three);
const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: expect.fail });
mirror.apply(document);
await mirror.settled();

const size = { width: 150, height: 90 };

async function picture(read: TileReader, largest: number, shown = document): Promise<Float32Array> {
  const whole = new Float32Array(4 * size.width * size.height);
  await renderTiles({
    renderer,
    mirror,
    document: shown,
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

test('faults of the lens are those of the whole picture, not of a tile', async () => {
  const effects = { lens: { enabled: true, dispersion: 0.1 } };
  const shown = parseDocument({ ...content, effects }, 'test');
  const one = await picture(readLinear, 1000, shown);
  const tiled = await picture(readLinear, 50, shown);
  // Blue is looked for up to four pixels beyond the border, where the one picture has nothing.
  const border = 5;
  const errors = tiled
    .map((value, i) => Math.abs(value - one[i]!))
    .filter((_, i) => {
      const [x, y] = [(i >> 2) % size.width, Math.floor((i >> 2) / size.width)];
      return Math.min(x, size.width - 1 - x, y, size.height - 1 - y) >= border;
    });
  expect(errors.filter((error) => error > 0.01).length / errors.length).toBeLessThan(0.005);
});

test('margins are as wide as effects look, on the grid of the glow', () => {
  const large = { width: 7680, height: 4320 };
  const margin = (effects: object, fStop = 0) =>
    marginOf(parseDocument({ ...content, camera: { ...camera, fStop }, effects }, 'test'), large);
  expect(margin({})).toBe(64);
  expect(margin({ depthOfField: { enabled: true } }, 2)).toBe(360);
  expect(margin({ bloom: { enabled: true, radius: 1 } })).toBe(448);
  // A fringe of half of the dispersion at the edge, 3840 pixels from the middle.
  expect(margin({ lens: { enabled: true, dispersion: 0.1 } })).toBe(64 + 192);
  expect(around({ x: 1000, y: 0, width: 1000, height: 900 }, 100, 128)).toEqual({
    x: 896,
    y: -128,
    width: 1280,
    height: 1152,
  });
});
