import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { buildBinaryTree } from '../../../src/pathtracer/scene/binary-tree.ts';
import { packMesh } from '../../../src/pathtracer/scene/mesh.ts';
import { Pace } from '../../../src/pathtracer/scene/pace.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { widen } from '../../../src/pathtracer/scene/wide-tree.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { addableGeometries } from '../../../src/scene/geometry-schema.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { intersect, Reader, sequence, unitVector, type Vector } from './reader.ts';

const assets = new AssetLoader(nodeAssets);

const scene = (objects: Record<string, object>): Document =>
  parseDocument(
    {
      format: 'irradia',
      version: 1,
      materials: { m: { model: 'principled' } },
      objects: Object.fromEntries(Object.entries(objects).map(([id, o]) => [id, { material: 'm', ...o }])),
    },
    'test',
  );

/** The mirror's triangles, in the world, object by object. */
async function worldTriangles(document: Document): Promise<Float64Array[]> {
  const mirror = new SceneMirror({
    assets,
    onError: (message) => {
      throw new Error(message);
    },
  });
  mirror.apply(document);
  await mirror.settled();
  return Object.keys(document.objects).map((id) => {
    const { geometry, ...mesh } = mirror.objectFor(id)!;
    const matrix = new THREE.Matrix4().compose(mesh.position, mesh.quaternion, mesh.scale);
    const position = geometry.getAttribute('position');
    const count = geometry.index?.count ?? position.count;
    const corners = new Float64Array(3 * count);
    for (let i = 0; i < count; i += 1) {
      const p = new THREE.Vector3().fromBufferAttribute(position, geometry.index?.getX(i) ?? i);
      corners.set(p.applyMatrix4(matrix).toArray(), 3 * i);
    }
    return corners;
  });
}

/** Casts rays through the packed trees and through every triangle. @returns how many rays hit */
async function compare(document: Document, rays: number, seed: number): Promise<number> {
  const reader = new Reader(await new ScenePacker(assets).pack(document));
  const meshes = await worldTriangles(document);
  const box = new THREE.Box3();
  for (const corners of meshes) box.union(new THREE.Box3().setFromArray(corners));
  const sphere = box.getBoundingSphere(new THREE.Sphere());
  const random = sequence(seed);
  let hits = 0;
  for (let ray = 0; ray < rays; ray += 1) {
    const around = (scale: number): THREE.Vector3 =>
      new THREE.Vector3(...unitVector(random)).multiplyScalar(scale * sphere.radius).add(sphere.center);
    const from = around(ray % 3 === 0 ? 0.5 * random() : 2);
    const direction = around(0.7 * random())
      .sub(from)
      .normalize()
      .toArray() as Vector;
    const origin = from.toArray() as Vector;
    let nearest = Number.POSITIVE_INFINITY;
    for (const corners of meshes)
      for (let at = 0; at < corners.length; at += 9) {
        const corner = (i: number) => [...corners.subarray(at + 3 * i, at + 3 * i + 3)] as Vector;
        const distance = intersect(origin, direction, corner(0), corner(1), corner(2));
        if (distance !== null && distance < nearest) nearest = distance;
      }
    const hit = reader.trace(origin, direction);
    expect(Number.isFinite(nearest), `ray ${ray} hits`).toBe(hit !== null);
    if (hit === null) continue;
    hits += 1;
    expect(Math.abs(hit.distance - nearest)).toBeLessThan(2e-5 * sphere.radius);
    // The triangle's number is that of the geometry's index.
    const at = 9 * hit.triangle;
    const corners = meshes[hit.instance]!;
    const points = [0, 3, 6].map((i) => [...corners.subarray(at + i, at + i + 3)] as Vector);
    const own = intersect(origin, direction, points[0]!, points[1]!, points[2]!);
    if (own !== null) expect(Math.abs(own - hit.distance)).toBeLessThan(2e-5 * sphere.radius);
  }
  return hits;
}

