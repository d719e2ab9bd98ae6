/** What a mesh covers in the picture: its silhouette, and whether a box holds it, against rays. */
import {
  BoxGeometry,
  type BufferGeometry,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Raycaster,
  SphereGeometry,
  TorusGeometry,
  TorusKnotGeometry,
  Vector2,
  Vector3,
} from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import type { Shape } from '../../../src/editor/viewport/meshes/shape.ts';
import { meshEdges } from '../../../src/editor/viewport/outline/mesh-edges.ts';
import { type Loop, silhouette } from '../../../src/editor/viewport/outline/silhouette.ts';
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

function outlineOf(mesh: Mesh, camera: PerspectiveCamera): Loop[] {
  mesh.updateMatrixWorld();
  const { positions, index } = trianglesOf(mesh.geometry);
  return silhouette(meshEdges(positions, index), {
    eye: camera.position.clone().applyMatrix4(mesh.matrixWorld.clone().invert()),
    toClip: viewProjection(camera).multiply(mesh.matrixWorld),
    near: camera.near,
    width: WIDTH,
    height: HEIGHT,
  });
}

/** How often the loops go around a point: the crossings of a ray to the right, counted with their direction. */
function winding(loops: readonly Loop[], x: number, y: number): number {
  let count = 0;
  for (const loop of loops)
    for (let i = 0; i < loop.length; i += 2) {
      const j = (i + 2) % loop.length;
      const [ax, ay, bx, by] = [loop[i]!, loop[i + 1]!, loop[j]!, loop[j + 1]!];
      if (ay <= y === by <= y) continue;
      if (ax + ((y - ay) / (by - ay)) * (bx - ax) > x) count += by > ay ? 1 : -1;
    }
  return count;
}

/** Pixels further than this from every line of an outline: nearer ones may be on either side of it. */
const CLEAR_PX = 1;

function distance(loops: readonly Loop[], x: number, y: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (const loop of loops)
    for (let i = 0; i < loop.length; i += 2) {
      const j = (i + 2) % loop.length;
      const [ax, ay] = [loop[i]!, loop[i + 1]!];
      const [dx, dy] = [loop[j]! - ax, loop[j + 1]! - ay];
      const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
      least = Math.min(least, Math.hypot(ax + t * dx - x, ay + t * dy - y));
    }
  return least;
}

const material = new MeshBasicMaterial({ side: DoubleSide });
const mesh = (geometry: BufferGeometry) => new Mesh(geometry, material);
const shapes: Record<string, () => BufferGeometry> = {
  sphere: () => new SphereGeometry(1, 24, 12),
  box: () => new BoxGeometry(1.5, 1, 0.7),
  'box without an index': () => new BoxGeometry(1.5, 1, 0.7).toNonIndexed(),
  torus: () => new TorusGeometry(1, 0.3, 12, 40),
  knot: () => new TorusKnotGeometry(0.8, 0.2, 120, 10),
  'open plane': () => new PlaneGeometry(2, 1.5, 3, 2),
  'half a sphere': () => new SphereGeometry(1, 24, 8, 0, 2 * Math.PI, 0, Math.PI / 2),
};

describe('a silhouette covers just the pixels whose rays meet the mesh', () => {
  it.each(Object.keys(shapes))('%s', (name) => {
    for (let view = 0; view < 4; view++) {
      const thing = mesh(shapes[name]!());
      thing.rotation.set(between(-3, 3), between(-3, 3), between(-3, 3));
      // A mirrored and stretched one, too.
      thing.scale.set(view % 2 === 0 ? 1 : -1, between(0.6, 1.4), 1);
      const camera = cameraAt(between(-2, 2), between(-2, 2), between(3, 5));
      const loops = outlineOf(thing, camera);
      const raycaster = new Raycaster();
      let [inside, outside] = [0, 0];
      for (let i = 0; i < 150; i++) {
        const [x, y] = [between(60, 240), between(20, 180)];
        if (distance(loops, x, y) < CLEAR_PX) continue;
        raycaster.setFromCamera(new Vector2((2 * x) / WIDTH - 1, 1 - (2 * y) / HEIGHT), camera);
        const hit = raycaster.intersectObject(thing).length > 0;
        expect(winding(loops, x, y) !== 0).toBe(hit);
        if (hit) inside += 1;
        else outside += 1;
      }
      expect(inside).toBeGreaterThan(0);
      expect(outside).toBeGreaterThan(0);
    }
  });

  it('of a mesh that the camera is in, or that reaches behind the camera', () => {
    const room = mesh(new BoxGeometry(20, 6, 20, 3, 3, 3));
    const inside = outlineOf(room, cameraAt(1, 0.5, 3));
    for (let i = 0; i < 50; i++) expect(winding(inside, between(0, WIDTH), between(0, HEIGHT))).not.toBe(0);
    const floor = mesh(new PlaneGeometry(40, 40, 5, 5).rotateX(-Math.PI / 2));
    const camera = cameraAt(0, 2, 5);
    const loops = outlineOf(floor, camera);
    const raycaster = new Raycaster();
    for (let i = 0; i < 200; i++) {
      const [x, y] = [between(0, WIDTH), between(0, HEIGHT)];
      if (distance(loops, x, y) < CLEAR_PX) continue;
      raycaster.setFromCamera(new Vector2((2 * x) / WIDTH - 1, 1 - (2 * y) / HEIGHT), camera);
      expect(winding(loops, x, y) !== 0).toBe(raycaster.intersectObject(floor).length > 0);
    }
  });

  it('of a sphere is a circle: sin of its half angle is radius over distance', () => {
    const camera = cameraAt(0, 0, 4);
    const loops = outlineOf(mesh(new SphereGeometry(1, 96, 64)), camera);
    const focal = HEIGHT / 2 / Math.tan((25 * Math.PI) / 180);
    const radius = focal * Math.tan(Math.asin(1 / 4));
    // Its triangles are within the sphere, and meet it at their corners.
    const reach = loops.flatMap((loop) =>
      loop.flatMap((x, i) => (i % 2 === 0 ? [Math.hypot(x - WIDTH / 2, loop[i + 1]! - HEIGHT / 2)] : [])),
    );
    expect(Math.max(...reach)).toBeCloseTo(radius, 0);
    expect(Math.min(...reach)).toBeGreaterThan(0.95 * radius);
  });
});

it('the edges of a box are 18: 12, and a diagonal on each face', () => {
  const { positions, index } = trianglesOf(new BoxGeometry(1, 1, 1));
  const edges = meshEdges(positions, index);
  expect(edges.points.length / 3).toBe(8);
  expect(edges.edges.length / 2).toBe(18);
});

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
