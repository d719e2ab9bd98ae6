import * as THREE from 'three/webgpu';
import { expect, test } from 'vitest';
import { writeCamera, writeSettings } from '../../../src/pathtracer/scene/camera.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import type { Camera } from '../../../src/scene/schema.ts';
import { Reader } from './reader.ts';

const cameraOf = (fields: object): Camera =>
  parseDocument({ format: 'irradia', version: 1, camera: fields }, 'test').camera;

function written(camera: Camera, width: number, height: number): Reader {
  const words = new Uint32Array(128);
  writeCamera(words, camera, { width, height });
  return new Reader({ words });
}

test.each([
  [
    [1, 2, 3],
    [0, 0.5, -1],
  ],
  [
    [0, 5, 0],
    [0, 0, 0],
  ],
  [
    [0, 0, 0],
    [0, 0, 0],
  ],
])('a pixel’s ray from %j to %j is that of three.js’s camera', (position, target) => {
  const [width, height] = [200, 100];
  const camera = cameraOf({ position, target, fov: 40 });
  const reader = written(camera, width, height);
  const three = new THREE.PerspectiveCamera(40, width / height);
  three.position.fromArray(position);
  three.lookAt(...(target as [number, number, number]));
  three.updateMatrixWorld();
  const [right, up, forward] = [18, 19, 20].map((slot) => reader.float4(slot).slice(0, 3));
  for (const [x, y] of [
    [0, 0],
    [1, 1],
    [-1, 0.5],
  ] as const) {
    const ray = right!.map((r, i) => forward![i]! + x * r + y * up![i]!);
    const expected = new THREE.Vector3(x, y, 0.5).unproject(three).sub(three.position).normalize();
    const length = Math.hypot(...ray);
    for (const [i, value] of expected.toArray().entries()) expect(ray[i]! / length).toBeCloseTo(value, 5);
  }
});

test('the lens is a photographer’s: focal length over f-number, in focus at the target or where it is told', () => {
  // 50 mm before a picture 24 mm high.
  const fov = (2 * Math.atan(12 / 50) * 180) / Math.PI;
  const place = { position: [0, 0, 3], target: [0, 0, 1], fov };
  const wide = written(cameraOf({ ...place, fStop: 2, apertureBlades: 6 }), 10, 10);
  expect(wide.float4(17)[3]).toBeCloseTo(0.0125, 6);
  expect(wide.float4(18)[3]).toBe(2);
  expect(wide.float4(19)[3]).toBe(6);
  const told = written(cameraOf({ ...place, focusDistance: 7, apertureBlades: 2 }), 10, 10);
  expect([17, 18, 19].map((slot) => told.float4(slot)[3])).toEqual([0, 7, 0]);
});

test('settings', () => {
  const words = new Uint32Array(128);
  writeSettings(words, { width: 3, height: 2, maxDepth: 8, seed: 5, strategy: 'light', clamp: 0.5 });
  const reader = new Reader({ words });
  expect(reader.uint4(16)).toEqual([3, 2, 8, 5]);
  expect(reader.uint4(21)).toEqual([2, 0, 0, 0]);
  expect(reader.float4(22)).toEqual([0.5, 0, 0, 0]);
});
