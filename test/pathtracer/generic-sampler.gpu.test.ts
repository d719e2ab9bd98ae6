import { expect, test } from 'vitest';
import { GpuPathTracer } from '../../src/pathtracer/gpu/gpu-path-tracer.ts';
import { testGpu } from '../support/gpu.ts';
import { textWithoutSampler } from './generic.ts';
import { evenLight, material, scene } from './scenes.ts';
import { packDocument, render, testTracer } from './tracer.ts';

test('models without a sampler: WGSL = WebAssembly', async () => {
  const document = scene({
    ...evenLight,
    camera: { fov: 30, position: [0, 0, 5], target: [0, 0, 0] },
    objects: { s: { name: 's', material: 'm', geometry: { type: 'sphere', radius: 1 } } },
    models: { glass: { source: textWithoutSampler('dielectric') } },
    materials: { m: material('glass', { roughness: 0.3 }) },
  });
  const packed = await packDocument(document);
  const { device } = await testGpu();
  const pictures = [];
  for (const tracer of [testTracer(), new GpuPathTracer(device, 'test')]) {
    await tracer.load(packed);
    const film = await render(tracer, document, { samples: 8, width: 16, height: 16, maxDepth: 6 });
    pictures.push(film.mean());
    tracer.dispose();
  }
  const [cpu, gpu] = pictures as [Float32Array, Float32Array];
  // Rounding sends a few paths another way.
  const far = cpu.filter((x, i) => Math.abs(x - gpu[i]!) > 1e-3 * x + 1e-6).length;
  expect(far / cpu.length).toBeLessThan(0.05);
  const sum = (values: Float32Array) => values.reduce((a, b) => a + b, 0);
  expect(sum(gpu) / sum(cpu)).toBeCloseTo(1, 2);
});
