import { Mesh, MeshBasicNodeMaterial, PerspectiveCamera, PlaneGeometry, Scene } from 'three/webgpu';
import { expect, it } from 'vitest';
import { uploadAhead } from '../../src/realtime/upload.ts';
import { testRenderer } from '../support/gpu.ts';

const { renderer, readCanvas } = await testRenderer(16, 16);

it('large geometries are put on the GPU buffer by buffer, each in a task, and not again by the frame', async () => {
  const scene = new Scene();
  // 512² vertices of 12 bytes, and of 8 for texture coordinates.
  const large = new Mesh(new PlaneGeometry(1, 1, 511, 511), new MeshBasicNodeMaterial({ color: 0xff0000 }));
  const small = new Mesh(new PlaneGeometry(), large.material);
  scene.add(large, small);
  const { backend } = renderer as unknown as {
    backend: { has(attribute: object): boolean; get(attribute: object): { buffer: GPUBuffer } };
  };
  const { attributes, index } = large.geometry;
  const all = [...Object.values(attributes), index as object];
  const there = () => all.filter((attribute) => backend.has(attribute));
  const tasks: number[] = [];
  await uploadAhead(renderer, [large, small, large], async () => void tasks.push(there().length));
  expect(tasks).toEqual([1, 2, 3, 4]);
  await uploadAhead(renderer, [large, small], async () => void tasks.push(0));
  expect(tasks).toHaveLength(4);
  const buffers = all.map((attribute) => backend.get(attribute).buffer);
  const camera = new PerspectiveCamera(20, 1, 0.1, 10);
  camera.position.z = 1;
  renderer.render(scene, camera);
  expect(all.every((attribute, i) => backend.get(attribute).buffer === buffers[i])).toBe(true);
  expect([...(await readCanvas())].slice(0, 4)).toEqual([255, 0, 0, 255]);
});