describe('a ray through the packed trees hits what is nearest of all triangles', () => {
  test.each(addableGeometries)('%s', async (type) => {
    const fewer = type === 'torus' ? { radialSegments: 12, tubularSegments: 24 } : {};
    const hits = await compare(scene({ o: { geometry: { type, ...fewer } } }), 30, 1);
    expect(hits).toBeGreaterThan(3);
  });

  test('objects that are turned, stretched, mirrored, and that share a mesh', async () => {
    const geometry = { type: 'sphere', widthSegments: 12, heightSegments: 8 };
    const document = scene({
      a: { geometry, position: [1, 0, 0], rotation: [10, 20, 30] },
      b: { geometry, position: [-1, 0.3, 0], rotation: [200, 0, 45], scale: [-1, 2, 0.5] },
      c: { geometry: { type: 'box' }, position: [0, 1, -1], scale: [-1, -1, -0.1] },
      d: { geometry: { type: 'plane' }, position: [0, -1, 0], rotation: [-90, 0, 0], scale: [3, 3, 1] },
      e: { geometry: { type: 'plane' }, position: [0, -2, 0], rotation: [-90, 0, 0], scale: [3, 3, 0] },
    });
    const hits = await compare(document, 300, 2);
    expect(hits).toBeGreaterThan(100);
    const reader = new Reader(await new ScenePacker(assets).pack(document));
    const parts = [0, 1, 2, 3, 4].map((i) => reader.uint4(reader.instance(i) + 6));
    expect(parts.map((part) => part[2])).toEqual([0, 1, 1, 0, 0]);
    expect(parts[0]![0]).toBe(parts[1]![0]);
    expect(parts[3]![0]).toBe(parts[4]![0]);
    expect(new Set(parts.map((part) => part[0])).size).toBe(3);
  });

  test('thousands of objects', async () => {
    const random = sequence(3);
    const objects = Object.fromEntries(
      Array.from({ length: 2000 }, (_, i) => [
        `o${i}`,
        {
          geometry: { type: 'plane' },
          position: [20 * random(), 20 * random(), 20 * random()],
          rotation: [360 * random(), 360 * random(), 0],
        },
      ]),
    );
    expect(await compare(scene(objects), 20, 4)).toBeGreaterThan(10);
  });
});

test('a mesh’s vertices: normals, tangents with their side, and all sets of texture coordinates', async () => {
  const pace = new Pace();
  const geometry = new THREE.BufferGeometry();
  const set = (name: string, size: number, values: number[]) =>
    geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(values), size));
  set('position', 3, [0, 0, 0, 1, 0, 0, 0, 1, 0]);
  // u runs backwards: a mirrored image.
  set('uv', 2, [1, 0, 0, 0, 1, 1]);
  set('uv1', 2, [0.25, 0.5, 0, 0, 0, 0]);
  set('uv3', 2, [0, 0, 0.75, 0.125, 0, 0]);
  const { words, vertexSlots } = await packMesh(geometry, 2 ** 32, pace);
  pace.end();
  const floats = new Float32Array(words.buffer);
  const [, vertices, indices] = words as unknown as [number, number, number];
  expect(vertexSlots).toBe(4);
  expect([...floats.subarray(4 * vertices, 4 * vertices + 16)]).toEqual(
    // Normal and u, tangent of length 2 and v, then (u1, v1, u2, v2) and (u3, v3).
    [0, 0, 1, 1, -2, 0, 0, 0, 0.25, 0.5, 0, 0, 0, 0, 0, 0],
  );
  expect([...floats.subarray(4 * vertices + 28, 4 * vertices + 32)]).toEqual([0.75, 0.125, 0, 0]);
  expect([...words.subarray(indices, indices + 3)]).toEqual([0, 1, 2]);
});

test('boxes in geometric progression, or all in one place, make no deep tree', async () => {
  const pace = new Pace();
  const progression = Float32Array.from({ length: 6 * 200 }, (_, i) => 1.5 ** (Math.floor(i / 6) - 150));
  const same = new Float32Array(6 * 5000).fill(1);
  for (const boxes of [progression, same]) {
    const items = boxes.length / 6;
    const tree = await buildBinaryTree(boxes, 4, pace);
    const { stack } = widen(tree);
    expect(stack).toBeLessThanOrEqual(96);
    expect([...tree.order].sort((a, b) => a - b)).toEqual(Array.from({ length: items }, (_, i) => i));
    expect(Math.max(...tree.count)).toBe(4);
  }
  pace.end();
});
