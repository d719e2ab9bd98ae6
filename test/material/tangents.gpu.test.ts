import * as THREE from 'three/webgpu';
import { expect, test } from 'vitest';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, modelNamed, SIZE } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const light = new THREE.DirectionalLight(0xffffff, 3);
light.position.set(1, 2, 2);

const sphere = () => new THREE.SphereGeometry(1, 64, 48);
const brushed = () =>
  new BrdfMaterial(modelNamed('principled'), { metallic: 1, anisotropic: 0.9, roughness: 0.4 });

/** The mean difference of two pictures, relative to the mean of the second. */
function difference(a: Float32Array, b: Float32Array): number {
  let [sum, mean] = [0, 0];
  for (let i = 0; i < a.length; i++) {
    sum += Math.abs((a[i] as number) - (b[i] as number));
    mean += b[i] as number;
  }
  return sum / mean;
}

const withTangents = sphere();
withTangents.computeTangents();
const reference = await drawSphere(renderer, withTangents, brushed(), [light]);

test('a mesh is given the tangents of its texture coordinates as soon as they matter', async () => {
  const geometry = sphere();
  await drawSphere(renderer, geometry, brushed(), [light]);
  expect(geometry.hasAttribute('tangent')).toBe(true);
  const second = await drawSphere(renderer, geometry, brushed(), [light]);
  expect(difference(second, reference)).toBe(0);
});

test('so is one whose triangles list their vertices', async () => {
  const geometry = sphere().toNonIndexed();
  await drawSphere(renderer, geometry, brushed(), [light]);
  expect(geometry.hasAttribute('tangent')).toBe(true);
  expect(geometry.index).toBeNull();
  const second = await drawSphere(renderer, geometry, brushed(), [light]);
  expect(difference(second, reference)).toBeLessThan(1e-5);
});

test('an isotropic material leaves its mesh alone', async () => {
  const geometry = sphere();
  await drawSphere(renderer, geometry, new BrdfMaterial(modelNamed('principled')), [light]);
  expect(geometry.hasAttribute('tangent')).toBe(false);
});

test('without texture coordinates the tangent runs around the y axis, which on this sphere is the same', async () => {
  const geometry = sphere();
  geometry.deleteAttribute('uv');
  const picture = await drawSphere(renderer, geometry, brushed(), [light]);
  expect(difference(picture, reference)).toBeLessThan(0.01);
  const isotropic = new BrdfMaterial(modelNamed('principled'), { metallic: 1, roughness: 0.4 });
  expect(difference(await drawSphere(renderer, geometry, isotropic, [light]), reference)).toBeGreaterThan(
    0.1,
  );
});

test('one object that turns anisotropic while it is drawn gets its tangents in the next frame', async () => {
  const geometry = sphere();
  const material = new BrdfMaterial(modelNamed('principled'), { metallic: 1, roughness: 0.4 });
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(geometry, material), light);
  const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 10);
  camera.position.z = 3.2;
  const target = new THREE.RenderTarget(SIZE, SIZE, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  material.set('anisotropic', 0.9);
  for (let frame = 0; frame < 2; frame++) renderer.render(scene, camera);
  renderer.setRenderTarget(null);
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE);
  expect(difference(pixels as Float32Array, reference)).toBeLessThan(1e-4);
});

test('the axis that stands in for tangents stays with its object when the camera moves', async () => {
  const material = brushed();
  const [looked, fresh] = [0, 1].map(() => {
    const geometry = sphere();
    geometry.deleteAttribute('uv');
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(geometry, material), light.clone());
    return scene;
  }) as [THREE.Scene, THREE.Scene];
  const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 10);
  const target = new THREE.RenderTarget(SIZE, SIZE, { type: THREE.FloatType });
  const draw = async (scene: THREE.Scene) => {
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    return (await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE)) as Float32Array;
  };
  camera.position.z = 3.2;
  const before = Float32Array.from(await draw(looked));
  camera.position.set(1, 2, 2.3);
  camera.lookAt(0, 0, 0);
  const after = Float32Array.from(await draw(looked));
  expect(difference(after, before)).toBeGreaterThan(0.1);
  expect(difference(after, Float32Array.from(await draw(fresh)))).toBe(0);
});
