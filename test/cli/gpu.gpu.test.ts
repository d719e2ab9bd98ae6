import { Mesh, MeshBasicNodeMaterial, OrthographicCamera, PlaneGeometry, Scene } from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { requestGpu } from '../../src/cli/gpu.ts';
import { testGpu, testRenderer } from '../support/gpu.ts';

const { device } = await testGpu();

describe('the GPU in Node', () => {
  test('runs a compute shader that adds numbers', async () => {
    const input = new Float32Array([1, 2.5, -3, 1e20]);
    const buffer = device.createBuffer({
      size: input.byteLength,
      usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC | GPUBufferUsage.COPY_DST,
    });
    const result = device.createBuffer({
      size: input.byteLength,
      usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
    });
    device.queue.writeBuffer(buffer, 0, input);
    const code = `
      @group(0) @binding(0) var<storage, read_write> data: array<f32>;
      @compute @workgroup_size(4) fn main(@builtin(global_invocation_id) id: vec3u) {
        data[id.x] += data[id.x];
      }`;
    const pipeline = await device.createComputePipelineAsync({
      layout: 'auto',
      compute: { module: device.createShaderModule({ code }) },
    });
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    const entries = [{ binding: 0, resource: { buffer } }];
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
    pass.dispatchWorkgroups(1);
    pass.end();
    encoder.copyBufferToBuffer(buffer, result);
    device.queue.submit([encoder.finish()]);
    await result.mapAsync(GPUMapMode.READ);
    expect([...new Float32Array(result.getMappedRange())]).toEqual([2, 5, -6, Math.fround(2e20)]);
  });

  test('reports an error that nobody awaited', async () => {
    let onFatal: (message: string) => void = () => {};
    const message = new Promise<string>((resolve) => {
      onFatal = resolve;
    });
    const { device } = await requestGpu({ device: 'software', onFatal: (text) => onFatal(text) });
    device.createBuffer({ size: 4, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.MAP_WRITE });
    expect(await message).toContain('GPU error');
    // Until here it must not be collected as garbage.
    device.destroy();
  });
});

describe('three.js in Node', async () => {
  const { renderer, readCanvas } = await testRenderer(61, 32);

  test('draws to the canvas, rows from the top', async () => {
    const scene = new Scene();
    const camera = new OrthographicCamera(-1, 1, 1, -1, 0, 2);
    const material = new MeshBasicNodeMaterial({ color: 0xff8000 });
    const upperHalf = new Mesh(new PlaneGeometry(2, 1), material);
    upperHalf.position.set(0, 0.5, -1);
    scene.add(upperHalf);
    renderer.render(scene, camera);
    const pixels = await readCanvas();
    const at = (x: number, y: number) => [...pixels.subarray((y * 61 + x) * 4, (y * 61 + x) * 4 + 4)];
    expect(pixels).toHaveLength(61 * 32 * 4);
    expect(at(60, 3)).toEqual([255, 128, 0, 255]);
    expect(at(60, 28)).toEqual([0, 0, 0, 0]);
  });
});
