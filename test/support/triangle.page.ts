import {
  BufferAttribute,
  BufferGeometry,
  Mesh,
  MeshBasicNodeMaterial,
  OrthographicCamera,
  RenderTarget,
  Scene,
  WebGPURenderer,
} from 'three/webgpu';

/** Draws a triangle that covers the lower left half of 8x8 pixels; returns the back end and the pixels. */
export default async function drawTriangle({ forceWebGL }: { forceWebGL: boolean }) {
  const renderer = new WebGPURenderer({ forceWebGL });
  await renderer.init();
  const geometry = new BufferGeometry();
  geometry.setAttribute(
    'position',
    new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0]), 3),
  );
  const scene = new Scene();
  scene.add(new Mesh(geometry, new MeshBasicNodeMaterial({ color: 0x00ff00 })));
  const target = new RenderTarget(8, 8);
  renderer.setRenderTarget(target);
  renderer.render(scene, new OrthographicCamera(-1, 1, 1, -1, -1, 1));
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 8, 8);
  const isWebGPU = 'isWebGPUBackend' in renderer.backend;
  renderer.dispose();
  return { backend: isWebGPU ? 'webgpu' : 'webgl', green: Array.from(pixels).filter((_, i) => i % 4 === 1) };
}
