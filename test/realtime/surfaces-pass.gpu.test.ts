import { Matrix4, Vector4 } from 'three/webgpu';
import { expect, test } from 'vitest';
import { fromHalf } from '../../src/io/half.ts';
import { SurfacesPass } from '../../src/realtime/frame/surfaces-pass.ts';
import { material, scene } from '../pathtracer/scenes.ts';
import { frameMaker } from './effects/frames.ts';

const SIZE = 64;
const maker = await frameMaker({ width: SIZE, height: SIZE });

const ball = (x: number, more: object = {}) =>
  scene({
    camera: { fov: 40, position: [0, 0, 5], target: [0, 0, 0] },
    objects: {
      ball: {
        name: 'ball',
        material: 'm',
        position: [x, 0, 0],
        geometry: { type: 'sphere', radius: 1, widthSegments: 128, heightSegments: 64 },
      },
    },
    materials: { m: material('lambert', {}, more) },
  });

async function draw(pass: SurfacesPass, document: ReturnType<typeof ball>) {
  const { three } = maker.renderer;
  const mirror = await maker.mirror(document);
  mirror.camera.aspect = 1;
  mirror.camera.updateProjectionMatrix();
  mirror.camera.updateMatrixWorld();
  pass.render(three, mirror.scene, mirror.camera, SIZE, SIZE, 0);
  return mirror;
}

async function read(pass: SurfacesPass, index: 0 | 1) {
  const { three } = maker.renderer;
  const target = pass.target;
  const data = await three.readRenderTargetPixelsAsync(target, 0, 0, SIZE, SIZE, index);
  return Float32Array.from(data as Uint16Array, fromHalf);
}

test('normals are those of the sphere, and 0 where nothing is', async () => {
  const pass = new SurfacesPass();
  await draw(pass, ball(0));
  const normals = await read(pass, 0);
  const at = (x: number, y: number) => [...normals.subarray(4 * (y * SIZE + x), 4 * (y * SIZE + x) + 4)];
  const [x, y, z] = at(32, 32) as [number, number, number];
  expect([x, y]).toEqual([expect.closeTo(0, 1), expect.closeTo(0, 1)]);
  expect(z).toBeCloseTo(1, 2);
  // Rows from the top: the upper part of the ball looks up.
  expect(at(32, 20)[1]).toBeGreaterThan(0.3);
  expect(at(44, 32)[0]).toBeGreaterThan(0.3);
  expect(at(0, 0)).toEqual([0, 0, 0, 0]);
  pass.dispose();
});

test('what is transparent is not a surface', async () => {
  const pass = new SurfacesPass();
  await draw(pass, ball(0, { alphaMode: 'blend', opacity: 0.5 }));
  expect(Math.max(...(await read(pass, 0)))).toBe(0);
  pass.dispose();
});

test('motion is where a point is now less where it was, in normalised device coordinates', async () => {
  const pass = new SurfacesPass();
  const mirror = await draw(pass, ball(0));
  const before = await read(pass, 1);
  for (let i = 0; i < before.length; i += 4) expect(Math.hypot(before[i]!, before[i + 1]!)).toBe(0);
  mirror.apply(ball(0.25));
  const { three } = maker.renderer;
  pass.render(three, mirror.scene, mirror.camera, SIZE, SIZE, 1);
  const after = await read(pass, 1);
  const { camera } = mirror;
  const clip = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const ndc = (x: number) => {
    const p = new Vector4(x, 0, 1, 1).applyMatrix4(clip);
    return p.x / p.w;
  };
  // The front of the ball, at (0.25, 0, 1), is 4 m from the camera.
  const column = Math.round(((ndc(0.25) + 1) / 2) * SIZE - 0.5);
  expect(after[4 * (32 * SIZE + column)]!).toBeCloseTo(ndc(0.25) - ndc(0), 2);
  pass.dispose();
});

test('what comes back elsewhere has no motion', async () => {
  const pass = new SurfacesPass();
  const mirror = await draw(pass, ball(0));
  const { three } = maker.renderer;
  const { objects, ...rest } = ball(0.25);
  for (const [i, document] of [
    { ...rest, objects: {} },
    { ...rest, objects },
  ].entries()) {
    mirror.apply(document);
    await mirror.settled();
    pass.render(three, mirror.scene, mirror.camera, SIZE, SIZE, i + 1);
  }
  expect((await read(pass, 0)).some((value) => value > 0)).toBe(true);
  const motion = await read(pass, 1);
  for (let i = 0; i < motion.length; i += 4) expect(Math.hypot(motion[i]!, motion[i + 1]!)).toBe(0);
  pass.dispose();
});
