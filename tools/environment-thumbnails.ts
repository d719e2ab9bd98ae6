/**
 * Writes the small pictures of the shipped environments that the inspector's picker shows, side by side in one file:
 * `node tools/run.mjs tools/environment-thumbnails.ts`.
 */
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { nodeAssets } from '../src/cli/node-assets.ts';
import { displayPixels } from '../src/color/tone-mapping.ts';
import { readSkyMap } from '../src/pathtracer/scene/sky.ts';
import { AssetLoader } from '../src/scene/assets.ts';
import { environmentPresets } from '../src/scene/presets.ts';

const FILE = '../src/editor/panels/environments/shipped.webp';
/** src/editor/panels/environments/shipped.ts has the same numbers. */
const [WIDTH, HEIGHT, COLUMNS] = [96, 48, 6];

const assets = new AssetLoader(nodeAssets);
const rows = Math.ceil(environmentPresets.length / COLUMNS);
const pictures = await Promise.all(
  environmentPresets.map(async (name, i) => {
    const { texels, width, height } = readSkyMap(await assets.preset(name));
    const rgb = new Float32Array(3 * WIDTH * HEIGHT);
    let sum = 0;
    for (let y = 0; y < HEIGHT; y += 1)
      for (let x = 0; x < WIDTH; x += 1) {
        // The mean of the texels that a pixel has; the first row is the lowest.
        const [left, right] = [x, x + 1].map((edge) => Math.floor((edge * width) / WIDTH)) as [
          number,
          number,
        ];
        const [low, high] = [HEIGHT - 1 - y, HEIGHT - y].map((edge) =>
          Math.floor((edge * height) / HEIGHT),
        ) as [number, number];
        const count = (right - left) * (high - low);
        for (let v = low; v < high; v += 1)
          for (let u = left; u < right; u += 1)
            for (let c = 0; c < 3; c += 1)
              rgb[3 * (y * WIDTH + x) + c]! += Math.min(texels[4 * (v * width + u) + c]!, 20) / count;
        sum += Math.log2(Math.max(rgb[3 * (y * WIDTH + x) + 1]!, 1e-4));
      }
    // The geometric mean becomes middle grey.
    const exposure = Math.log2(0.18) - sum / (WIDTH * HEIGHT);
    const input = Buffer.from(displayPixels(rgb, { exposure, toneMapping: 'agx' }));
    return {
      input,
      raw: { width: WIDTH, height: HEIGHT, channels: 4 as const },
      left: (i % COLUMNS) * WIDTH,
      top: Math.floor(i / COLUMNS) * HEIGHT,
    };
  }),
);
await sharp({ create: { width: WIDTH * COLUMNS, height: HEIGHT * rows, channels: 3, background: '#000' } })
  .composite(pictures)
  .webp({ quality: 72 })
  .toFile(fileURLToPath(new URL(FILE, import.meta.url)));
