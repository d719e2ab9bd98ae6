/**
 * The frame of 20 spheres under 4 lights, with Irradia's materials and with three.js' own, on one renderer.
 * The variants take turns, one frame each, so that whatever else the machine does hits all alike.
 */
import * as THREE from 'three/webgpu';
import { shippedModels } from '../models/index.ts';
import type { Model } from '../src/glsl/model.ts';
import { BrdfMaterial } from '../src/material/brdf-material.ts';

export interface SpheresRequest {
  forceWebGL: boolean;
  frames: number;
}

export interface SpheresResult {
  backend: 'webgpu' | 'webgl';
  /** Milliseconds of each frame, by variant. */
  times: Record<string, number[]>;
}

const WIDTH = 640;
const HEIGHT = 360;

const principled = shippedModels.get('principled') as Model;

const MATERIALS: Record<string, (() => THREE.Material) | null> = {
  empty: null,
  principled: () => new BrdfMaterial(principled),
  physical: () => new THREE.MeshPhysicalNodeMaterial(),
  'principled, all lobes': () =>
    new BrdfMaterial(principled, { clearcoat: 1, sheen: 1, anisotropic: 0.5, roughness: 0.4 }),
  'physical, all lobes': () =>
    Object.assign(new THREE.MeshPhysicalNodeMaterial(), {
      clearcoat: 1,
      sheen: 1,
      anisotropy: 0.5,
      roughness: 0.4,
    }),
};

export default async function spheres({ forceWebGL, frames }: SpheresRequest): Promise<SpheresResult> {
  const renderer = new THREE.WebGPURenderer({ forceWebGL });
  await renderer.init();
  renderer.setSize(WIDTH, HEIGHT, false);
  document.body.append(renderer.domElement);
  const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0, 0, 6.5);

  const scenes = Object.entries(MATERIALS).map(([name, make]) => ({
    name,
    scene: createScene(make),
    times: [] as number[],
  }));
  const frame = async (scene: THREE.Scene): Promise<number> => {
    const start = performance.now();
    renderer.render(scene, camera);
    await finished(renderer);
    return performance.now() - start;
  };
  // The first frames compile; they are a matter of their own.
  for (const { scene } of scenes) for (let i = 0; i < 2; i++) await frame(scene);
  for (let i = 0; i < frames; i++) {
    for (const { scene, times } of scenes) times.push(await frame(scene));
  }
  const backend = 'isWebGPUBackend' in renderer.backend ? 'webgpu' : 'webgl';
  return { backend, times: Object.fromEntries(scenes.map(({ name, times }) => [name, times])) };
}

function createScene(make: (() => THREE.Material) | null): THREE.Scene {
  const scene = new THREE.Scene();
  const key = new THREE.DirectionalLight(0xffffff, 2);
  key.position.set(2, 3, 4);
  const fill = new THREE.DirectionalLight(0xffffff, 0.5);
  fill.position.set(-3, 1, 2);
  const point = new THREE.PointLight(0xffffff, 20);
  point.position.set(-2, 2, 3);
  const spot = new THREE.SpotLight(0xffffff, 40, 0, 0.5, 0.3);
  spot.position.set(3, 3, 4);
  scene.add(key, fill, point, spot, spot.target);
  if (!make) return scene;
  const geometry = new THREE.SphereGeometry(0.5, 64, 32);
  const material = make();
  for (let i = 0; i < 20; i++) {
    const sphere = new THREE.Mesh(geometry, material);
    sphere.position.set(((i % 5) - 2) * 1.3, (Math.floor(i / 5) - 1.5) * 1.3, 0);
    scene.add(sphere);
  }
  return scene;
}

/** When the GPU is done with what was submitted. */
async function finished(renderer: THREE.WebGPURenderer): Promise<void> {
  const { device, gl } = renderer.backend as { device?: GPUDevice; gl?: WebGL2RenderingContext };
  if (device) await device.queue.onSubmittedWorkDone();
  // A pixel can be read only when it is drawn.
  else gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}
