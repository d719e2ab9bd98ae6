import * as THREE from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import type { Model } from '../../src/glsl/model.ts';
import { BrdfPointLight } from '../../src/lights/point-light.ts';
import { BrdfSpotLight } from '../../src/lights/spot-light.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';

/**
 * Objects that have not changed are not looked at again in the next frame. Whatever does change must be seen: a scene that
 * was drawn and then changed looks like one that was made so.
 */

const SIDE = 24;
const { renderer } = await testRenderer(SIDE, SIDE);
const target = new THREE.RenderTarget(SIDE, SIDE, { type: THREE.FloatType });

function createScene() {
  const material = new BrdfMaterial(shippedModels.get('principled') as Model, { roughness: 0.4 });
  const geometry = new THREE.SphereGeometry(0.5, 16, 12);
  geometry.computeTangents();
  const meshes = [-0.6, 0.6].map((x) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.position.x = x;
    return mesh;
  });
  const point = new BrdfPointLight(0xffffff, 10);
  point.position.set(1, 2, 3);
  const spot = new BrdfSpotLight(0xffffff, 20, 0.3, 2);
  spot.position.set(-1, 1, 3);
  const ambient = new THREE.AmbientLight(0xffffff, 0.5);
  const scene = new THREE.Scene();
  scene.add(...meshes, point, spot, spot.target, ambient);
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
  camera.position.z = 3;
  return { scene, camera, material, meshes, point, spot, ambient };
}
type Scene = ReturnType<typeof createScene>;

async function draw({ scene, camera }: Scene): Promise<Float32Array> {
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.setRenderTarget(null);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE);
  return Float32Array.from(pixels as Float32Array);
}

const changes: Record<string, (scene: Scene) => void> = {
  'a parameter': ({ material }) => material.set('roughness', 0.8),
  'a colour': ({ material }) => material.set('baseColor', [0.1, 0.8, 0.3]),
  'a colour in place': ({ material }) =>
    (material as unknown as { baseColor: THREE.Color }).baseColor.set(0x0000ff),
  'a parameter that turns tangents on': ({ material }) => material.set('anisotropic', 1).set('metallic', 1),
  'what it emits': ({ material }) => material.emissive.setRGB(0.2, 0.1, 0),
  'a place': ({ meshes }) => meshes[1]?.position.set(0.4, 0.3, 0),
  'a light’s intensity': ({ point }) => (point.intensity = 30),
  'a light’s falloff': ({ point }) => (point.falloff = 'constant'),
  'a light’s range': ({ point }) => (point.distance = 4),
  'a spot’s cut-off': ({ spot }) => (spot.angle = 0.1),
  'a spot’s exponent': ({ spot }) => (spot.exponent = 40),
  'ambient light': ({ ambient }) => (ambient.intensity = 2),
  'the camera': ({ camera }) => camera.position.set(1, 0, 3),
  'a term': ({ material }) => (material.term = 'specularLobe'),
};

describe('a change after some frames is seen', () => {
  it.each(Object.keys(changes))('%s', async (name) => {
    const changed = createScene();
    const before = await draw(changed);
    await draw(changed);
    changes[name]?.(changed);
    const after = await draw(changed);
    const fresh = createScene();
    changes[name]?.(fresh);
    expect(after).toEqual(await draw(fresh));
    expect(after).not.toEqual(before);
    // And it stays.
    expect(await draw(changed)).toEqual(after);
  });
});
