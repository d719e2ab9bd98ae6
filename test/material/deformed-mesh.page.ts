import * as THREE from 'three/webgpu';
import { compareDeformed, type DeformedResult } from './deformed-mesh.ts';
import { SIZE } from './lit-sphere.ts';

/** The deformed meshes in a browser, on WebGPU or on WebGL 2. */
export default async function compareInBrowser({
  forceWebGL,
}: {
  forceWebGL: boolean;
}): Promise<DeformedResult[]> {
  const renderer = new THREE.WebGPURenderer({ forceWebGL, canvas: document.createElement('canvas') });
  await renderer.init();
  renderer.setSize(SIZE, SIZE, false);
  return compareDeformed(renderer);
}
