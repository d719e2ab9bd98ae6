/** Fog, shafts of light and many lamps on both back ends of three.js. */
import { expect, test } from 'vitest';
import { material } from '../../pathtracer/scenes.ts';
import { pageHarness } from '../../support/page.ts';
import type { EffectsFrames, EffectsRequest } from './back-ends.page.ts';

const harness = await pageHarness(new URL('./back-ends.page.ts', import.meta.url));

const document = (more: object) => ({
  format: 'irradia',
  version: 1,
  camera: { fov: 50, position: [0, 1.6, 5.5], target: [0, 1.2, 0] },
  objects: {
    floor: { material: 'm', rotation: [-90, 0, 0], geometry: { type: 'plane', width: 8, height: 8 } },
    ball: { material: 'm', position: [0.2, 1.4, 0], geometry: { type: 'sphere', radius: 0.4 } },
  },
  materials: { m: material('lambert') },
  effects: { antialiasing: { method: 'none' }, shadows: { enabled: true, resolution: 256 } },
  view: { toneMapping: 'none' },
  ...more,
});

const bulb = (i: number) => ({
  type: 'point',
  position: [3 * Math.cos(i), 0.6, 3 * Math.sin(i)],
  intensity: 0.3,
  range: (i % 3) * 2,
  castShadow: false,
});

const cases: Record<string, object> = {
  shafts: document({
    lights: {
      sun: { type: 'directional', illuminance: 2, position: [2, 4, 1], target: [0, 0, 0] },
      spot: { type: 'spot', intensity: 60, position: [0, 4, 0], target: [0, 0, 0], cutoff: 25 },
      panel: {
        type: 'rectangle',
        luminance: 8,
        position: [-2, 3, 0],
        target: [0, 0, 0],
        width: 1,
        height: 1,
      },
    },
    fog: { density: 0.15, anisotropy: 0.4, height: 1, base: 0.5 },
  }),
  'many lamps': document({
    lights: Object.fromEntries(Array.from({ length: 14 }, (_, i) => [`l${i}`, bulb(i)])),
  }),
};

const size = { width: 96, height: 64 };

test('both back ends show the same', async () => {
  const draw = (forceWebGL: boolean) =>
    harness.run<EffectsFrames>({
      forceWebGL,
      documents: Object.values(cases) as Record<string, unknown>[],
      size,
    } satisfies EffectsRequest);
  const [webgpu, webgl] = [await draw(false), await draw(true)];
  expect([webgpu.backend, webgl.backend]).toEqual(['webgpu', 'webgl']);
  for (const [i, { radiance }] of webgpu.frames.entries()) {
    const other = webgl.frames[i]!.radiance;
    expect(radiance.reduce((sum, x) => sum + x, 0) / radiance.length).toBeGreaterThan(0.01);
    expect(other.filter((x, k) => Math.abs(x - radiance[k]!) > 0.01).length / other.length).toBeLessThan(
      0.02,
    );
  }
});
