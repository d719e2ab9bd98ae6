import { expect, it } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { testRenderer } from '../support/gpu.ts';
import { material, scene } from './scenes.ts';
import { trace } from './tracer.ts';

/** The path tracer against the interactive renderer, where both mean the same: direct light that nothing keeps off. */

const [WIDTH, HEIGHT] = [48, 32];

it('a row of balls under every kind of lamp looks the same in both renderers', async () => {
  const ball = (x: number, m: string) => ({
    name: m,
    material: m,
    position: [x, 0, 0],
    rotation: [10, 20, 30],
    geometry: { type: 'sphere', radius: 0.7, widthSegments: 96, heightSegments: 64 },
  });
  // Balls side by side, light from the front: no shadows, and one bounce only.
  const document = scene({
    camera: { fov: 30, position: [0, 0, 8], target: [0, 0, 0] },
    background: { type: 'color', color: [0.1, 0.2, 0.3] },
    objects: { a: ball(-1.7, 'gloss'), b: ball(0, 'copper'), c: ball(1.7, 'plain') },
    materials: {
      gloss: material('principled', { roughness: 0.5, clearcoat: 0.5, baseColor: [0.1, 0.4, 0.7] }),
      copper: material('cook-torrance', { metallic: 1, roughness: 0.5, albedo: [0.9, 0.5, 0.3] }),
      plain: material('lambert', { albedo: [0.7, 0.6, 0.5] }),
    },
    lights: {
      sun: { type: 'directional', illuminance: 1.5, position: [0, 1, 6] },
      lamp: { type: 'point', intensity: 30, position: [0, 1.5, 6], color: [1, 0.7, 0.4] },
      spot: { type: 'spot', intensity: 60, position: [0, 3, 7], target: [0, 0, 0], cutoff: 20, exponent: 3 },
      panel: { type: 'rectangle', luminance: 2, position: [0, 0, 6], target: [0, 0, 0], width: 2, height: 1 },
    },
  });
  const { renderer } = await testRenderer(WIDTH, HEIGHT);
  const mirror = new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError(message) {
      throw new Error(message);
    },
  });
  mirror.apply(document);
  await mirror.settled();
  const realtime = new RealtimeRenderer(renderer, { samples: 1, precision: 'float' });
  // Supersampled: the path tracer's pixels are means over their area, too.
  const scale = 4;
  const view = { ...document.view, resolutionScale: scale };
  realtime.render(mirror, view, { width: WIDTH, height: HEIGHT });
  const { width, pixels } = await realtime.readRadiance();
  const film = await trace(document, { samples: 256, width: WIDTH, height: HEIGHT, maxDepth: 1 });
  const traced = film.mean();

  let far = 0;
  let error = 0;
  let sum = 0;
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      for (let c = 0; c < 3; c++) {
        let shown = 0;
        for (let i = 0; i < scale * scale; i++) {
          const at = (y * scale + Math.floor(i / scale)) * width + x * scale + (i % scale);
          shown += pixels[4 * at + c]! / scale / scale;
        }
        const found = traced[3 * (y * WIDTH + x) + c]!;
        if (Math.abs(found - shown) > 0.05 * shown + 0.02) far++;
        error += Math.abs(found - shown);
        sum += shown;
      }
    }
  }
  // Rims are supersampled in different places; the rectangle is sampled by both.
  expect(far / (WIDTH * HEIGHT * 3)).toBeLessThan(0.01);
  expect(error / sum).toBeLessThan(0.01);
});
