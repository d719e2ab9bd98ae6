/** EXT_mesh_gpu_instancing: each copy of a mesh is an object. */
import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { writeGlb } from '../../src/io/gltf/glb.ts';
import { bring, type Json } from './gltf-files.ts';

/** A triangle with copies: two places as floats, two turns as normalised bytes that lie 8 bytes apart. */
function file(attributes: Json = { TRANSLATION: 1, ROTATION: 2 }, changes: Json = {}): Uint8Array {
  const binary = new Uint8Array(36 + 24 + 16);
  binary.set(new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer));
  binary.set(new Uint8Array(Float32Array.of(1, 2, 3, -4, 5, 6).buffer), 36);
  // Half a turn about y, then none; what lies between is another turn.
  binary.set(new Uint8Array(Int8Array.of(0, 127, 0, 0, 127, 0, 0, 0, 0, 0, 0, 127).buffer), 60);
  return writeGlb(
    {
      asset: { version: '2.0' },
      scenes: [{ nodes: [0] }],
      nodes: [
        {
          name: 'Tree',
          mesh: 0,
          translation: [10, 0, 0],
          extensions: { EXT_mesh_gpu_instancing: { attributes } },
        },
      ],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [
        { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' },
        { bufferView: 1, componentType: 5126, count: 2, type: 'VEC3' },
        { bufferView: 2, componentType: 5120, normalized: true, count: 2, type: 'VEC4' },
      ],
      bufferViews: [
        { buffer: 0, byteOffset: 0, byteLength: 36 },
        { buffer: 0, byteOffset: 36, byteLength: 24 },
        { buffer: 0, byteOffset: 60, byteLength: 12, byteStride: 8 },
      ],
      buffers: [{ byteLength: binary.length }],
      ...changes,
    },
    binary,
  );
}

describe('instances of a mesh', () => {
  test('are objects of one geometry, each where it stands on the node', async () => {
    const { document, notes } = await bring(file());
    const objects = Object.values(document.objects);
    expect(objects.map(({ name, position }) => [name, ...position])).toEqual([
      ['Tree', 11, 2, 3],
      ['Tree 2', 6, 5, 6],
    ]);
    const [x, y, z] = objects[0]!.rotation.map(THREE.MathUtils.degToRad) as [number, number, number];
    const turned = new THREE.Vector3(1, 2, 3).applyEuler(new THREE.Euler(x, y, z));
    expect(turned.distanceTo(new THREE.Vector3(-1, 2, -3))).toBeLessThan(1e-5);
    expect(objects[1]!.rotation.every((angle) => Math.abs(angle) < 1e-9)).toBe(true);
    expect(objects.map(({ geometry }) => geometry)).toEqual([objects[0]!.geometry, objects[0]!.geometry]);
    // Whatever else they have, such as colours of their own, is no place.
    expect(notes).toEqual([]);
  });

  test('are one object, with a note, where they are compressed', async () => {
    const { document, notes } = await bring(
      file(
        { TRANSLATION: 1 },
        {
          bufferViews: [
            { buffer: 0, byteOffset: 0, byteLength: 36 },
            { buffer: 0, byteOffset: 36, byteLength: 24, extensions: { EXT_other: {} } },
            { buffer: 0, byteOffset: 60, byteLength: 12 },
          ],
        },
      ),
    );
    expect(Object.keys(document.objects)).toHaveLength(1);
    expect(notes).toContain('Tree: its instances are compressed; only one of them is shown');
  });

  const accessor = { bufferView: 1, componentType: 5126, count: 2, type: 'VEC3' };
  const position = { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' };
  test.each<[string, Json, Json, string]>([
    ['no accessor', { TRANSLATION: 9 }, {}, 'accessors[9] is not a VEC3'],
    ['another type', { ROTATION: 1 }, {}, 'accessors[1] is not a VEC4'],
    ['not equally many', { TRANSLATION: 0, SCALE: 1 }, {}, 'its attributes are not equally many'],
    [
      'too many',
      { TRANSLATION: 1 },
      { accessors: [position, { componentType: 5126, count: 20_001, type: 'VEC3' }] },
      '20001 instances; at most 20000',
    ],
    [
      'beyond the buffer',
      { TRANSLATION: 1 },
      { accessors: [position, { ...accessor, count: 3 }] },
      'accessors[1]: bytes 0 to 36 lie beyond the 24 bytes there are',
    ],
  ])('with %s are refused', async (_, attributes, changes, message) => {
    await expect(bring(file(attributes, changes))).rejects.toThrow(message);
  });
});
