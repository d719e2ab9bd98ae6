import * as THREE from 'three/webgpu';
import { describe, expect, test, vi } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { testRenderer } from '../support/gpu.ts';
import { drawSphere, modelNamed, SIZE, sphereGeometry } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const geometry = sphereGeometry();
const light = new THREE.DirectionalLight(0xffffff, 3);
light.position.set(1, 2, 2);
const white = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
white.needsUpdate = true;

/** The largest difference of two pictures, relative to the second or, where that is less, to 1e-3. */
function worst(a: Float32Array, b: Float32Array): number {
  return b.reduce((most, x, i) => Math.max(most, Math.abs((a[i] as number) - x) / Math.max(x, 1e-3)), 0);
}

describe.each([...shippedModels.keys()])('%s, plain and with textures in one renderer', (name) => {
  const model = shippedModels.get(name) as NonNullable<ReturnType<typeof shippedModels.get>>;

  test('a white texture on any parameter changes nothing', async () => {
    const draw = (material: BrdfMaterial) => drawSphere(renderer, geometry, material, [light]);
    const plain = await draw(new BrdfMaterial(model));
    expect(Math.max(...plain)).toBeGreaterThan(0.1);
    for (const parameter of model.parameters) {
      const material = new BrdfMaterial(model).setMap(parameter.name, white);
      expect(worst(await draw(material), plain), parameter.name).toBeLessThan(1e-3);
      material.dispose();
    }
    // What the textures brought into the shader language's global names does not stay.
    expect(worst(await draw(new BrdfMaterial(model)), plain)).toBe(0);
  });
});

test('a map may be taken off while the shader that reads it is compiled', async () => {
  const said = vi.spyOn(console, 'error');
  const model = modelNamed('lambert');
  const material = new BrdfMaterial(model).setMap('albedo', white);
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(), material), new THREE.DirectionalLight());
  const compiled = renderer.compileAsync(scene, new THREE.PerspectiveCamera());
  material.setMap('albedo', null);
  await compiled;
  expect(said).not.toHaveBeenCalled();
  said.mockRestore();
});
