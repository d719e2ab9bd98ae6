import * as THREE from 'three/webgpu';
import { expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import type { Model } from '../../src/glsl/model.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';

const SIDE = 16;
const renderers = [(await testRenderer(SIDE, SIDE)).renderer, (await testRenderer(SIDE, SIDE)).renderer];

const scene = new THREE.Scene();
const material = new BrdfMaterial(shippedModels.get('principled') as Model, { roughness: 0.3, metallic: 1 });
scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12), material), new THREE.AmbientLight(0xffffff, 1));
const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
camera.position.z = 3;

async function centre(renderer: THREE.WebGPURenderer): Promise<number> {
  const target = new THREE.RenderTarget(SIDE, SIDE, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const pixels = (await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE)) as Float32Array;
  renderer.setRenderTarget(null);
  target.dispose();
  return pixels[4 * (SIDE * (SIDE / 2) + SIDE / 2)] as number;
}

it('one material is drawn alike by two renderers, before and after a change', async () => {
  const [a, b] = renderers as [THREE.WebGPURenderer, THREE.WebGPURenderer];
  const first = await centre(a);
  expect(first).toBeGreaterThan(0.1);
  expect(await centre(b)).toBe(first);
  material.set('metallic', 0);
  const changed = await centre(b);
  expect(Math.abs(changed - first)).toBeGreaterThan(0.01);
  expect(await centre(a)).toBe(changed);
});
