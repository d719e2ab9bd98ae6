import { afterAll, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { RealtimeRenderer } from '../../../src/realtime/renderer.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { material, scene } from '../../pathtracer/scenes.ts';
import { testRenderer } from '../../support/gpu.ts';

const SIZE = { width: 96, height: 96 };
const { renderer: three } = await testRenderer(SIZE.width, SIZE.height);
const renderer = new RealtimeRenderer(three, { samples: 4 });
afterAll(() => renderer.dispose());

/** Bars of light at small angles to the rows and columns of pixels, before a wall. */
const bars = (method: string, { x = 0 } = {}) =>
  scene({
    camera: { fov: 40, position: [0, 0, 4], target: [0, 0, 0] },
    background: { type: 'color', color: [0.1, 0.1, 0.1] },
    objects: Object.fromEntries(
      [-2, -1, 0, 1, 2].flatMap((i) =>
        [4, 94].map((angle) => [
          `bar${i + 2}_${angle}`,
          {
            name: 'bar',
            material: 'm',
            position: angle < 90 ? [x, i / 2, 0] : [x + i / 2, 0, 0.01],
            rotation: [0, 0, angle + 5 * i],
            geometry: { type: 'plane', width: 1.5, height: 0.07 },
          },
        ]),
      ),
    ),
    materials: { m: material('lambert', {}, { emissive: [1, 0.8, 0.6], emissiveIntensity: 1 }) },
    effects: { antialiasing: { method } },
    view: { toneMapping: 'none' },
  });

async function mirrorOf(document: ReturnType<typeof bars>): Promise<SceneMirror> {
  const mirror = new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError(message) {
      throw new Error(message);
    },
  });
  mirror.apply(document);
  await mirror.settled();
  return mirror;
}

async function draw(document: ReturnType<typeof bars>, frames = 1, size = SIZE): Promise<Float32Array> {
  const mirror = await mirrorOf(document);
  renderer.cut();
  for (let i = 0; i < frames; i++) renderer.render(mirror, document, size);
  const { pixels } = await renderer.readRadiance();
  mirror.dispose();
  return pixels;
}

const SUPER = 8;

/** 64 samples a pixel. */
async function reference(): Promise<Float32Array> {
  const { width, height } = SIZE;
  const fine = await draw(bars('none'), 1, { width: width * SUPER, height: height * SUPER });
  return new Float32Array(4 * width * height).map((_, i) => {
    const [c, x, y] = [i % 4, Math.floor(i / 4) % width, Math.floor(i / 4 / width)];
    let sum = 0;
    for (let k = 0; k < SUPER * SUPER; k++) {
      const [fx, fy] = [x * SUPER + (k % SUPER), y * SUPER + Math.floor(k / SUPER)];
      sum += fine[4 * (fy * width * SUPER + fx) + c]!;
    }
    return sum / SUPER ** 2;
  });
}

/** Of the colours, root mean square. */
function difference(a: Float32Array, b: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) if (i % 4 < 3) sum += (a[i]! - b[i]!) ** 2;
  return Math.sqrt(sum / ((a.length * 3) / 4));
}

const truth = await reference();

test('frames gathered over time are nearer to the truth than four samples a pixel', async () => {
  const none = difference(await draw(bars('none')), truth);
  const msaa = difference(await draw(bars('msaa')), truth);
  const temporal = difference(await draw(bars('temporal'), 32), truth);
  expect(msaa).toBeLessThan(0.6 * none);
  expect(temporal).toBeLessThan(0.5 * msaa);
});

test('a picture that stands still is complete after so many frames, and stays as it is', async () => {
  const document = bars('temporal');
  const mirror = await mirrorOf(document);
  renderer.cut();
  let frames = 0;
  do renderer.render(mirror, document, SIZE);
  while (++frames < 100 && renderer.unsettled);
  expect(frames).toBe(32);
  const complete = await renderer.readRadiance();
  renderer.render(mirror, document, SIZE);
  expect(await renderer.readRadiance()).toEqual(complete);
  mirror.dispose();
});

test('what moves leaves no ghost, and is where it is', async () => {
  const mirror = await mirrorOf(bars('temporal', { x: -0.5 }));
  renderer.cut();
  for (let i = 0; i < 12; i++) {
    const document = bars('temporal', { x: -0.5 + (i * 0.5) / 11 });
    mirror.apply(document);
    renderer.render(mirror, document, SIZE);
  }
  const { pixels } = await renderer.readRadiance();
  mirror.dispose();
  // Where a bar is no more, and none is near, there is the wall alone.
  let [far, farthest] = [0, 0];
  const isWall = (x: number, y: number) => {
    for (let v = -3; v <= 3; v++)
      for (let u = -3; u <= 3; u++) {
        const i = 4 * ((y + v) * SIZE.width + x + u);
        if (truth[i] === undefined || Math.abs(truth[i]! - 0.1) > 0.005) return false;
      }
    return true;
  };
  for (let y = 3; y < SIZE.height - 3; y++)
    for (let x = 3; x < SIZE.width - 3; x++) {
      if (!isWall(x, y)) continue;
      far++;
      farthest = Math.max(farthest, Math.abs(pixels[4 * (y * SIZE.width + x)]! - 0.1));
    }
  expect(far).toBeGreaterThan(500);
  expect(farthest).toBeLessThan(0.01);
  expect(difference(pixels, truth)).toBeLessThan(difference(await draw(bars('none')), truth));
});

test('a cut, such as another size, keeps nothing of what was', async () => {
  await draw(bars('temporal', { x: 1 }), 5);
  const first = await draw(bars('temporal'));
  renderer.cut();
  const mirror = await mirrorOf(bars('temporal', { x: 1 }));
  renderer.render(mirror, bars('temporal', { x: 1 }), { width: 50, height: 50 });
  mirror.dispose();
  const again = await draw(bars('temporal'));
  // The two frames looked at different places in their pixels: both are pictures of one sample.
  const none = await draw(bars('none'));
  for (const pixels of [first, again]) expect(difference(pixels, none)).toBeLessThan(0.2);
});

/** The picture as a screen shows it, made linear again. */
async function drawShown(document: ReturnType<typeof bars>): Promise<Float32Array> {
  const mirror = await mirrorOf(document);
  renderer.render(mirror, document, SIZE);
  const image = await renderer.readImage(document.view);
  mirror.dispose();
  return Float32Array.from(image, (byte) => {
    const x = byte / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
}

test('edges of the finished picture become smoother by FXAA, and more so by SMAA', async () => {
  const none = difference(await drawShown(bars('none')), truth);
  const fxaa = difference(await drawShown(bars('fxaa')), truth);
  const smaa = difference(await drawShown(bars('smaa')), truth);
  expect(fxaa).toBeLessThan(0.9 * none);
  expect(smaa).toBeLessThan(0.97 * fxaa);
});
