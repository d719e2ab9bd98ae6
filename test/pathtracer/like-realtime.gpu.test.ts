import { expect, it } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { addImported, importGltf } from '../../src/io/gltf.ts';
import { exportGltf } from '../../src/io/gltf-export.ts';
import { encodePng } from '../../src/io/png.ts';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { drawPattern } from '../../src/scene/pattern/draw.ts';
import { defaultPattern, patternAsset } from '../../src/scene/pattern/pattern.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { readTexels } from '../../src/scene/texels.ts';
import { testRenderer } from '../support/gpu.ts';
import { material, scene, wall } from './scenes.ts';
import { trace } from './tracer.ts';

/** The path tracer against the interactive renderer, where both mean the same: direct light that nothing keeps off. */

const [WIDTH, HEIGHT] = [48, 32];

const gpu = testRenderer(WIDTH, HEIGHT);

/** Both pictures of a document under direct light: how many of their values are far apart, and the mean difference. */
async function compare(document: Document): Promise<{ far: number; error: number }> {
  const { renderer } = await gpu;
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
  realtime.render(mirror, { view }, { width: WIDTH, height: HEIGHT });
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
  return { far: far / (WIDTH * HEIGHT * 3), error: error / sum };
}

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
  const { far, error } = await compare(document);
  // Rims are supersampled in different places; the rectangle is sampled by both.
  expect(far).toBeLessThan(0.01);
  expect(error).toBeLessThan(0.01);
});

it('textures of every kind lie the same way on a surface', async () => {
  const image = async (name: string, texel: (x: number, y: number) => readonly number[]) => {
    const pixels = Uint8Array.from({ length: 4 * 16 * 16 }, (_, i) => {
      const [x, y] = [(i >> 2) % 16, (i >> 2) >> 4];
      return texel(x, y)[i & 3] ?? 255;
    });
    return { name, mediaType: 'image/png', data: encodeBase64(await encodePng(pixels, 16, 16)) };
  };
  const placed = { repeat: [1.5, 1.2], offset: [0.1, 0.25], rotation: 30 };
  const document = scene({
    camera: { fov: 30, position: [0.5, 0.3, 4], target: [0, 0, 0] },
    background: { type: 'color', color: [0.1, 0.2, 0.3] },
    objects: { wall: wall({ rotation: [-20, 25, 10] }) },
    assets: {
      color: await image('color.png', (x, y) => [16 * x, 255 - 15 * y, (x * y) % 255]),
      rough: await image('rough.png', (x) => [0, 100 + 9 * x, 0]),
      normal: await image('normal.png', (x, y) => [96 + 4 * x, 160 - 4 * y, 250]),
      hole: await image('hole.png', (x, y) => [255, 255, 255, (x - 8) ** 2 + (y - 8) ** 2 < 20 ? 0 : 255]),
    },
    materials: {
      m: material(
        'principled',
        { roughness: 0.9, baseColor: [1, 0.9, 0.8] },
        {
          textures: {
            baseColor: { asset: 'color', colorSpace: 'srgb', ...placed },
            roughness: { asset: 'rough', channel: 'g', ...placed, wrap: 'mirror' },
          },
          normalMap: { asset: 'normal', scale: 0.7, ...placed },
          opacityMap: { asset: 'hole', scale: 1 },
          alphaMode: 'mask',
        },
      ),
    },
    lights: {
      sun: { type: 'directional', illuminance: 2, position: [1, 2, 6] },
      lamp: { type: 'point', intensity: 20, position: [-2, 1, 4] },
    },
  });
  const { far, error } = await compare(document);
  expect(far).toBeLessThan(0.02);
  expect(error).toBeLessThan(0.01);
});

it('a pattern is the same image in both renderers, and in a GLB', async () => {
  const pattern = { ...defaultPattern('marble'), size: 64, seed: 3, color: [0.6, 0.5, 0.4] as const };
  const surface = { asset: 'stone', repeat: [1.5, 1.5], rotation: 20 };
  const document = scene({
    camera: { fov: 30, position: [0.5, 0.3, 4], target: [0, 0, 0] },
    background: { type: 'color', color: [0.1, 0.2, 0.3] },
    objects: { wall: wall({ rotation: [-20, 25, 10] }) },
    assets: { stone: patternAsset({ ...pattern, relief: 8 }) },
    materials: {
      m: material(
        'principled',
        { roughness: 0.7, baseColor: [1, 1, 1] },
        {
          textures: {
            baseColor: { ...surface, colorSpace: 'srgb' },
            roughness: { ...surface, texture: 2, channel: 'g' },
          },
          normalMap: { ...surface, texture: 1, scale: 1 },
        },
      ),
    },
    lights: { sun: { type: 'directional', illuminance: 2, position: [1, 2, 6] } },
  });
  const { far, error } = await compare(document);
  expect(far).toBeLessThan(0.02);
  expect(error).toBeLessThan(0.01);

  const assets = new AssetLoader(nodeAssets);
  const { bytes, notes } = await exportGltf(document, assets);
  expect(notes.filter((note) => /texture|pattern/.test(note))).toEqual([]);
  const { material: read, document: file } = await readAgain(bytes);
  const { asset, texture } = read.textures.baseColor!;
  const image = await assets.image(file.assets[asset]!, texture);
  expect(readTexels(image).bytes).toEqual(drawPattern({ ...pattern, relief: 8 }, 0).data);
});

async function readAgain(bytes: Uint8Array<ArrayBuffer>) {
  const imported = await importGltf(bytes, 'scene.glb', new AssetLoader(nodeAssets));
  const store = new DocumentStore(createDocument());
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return { document: store.document, material: Object.values(store.document.materials)[0]! };
}
