import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three/webgpu';
import { expect, test } from 'vitest';
import { meterPicture } from '../../src/color/exposure.ts';
import { ExposureMeter } from '../../src/realtime/exposure-meter.ts';
import { material, scene } from '../pathtracer/scenes.ts';
import { frameMaker } from './effects/frames.ts';

const SIZE = { width: 96, height: 64 };
const maker = await frameMaker(SIZE);
const { renderer } = maker;

const wall = (intensity: number, view: object) =>
  scene({
    camera: { fov: 40, position: [0, 0, 1], target: [0, 0, 0], fStop: 4, shutter: 1 / 100, iso: 100 },
    objects: { wall: { name: 'w', material: 'm', geometry: { type: 'plane', width: 9, height: 9 } } },
    materials: { m: material('lambert', {}, { emissive: [1, 1, 1], emissiveIntensity: intensity }) },
    view: { toneMapping: 'none', ...view },
  });

test('the GPU meters what the CPU meters', async () => {
  const side = 256;
  const radiance = new Float32Array(3 * side * side).map((_, i) => {
    const [x, y] = [Math.floor(i / 3) % side, Math.floor(i / 3 / side)];
    return 2 ** (8 * Math.sin(x / 40) * Math.cos(y / 30)) * (1 + (i % 3) / 2);
  });
  const rgba = new Float32Array(4 * side * side).map((_, i) =>
    i % 4 === 3 ? 1 : radiance[3 * Math.floor(i / 4) + (i % 4)]!,
  );
  const texture = new DataTexture(rgba, side, side, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  const onGpu = new ExposureMeter();
  await onGpu.settle(renderer.three, texture);
  expect(onGpu.exposure).toBeCloseTo(meterPicture(radiance, side, side), 1);
  onGpu.dispose();
});

test('automatic exposure shows any luminance as middle grey, and compensation is added', async () => {
  for (const intensity of [0.05, 3, 4000]) {
    const document = wall(intensity, { exposureMode: 'auto' });
    const mirror = await maker.mirror(document);
    renderer.cut();
    renderer.render(mirror, document, SIZE);
    await renderer.settleExposure(document.view);
    const image = await renderer.readImage(document.view);
    mirror.dispose();
    // sRGB of 0.18.
    expect(Math.abs(image[0]! - 118)).toBeLessThanOrEqual(1);
    expect(renderer.exposure({ ...document.view, exposure: 1 }) - renderer.exposure(document.view)).toBe(1);
  }
});

test('it goes there over time, and says when it has arrived', async () => {
  const mirror = await maker.mirror(wall(1, {}));
  /** One frame a tenth of a second later; the meter's reading of it comes before the next. */
  const step = async (intensity: number): Promise<number> => {
    const document = wall(intensity, { exposureMode: 'auto' });
    mirror.apply(document);
    renderer.render(mirror, document, SIZE, 0.1);
    await renderer.readRadiance();
    await new Promise((resolve) => setTimeout(resolve));
    return renderer.exposure(document.view);
  };
  renderer.cut();
  for (let i = 0; i < 3; i++) await step(1);
  const way: number[] = [];
  do way.push(await step(16));
  while (renderer.adapting && way.length < 200);
  mirror.dispose();
  const goal = Math.log2(0.18 / 16);
  expect(way[0]).toBeGreaterThan(goal + 1);
  for (const [i, exposure] of way.entries()) expect(exposure).toBeLessThanOrEqual(way[i - 1] ?? 0);
  expect(way.at(-1)).toBeCloseTo(goal, 2);
  expect(way.length).toBeGreaterThan(4);
});

test('the camera exposes as its settings say', async () => {
  const document = wall(1200, { exposureMode: 'camera' });
  const mirror = await maker.mirror(document);
  renderer.render(mirror, document, SIZE);
  const image = await renderer.readImage(document.view);
  mirror.dispose();
  // EV100 of f/4, 1/100 s: log2(1600); 1.2 x 1600 nits are white.
  const value = 1200 / (1.2 * 1600);
  const srgb = 255 * (1.055 * value ** (1 / 2.4) - 0.055);
  expect(Math.abs(image[0]! - srgb)).toBeLessThanOrEqual(1);
});
