import { Mesh } from 'three/webgpu';
import { afterAll, describe, expect, it } from 'vitest';
import { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { testRenderer } from '../support/gpu.ts';
import { CHANGES, compareRepeated, repeatedScene, SIZE } from './repeated.ts';

const { renderer: three } = await testRenderer(SIZE.width, SIZE.height);
const renderer = new RealtimeRenderer(three, { samples: 1, precision: 'float' });
afterAll(() => renderer.dispose());

describe('many meshes that are alike', () => {
  it('look the same drawn as instances, whatever changes, and take few calls', async () => {
    const found = await compareRepeated(renderer);
    expect(Object.keys(found)).toEqual(Object.keys(CHANGES));
    for (const { differing, mean, calls, single } of Object.values(found)) {
      // Edges of a few pixels are elsewhere by a rounding.
      expect(differing).toBeLessThan(0.02);
      expect(mean).toBeLessThan(2e-3);
      expect(calls).toBeLessThan(single / 4);
    }
  });

  it('are exact far from the origin', async () => {
    const { 'at first': found } = await compareRepeated(renderer, ['at first'], 1e5);
    expect(found?.mean).toBeLessThan(2e-3);
  });

  it('are found by what they share: geometry, material and being drawn as instances would be', () => {
    const { scene, meshes } = repeatedScene(true);
    const drawn = renderer.drawn(scene);
    const alone = drawn.filter((mesh) => meshes.includes(mesh));
    // Transparent ones and mirror images.
    expect(alone).toHaveLength(meshes.filter((_, i) => i % 20 === 7 || i % 11 === 5).length);
    // Three geometries of two materials.
    expect(drawn.length - alone.length).toBe(6);
    expect(renderer.drawn(scene)).toEqual(drawn);
    // The scene is what it was.
    expect(scene.children).toHaveLength(2);
    expect(meshes.every(({ layers, visible }) => layers.mask === 1 && visible)).toBe(true);
  });

  it('are drawn one by one where they are few', () => {
    const { scene, meshes } = repeatedScene(true);
    for (const mesh of meshes.slice(250)) mesh.visible = false;
    expect(renderer.drawn(scene)).toEqual(meshes.slice(0, 250));
    expect(renderer.drawn(scene).every((mesh) => mesh.constructor === Mesh)).toBe(true);
  });
});
