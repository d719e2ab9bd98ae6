import * as THREE from 'three/webgpu';
import {
  type Comparison,
  compareSphere,
  drawSurface,
  LIGHT_CASES,
  MATERIAL_CASES,
  SIZE,
  sphereGeometry,
} from './lit-sphere.ts';

export interface CaseResult extends Comparison {
  readonly material: string;
  readonly light: string;
}

/** Every material under every light, in a browser, on WebGPU or on WebGL 2. */
export default async function compareAll({
  forceWebGL,
}: {
  forceWebGL: boolean;
}): Promise<{ backend: string; results: CaseResult[] }> {
  const renderer = new THREE.WebGPURenderer({ forceWebGL, canvas: document.createElement('canvas') });
  await renderer.init();
  renderer.setSize(SIZE, SIZE, false);
  const geometry = sphereGeometry();
  const surfaces = await drawSurface(renderer, geometry);
  const results: CaseResult[] = [];
  for (const light of Object.keys(LIGHT_CASES)) {
    for (const material of Object.keys(MATERIAL_CASES)) {
      results.push({
        material,
        light,
        ...(await compareSphere(renderer, geometry, surfaces, material, light)),
      });
    }
  }
  const { backend } = renderer as unknown as { backend: { isWebGPUBackend?: boolean } };
  return { backend: backend.isWebGPUBackend ? 'webgpu' : 'webgl', results };
}
