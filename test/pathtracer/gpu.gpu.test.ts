import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import type { Film } from '../../src/pathtracer/film.ts';
import { GpuPathTracer } from '../../src/pathtracer/gpu/gpu-path-tracer.ts';
import { parseDocument } from '../../src/scene/document.ts';
import { testGpu } from '../support/gpu.ts';
import { packDocument, render, testTracer } from './tracer.ts';

/**
 * Both machines run one kernel on the same random numbers. Rounding sends a few paths another way, so single samples
 * may differ: nearly all pixels must agree to rounding, and the pictures' means in what noise leaves.
 */
test('WGSL = WebAssembly', async () => {
  const document = parseDocument(readFileSync('scenes/thesis.json', 'utf8'), 'thesis.json');
  const packed = await packDocument(document);
  const { device } = await testGpu();
  const tracers = [testTracer(), new GpuPathTracer(device, 'test')] as const;
  const films: Film[] = [];
  for (const tracer of tracers) {
    await tracer.load(packed);
    await render(tracer, document, { samples: 8, width: 48, height: 32, maxDepth: 4 });
    // Two more of the tile in the middle of the upper row.
    await tracer.render(8, 2, { tiles: Uint8Array.of(0, 1, 0, 0, 0, 0) });
    films.push(await tracer.film());
    tracer.dispose();
  }
  const [cpu, gpu] = films.map((film) => film.mean()) as [Float32Array, Float32Array];
  expect(films[1]!.count).toEqual(films[0]!.count);
  expect([15, 16, 31, 32, 48 * 16 + 16].map((pixel) => films[1]!.count[pixel])).toEqual([8, 10, 10, 8, 8]);
  const far = cpu.filter((x, i) => Math.abs(x - gpu[i]!) > 1e-3 * x + 1e-6).length;
  expect(far / cpu.length).toBeLessThan(0.02);
  const sum = (values: Float32Array) => values.reduce((a, b) => a + b, 0);
  expect(sum(gpu) / sum(cpu)).toBeCloseTo(1, 2);
  const [a, b] = films.map((film) => film.meanDepth()) as [Float32Array, Float32Array];
  expect(a.filter((x, i) => Math.abs(x - b[i]!) > 1e-3 * x).length / a.length).toBeLessThan(0.005);
});
