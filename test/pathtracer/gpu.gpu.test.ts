import { readFileSync } from 'node:fs';
import { afterAll, expect, test } from 'vitest';
import { GpuPathTracer } from '../../src/pathtracer/gpu/gpu-path-tracer.ts';
import type { PathTracer } from '../../src/pathtracer/path-tracer.ts';
import { parseDocument } from '../../src/scene/document.ts';
import type { Camera } from '../../src/scene/schema.ts';
import { testGpu } from '../support/gpu.ts';
import { textWithoutSampler } from './generic.ts';
import { material } from './scenes.ts';
import { packDocument, render, testTracer } from './tracer.ts';

/**
 * WGSL = WebAssembly: both machines run one kernel on the same random numbers. Rounding sends a few paths another way, so
 * single samples may differ: nearly all pixels must agree to rounding, and the pictures' means in what noise leaves.
 *
 * One scene for all: a software GPU compiles the kernel for as long as it renders all of these pictures.
 */
const thesis = JSON.parse(readFileSync('scenes/thesis.json', 'utf8'));
// High above the others: a ball of rough glass, of a model that brings no sampler.
const BALL = [0, 40, 0] as const;
const document = parseDocument(
  {
    ...thesis,
    models: { glass: { source: textWithoutSampler('dielectric') } },
    materials: { ...thesis.materials, glass: material('glass', { roughness: 0.3 }) },
    objects: {
      ...thesis.objects,
      ball: { name: 'Ball', material: 'glass', position: BALL, geometry: { type: 'sphere', radius: 1 } },
    },
  },
  'thesis-and-glass.json',
);

const { device } = await testGpu();
const packed = await packDocument(document);
const [cpu, gpu]: readonly [PathTracer, PathTracer] = [testTracer(), new GpuPathTracer(device, 'test')];
for (const tracer of [cpu, gpu]) await tracer.load(packed);
afterAll(() => {
  for (const tracer of [cpu, gpu]) tracer.dispose();
});

/** The share of values that are not as good as equal. */
function shareApart(a: Float32Array, b: Float32Array, absolute: number): number {
  return a.filter((x, i) => Math.abs(x - b[i]!) > 1e-3 * x + absolute).length / a.length;
}
const sum = (values: Float32Array) => values.reduce((a, b) => a + b, 0);

test('every pixel and its samples, the depths, and passes of some tiles', async () => {
  const films = [];
  for (const tracer of [cpu, gpu]) {
    await render(tracer, document, { samples: 8, width: 48, height: 32, maxDepth: 4 });
    // Two more of the tile in the middle of the upper row.
    await tracer.render(8, 2, { tiles: Uint8Array.of(0, 1, 0, 0, 0, 0) });
    films.push(await tracer.film());
  }
  const [a, b] = films as [(typeof films)[0], (typeof films)[0]];
  expect(b.count).toEqual(a.count);
  expect([15, 16, 31, 32, 48 * 16 + 16].map((pixel) => b.count[pixel])).toEqual([8, 10, 10, 8, 8]);
  expect(shareApart(a.mean(), b.mean(), 1e-6)).toBeLessThan(0.02);
  expect(sum(b.mean()) / sum(a.mean())).toBeCloseTo(1, 2);
  expect(shareApart(a.meanDepth(), b.meanDepth(), 0)).toBeLessThan(0.005);
});

test('a model without a sampler', async () => {
  const [x, y, z] = BALL;
  const camera: Camera = { ...document.camera, fov: 30, position: [x, y, z + 5], target: [x, y, z] };
  const pictures = [];
  for (const tracer of [cpu, gpu]) {
    const film = await render(
      tracer,
      { ...document, camera },
      {
        samples: 8,
        width: 16,
        height: 16,
        maxDepth: 6,
      },
    );
    pictures.push(film.mean());
  }
  const [a, b] = pictures as [Float32Array, Float32Array];
  // The picture is of the ball: its middle is not its corner.
  const middle = 3 * (16 * 8 + 8);
  expect(a.slice(middle, middle + 3)).not.toEqual(a.slice(0, 3));
  expect(shareApart(a, b, 1e-6)).toBeLessThan(0.05);
  expect(sum(b) / sum(a)).toBeCloseTo(1, 2);
});

test('shadows on the ground', async () => {
  const [x, y, z] = BALL;
  const camera: Camera = {
    ...document.camera,
    fov: 40,
    position: [x, y + 2, z + 6],
    target: [x, y - 0.5, z],
  };
  const shaded = {
    ...document,
    background: { type: 'transparent' as const },
    ground: { shadowCatcher: true, height: y - 1, radius: 4, fade: 0.5, strength: 0.8 },
  };
  const scene = await packDocument(shaded);
  const films = [];
  for (const tracer of [cpu, gpu]) {
    await tracer.load(scene);
    films.push(
      await render(tracer, { ...shaded, camera }, { samples: 8, width: 32, height: 24, maxDepth: 1 }),
    );
  }
  const [a, b] = films as [(typeof films)[0], (typeof films)[0]];
  expect(a.shadow.filter((covered) => covered > 0).length).toBeGreaterThan(50);
  expect(shareApart(a.shadow, b.shadow, 1e-5)).toBeLessThan(0.02);
  expect(sum(b.shadow) / sum(a.shadow)).toBeCloseTo(1, 2);
  expect(sum(b.shadowSquares) / sum(a.shadowSquares)).toBeCloseTo(1, 2);
});
