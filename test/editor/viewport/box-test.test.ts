/** Whether a box that is drawn over the picture holds a mesh, or touches it: against rays. */
import {
  type BufferGeometry,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Raycaster,
  TorusGeometry,
  Vector2,
  Vector3,
} from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import type { Shape } from '../../../src/editor/viewport/meshes/shape.ts';
import { isInRectangle, rectangleProjection } from '../../../src/editor/viewport/selecting/box-test.ts';

const random = createRandom(11);
const between = (low: number, high: number) => low + (high - low) * random();
const [WIDTH, HEIGHT] = [300, 200];

const trianglesOf = ({ attributes, index }: BufferGeometry): Shape => ({
  positions: attributes.position!.array as Float32Array,
  index: (index?.array ?? null) as Shape['index'],
});

function cameraAt(...position: [number, number, number]): PerspectiveCamera {
  const camera = new PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 100);
  camera.position.set(...position);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

const viewProjection = (camera: PerspectiveCamera) =>
  new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);

const material = new MeshBasicMaterial({ side: DoubleSide });
const mesh = (geometry: BufferGeometry) => new Mesh(geometry, material);
describe('a rectangle of the picture', () => {
  const whole = (
    thing: Mesh,
    camera: PerspectiveCamera,
    box: [number, number, number, number],
    touching: boolean,
  ) => {
    thing.updateMatrixWorld();
    const [left, bottom, right, top] = box;
    const projection = rectangleProjection(viewProjection(camera), { left, right, bottom, top });
    return isInRectangle(trianglesOf(thing.geometry), projection.multiply(thing.matrixWorld), touching);
  };

  it('holds a mesh if it holds all its corners, and touches it if a ray through it meets the mesh', () => {
    for (let i = 0; i < 60; i++) {
      const thing = mesh(new TorusGeometry(1, 0.3, 8, 16));
      thing.rotation.set(between(-3, 3), between(-3, 3), 0);
      const camera = cameraAt(between(-2, 2), 1, between(3, 5));
      const [left, bottom] = [between(-1, 0.5), between(-1, 0.5)];
      const [right, top] = [left + between(0.1, 1.2), bottom + between(0.1, 1.2)];
      thing.updateMatrixWorld();
      const position = thing.geometry.getAttribute('position');
      let all = true;
      for (let k = 0; k < position.count; k++) {
        const { x, y } = new Vector3()
          .fromBufferAttribute(position, k)
          .applyMatrix4(thing.matrixWorld)
          .project(camera);
        all &&= x >= left && x <= right && y >= bottom && y <= top;
      }
      expect(whole(thing, camera, [left, bottom, right, top], false)).toBe(all);
      const raycaster = new Raycaster();
      let met = false;
      for (let k = 0; k < 150 && !met; k++) {
        raycaster.setFromCamera(new Vector2(between(left, right), between(bottom, top)), camera);
        met = raycaster.intersectObject(thing).length > 0;
      }
      if (met) expect(whole(thing, camera, [left, bottom, right, top], true)).toBe(true);
    }
  });

  it('in the hole of a torus touches nothing', () => {
    const thing = mesh(new TorusGeometry(1, 0.2, 12, 48));
    expect(whole(thing, cameraAt(0, 0, 4), [-0.1, -0.1, 0.1, 0.1], true)).toBe(false);
    expect(whole(thing, cameraAt(0, 0, 4), [-1, -1, 1, 1], false)).toBe(true);
  });

  it('touches a triangle that is larger than it, and none behind the camera', () => {
    const wall = mesh(new PlaneGeometry(50, 50));
    expect(whole(wall, cameraAt(0, 0, 4), [-0.1, -0.1, 0.1, 0.1], true)).toBe(true);
    wall.position.z = 9;
    expect(whole(wall, cameraAt(0, 0, 4), [-0.1, -0.1, 0.1, 0.1], true)).toBe(false);
  });
});
