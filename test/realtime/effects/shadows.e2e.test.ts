import { expect, test } from 'vitest';
import { pageHarness } from '../../support/page.ts';
import type { ShadowFrame, ShadowRequest } from './shadows.page.ts';

const harness = await pageHarness(new URL('./shadows.page.ts', import.meta.url));

const size = { width: 48, height: 32 };

/** Every kind of map: cascades, one map, the faces of a cube and of a half one. */
const document = {
  format: 'irradia',
  version: 1,
  name: 'shadows',
  camera: { fov: 40, position: [0, 3, 3], target: [0, 0.2, 0] },
  background: { type: 'color', color: [0, 0, 0] },
  objects: {
    floor: {
      name: 'floor',
      material: 'm',
      rotation: [-90, 0, 0],
      geometry: { type: 'plane', width: 20, height: 20 },
    },
    box: {
      name: 'box',
      material: 'm',
      position: [0, 0.6, 0],
      rotation: [10, 20, 30],
      geometry: { type: 'box', width: 0.6, height: 0.5, depth: 0.4 },
    },
  },
  materials: {
    m: { name: 'm', model: 'lambert', parameters: { albedo: [0.8, 0.8, 0.8] }, doubleSided: true },
  },
  lights: {
    sun: { type: 'directional', illuminance: 1, position: [2, 4, 2], angularDiameter: 5 },
    point: { type: 'point', intensity: 5, position: [1.5, 2, 0.5], radius: 0.1 },
    spot: { type: 'spot', intensity: 10, position: [-1.5, 2, 1], target: [0, 0, 0], cutoff: 35, radius: 0.1 },
    panel: {
      type: 'rectangle',
      luminance: 3,
      position: [0, 2, -1.5],
      target: [0, 0, 0],
      width: 0.6,
      height: 0.4,
    },
  },
  effects: { shadows: { enabled: true, resolution: 128, samples: 16, cascades: 2 } },
};

test('shadows are the same on WebGPU and on WebGL 2', async () => {
  const draw = (forceWebGL: boolean, shadows: object) =>
    harness.run<ShadowFrame>({
      forceWebGL,
      document: { ...document, effects: { shadows } },
      size,
    } satisfies ShadowRequest);
  const webgpu = await draw(false, document.effects.shadows);
  const webgl = await draw(true, document.effects.shadows);
  const plain = await draw(true, { enabled: false });
  expect([webgpu.backend, webgl.backend]).toEqual(['webgpu', 'webgl']);
  const colors = ({ pixels }: ShadowFrame) => pixels.filter((_, i) => i % 4 < 3);
  const distance = (a: ShadowFrame, b: ShadowFrame) => {
    const [x, y] = [colors(a), colors(b)];
    const sum = x.reduce((total, value) => total + value, 0);
    return x.reduce((total, value, i) => total + Math.abs(value - y[i]!), 0) / sum;
  };
  expect(distance(webgpu, plain)).toBeGreaterThan(0.02);
  // Samples whose texel is next to another by a rounding differ.
  expect(distance(webgpu, webgl)).toBeLessThan(0.005);
});
