import { expect, it } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { displayPixels } from '../../src/color/tone-mapping.ts';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { material, scene } from '../pathtracer/scenes.ts';
import { trace } from '../pathtracer/tracer.ts';
import { testRenderer } from '../support/gpu.ts';

const [WIDTH, HEIGHT] = [40, 30];
const gpu = testRenderer(WIDTH, HEIGHT);

/** A glowing disc before nothing, a quarter of the picture's height in radius. */
const disc = (background: object, effects: object = {}) =>
  scene({
    camera: { fov: 90, position: [0, 0, 2], target: [0, 0, 0] },
    background,
    effects,
    objects: { o: { name: 'o', material: 'm', geometry: { type: 'circle', radius: 1, segments: 96 } } },
    materials: { m: material('lambert', {}, { emissive: [1, 0.5, 0.25], emissiveIntensity: 0.5 }) },
    view: { toneMapping: 'none' },
  });

/** sRGB of the glow. */
const GLOW = [0.5, 0.25, 0.125].map((x) => Math.round(255 * (1.055 * x ** (1 / 2.4) - 0.055)));
const COVERED = (Math.PI * (HEIGHT / 4) ** 2) / (WIDTH * HEIGHT);

async function picture(document: ReturnType<typeof disc>): Promise<Uint8Array> {
  const { renderer } = await gpu;
  const mirror = new SceneMirror({ assets: new AssetLoader(nodeAssets), onError: () => {} });
  mirror.apply(document);
  const realtime = new RealtimeRenderer(renderer);
  realtime.render(mirror, document, { width: WIDTH, height: HEIGHT });
  return realtime.readImage(document.view);
}

const coverage = (pixels: ArrayLike<number>) => {
  let sum = 0;
  for (let i = 3; i < pixels.length; i += 4) sum += pixels[i]! / 255 / (pixels.length / 4);
  return sum;
};

function expectGlow(pixels: ArrayLike<number>): void {
  for (let i = 0; i < pixels.length; i += 4) {
    // Of faint edges a byte has few digits left.
    if (pixels[i + 3]! < 60) continue;
    for (let c = 0; c < 3; c++) expect(Math.abs(pixels[i + c]! - GLOW[c]!)).toBeLessThan(5);
  }
}

it('a transparent background: alpha is what is covered, colours are those of what covers, up to the edge', async () => {
  const pixels = await picture(disc({ type: 'transparent' }));
  expect(Math.abs(coverage(pixels) / COVERED - 1)).toBeLessThan(0.05);
  expect([...pixels.slice(0, 4)]).toEqual([0, 0, 0, 0]);
  expectGlow(pixels);
});

it('other backgrounds are opaque', async () => {
  const pixels = await picture(disc({ type: 'color', color: [0, 0, 0] }));
  expect(coverage(pixels)).toBeCloseTo(1, 9);
});

it('effects keep the alpha', async () => {
  const pixels = await picture(
    disc(
      { type: 'transparent' },
      { bloom: { enabled: true }, antialiasing: { method: 'smaa' }, lens: { enabled: true } },
    ),
  );
  expect(Math.abs(coverage(pixels) / COVERED - 1)).toBeLessThan(0.1);
});

it('the path tracer has the same alpha and colours', async () => {
  const film = await trace(disc({ type: 'transparent' }), { samples: 64, width: WIDTH, height: HEIGHT });
  const pixels = displayPixels(film.mean(), { exposure: 0, toneMapping: 'none' }, film.meanAlpha());
  expect(Math.abs(coverage(pixels) / COVERED - 1)).toBeLessThan(0.02);
  expectGlow(pixels);
});
