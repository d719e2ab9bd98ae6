import * as THREE from 'three/webgpu';
import { type AlbedoCurve, BROAD_LIGHTS, compareBroad } from './broad-light.ts';
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

export interface Order {
  readonly forceWebGL: boolean;
  /** Of the materials that are compared under light from everywhere. */
  readonly curves: Readonly<Record<string, AlbedoCurve>>;
}

/** Every material under every light, in a browser, on WebGPU or on WebGL 2. */
export default async function compareAll({
  forceWebGL,
  curves,
}: Order): Promise<{ backend: string; results: CaseResult[] }> {
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
  for (const light of Object.keys(BROAD_LIGHTS)) {
    for (const [material, curve] of Object.entries(curves)) {
      results.push({
        material,
        light,
        ...(await compareBroad(renderer, geometry, surfaces, material, light, curve)),
      });
    }
  }
  const { backend } = renderer as unknown as { backend: { isWebGPUBackend?: boolean } };
  return { backend: backend.isWebGPUBackend ? 'webgpu' : 'webgl', results };
}
