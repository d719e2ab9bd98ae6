import { expect, test } from 'vitest';
import { pageHarness } from '../../support/page.ts';
import type { ScreenSpaceFrames, ScreenSpaceRequest } from './screen-space.page.ts';

const harness = await pageHarness(new URL('./screen-space.page.ts', import.meta.url));

const size = { width: 48, height: 32 };

const plane = (rotation: number[], position: number[], material: string) => ({
  name: 'plane',
  material,
  rotation,
  position,
  geometry: { type: 'plane', width: 4, height: 4 },
});

const lit = (effects: object) => ({
  format: 'irradia',
  version: 1,
  name: 'screen space',
  camera: { fov: 35, position: [0.5, 1, 4], target: [0, 0.5, 0] },
  environment: { source: { type: 'constant', color: [1, 1, 1] }, samples: 4 },
  background: { type: 'color', color: [0.2, 0.2, 0.2] },
  objects: {
    floor: plane([-90, 0, 0], [0, 0, 0], 'floor'),
    wall: plane([0, 0, 0], [0, 2, -1], 'red'),
    ball: {
      name: 'ball',
      material: 'white',
      position: [0, 0.4, 0],
      geometry: { type: 'sphere', radius: 0.4, widthSegments: 48, heightSegments: 32 },
    },
  },
  materials: {
    floor: { name: 'f', model: 'principled', parameters: { roughness: 0.3, baseColor: [0.5, 0.5, 0.5] } },
    red: { name: 'r', model: 'lambert', parameters: { albedo: [0.8, 0.1, 0.1] } },
    white: { name: 'w', model: 'lambert', parameters: { albedo: [0.8, 0.8, 0.8] } },
  },
  lights: { sun: { type: 'directional', illuminance: 2, position: [-2, 2, 2] } },
  effects: { antialiasing: { method: 'none' }, shadows: { enabled: false }, ...effects },
});

const effects = {
  'ambient occlusion': { ambientOcclusion: { enabled: true } },
  'contact shadows': { contactShadows: { enabled: true, length: 0.4, thickness: 0.4 } },
  'traced light': { reflections: { enabled: true }, indirectLight: { enabled: true } },
};

test('what is computed in screen space is the same on WebGPU and on WebGL 2', async () => {
  const documents = [lit({}), ...Object.values(effects).map(lit)];
  const draw = (forceWebGL: boolean) =>
    harness.run<ScreenSpaceFrames>({ forceWebGL, documents, size, frames: 4 } satisfies ScreenSpaceRequest);
  const webgpu = await draw(false);
  const webgl = await draw(true);
  expect([webgpu.backend, webgl.backend]).toEqual(['webgpu', 'webgl']);
  const distance = (a: number[], b: number[]) => {
    const isColor = (_: number, i: number) => i % 4 < 3;
    const [x, y] = [a.filter(isColor), b.filter(isColor)];
    const sum = x.reduce((total, value) => total + value, 0);
    return x.reduce((total, value, i) => total + Math.abs(value - y[i]!), 0) / sum;
  };
  for (const [i, name] of ['no effect', ...Object.keys(effects)].entries()) {
    const [a, b] = [webgpu.pictures[i]!, webgl.pictures[i]!];
    expect(a.every(Number.isFinite), name).toBe(true);
    expect(b.every(Number.isFinite), name).toBe(true);
    if (i > 0) expect(distance(a, webgpu.pictures[0]!), name).toBeGreaterThan(0.001);
    expect(distance(a, b), name).toBeLessThan(0.005);
  }
});
