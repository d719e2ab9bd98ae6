/** What a thread finds out about large meshes: the same as looking at every triangle, and once only. */
import {
  BackSide,
  Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Ray,
  Raycaster,
  Scene,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { createRandom } from '../../../src/analysis/random.ts';
import { ThreadEnded, type ToThread } from '../../../src/editor/threads/thread.ts';
import { type MeshQuestion, meshAnswers } from '../../../src/editor/viewport/meshes/mesh-jobs.ts';
import { buildMeshTree, firstHit, type MeshTree } from '../../../src/editor/viewport/meshes/mesh-tree.ts';
import { Meshes, SMALL, triangleCount } from '../../../src/editor/viewport/meshes/meshes.ts';
import type { Shape } from '../../../src/editor/viewport/meshes/shape.ts';
import { fallOf, worldTriangles } from '../../../src/editor/viewport/placing/fall.ts';
import {
  isInRectangle,
  placeOf,
  rectangleProjection,
} from '../../../src/editor/viewport/selecting/box-test.ts';
import { pickAlong, whenPicked } from '../../../src/editor/viewport/selecting/picking.ts';
import { Pace } from '../../../src/pathtracer/scene/pace.ts';
import type { SceneMirror } from '../../../src/scene/mirror.ts';

const random = createRandom(5);
const between = (low: number, high: number) => low + (high - low) * random();
const somewhere = (reach: number) =>
  new Vector3(between(-reach, reach), between(-reach, reach), between(-reach, reach));

/** Triangles that have nothing to do with each other. */
function soup(triangles: number): BufferGeometry {
  const positions = new Float32Array(9 * triangles).map((_, i) => (i % 9 < 3 ? 0 : between(-0.4, 0.4)));
  for (let i = 0; i < positions.length; i += 9) {
    const at = somewhere(1).toArray();
    for (let k = 0; k < 9; k++) positions[i + k] = (positions[i + k] as number) + (at[k % 3] as number);
  }
  return new BufferGeometry().setAttribute('position', new BufferAttribute(positions, 3));
}

const shapeOf = ({ attributes, index }: BufferGeometry): Shape => ({
  positions: attributes.position?.array as Float32Array,
  index: (index?.array ?? null) as Uint32Array | null,
});

const large = () => new TorusKnotGeometry(1, 0.3, 400, 12);
const geometries = { soup: soup(700), knot: large(), sphere: new SphereGeometry(1, 24, 12) };

async function treeOf(shape: Shape): Promise<MeshTree> {
  const pace = new Pace();
  const tree = await buildMeshTree(shape, pace);
  pace.end();
  return tree;
}

/** A thread in this one: it gets copies, and answers later. */
class FakeWorker extends EventTarget {
  readonly asked: MeshQuestion[] = [];
  isEnded = false;
  readonly #answer = meshAnswers();

  postMessage(message: ToThread<MeshQuestion>): void {
    const { ticket, question } = structuredClone(message);
    this.asked.push(question);
    void this.#answer(question).then(({ answer }) => {
      const data = structuredClone({ ticket, answer });
      setTimeout(() => {
        if (!this.isEnded) this.dispatchEvent(new MessageEvent('message', { data }));
      });
    });
  }

  terminate(): void {
    this.isEnded = true;
  }
}

function meshesWithWorkers(): { meshes: Meshes; workers: FakeWorker[] } {
  const workers: FakeWorker[] = [];
  const meshes = new Meshes(() => {
    const worker = new FakeWorker();
    workers.push(worker);
    return worker;
  });
  return { meshes, workers };
}

describe('a tree of triangles', () => {
  it.each(Object.entries(geometries))('finds what a ray meets first in a %s', async (_, geometry) => {
    const shape = shapeOf(geometry);
    const tree = await treeOf(shape);
    expect([...tree.triangles].sort((a, b) => a - b)).toEqual(
      Array.from({ length: triangleCount(geometry) }, (__, i) => i),
    );
    let hits = 0;
    for (let i = 0; i < 200; i++) {
      const side = [FrontSide, BackSide, DoubleSide][i % 3] as typeof FrontSide;
      const origin = somewhere(i % 4 === 0 ? 0.5 : 3);
      // Along an axis, too, where slabs are parallel to the ray.
      const direction =
        i % 5 === 0 ? new Vector3(0, i % 2 ? 1 : -1, 0) : somewhere(1).sub(origin).normalize();
      const ray = new Ray(origin, direction);
      const mesh = new Mesh(geometry, new MeshBasicMaterial({ side }));
      const expected = new Raycaster(origin, direction).intersectObject(mesh)[0]?.point ?? null;
      const found = firstHit(tree, shape, ray, side);
      expect(found === null).toBe(expected === null);
      if (found && expected) expect(found.distanceTo(expected)).toBeLessThan(1e-9);
      if (found) hits++;
    }
    expect(hits).toBeGreaterThan(30);
  });

  it('leaves out what has no place', async () => {
    const geometry = soup(50);
    shapeOf(geometry).positions[9 * 7] = Number.NaN;
    expect([...(await treeOf(shapeOf(geometry))).triangles]).not.toContain(7);
    expect((await treeOf({ positions: new Float32Array(), index: null })).count).toHaveLength(0);
  });

  it.each(Object.entries(geometries))('says what of a %s a box holds', async (_, geometry) => {
    const shape = shapeOf(geometry);
    const tree = await treeOf(shape);
    const camera = new PerspectiveCamera(60, 1.5, 0.1, 50);
    let [yes, no] = [0, 0];
    for (let i = 0; i < 200; i++) {
      // Some of it is behind the eye now and then.
      camera.position.copy(somewhere(i % 3 === 0 ? 1.5 : 4));
      camera.lookAt(0, 0, 0);
      camera.updateMatrixWorld();
      const [x, y] = [between(-1, 0.8), between(-1, 0.8)];
      const size = between(0.02, 2);
      const projection = rectangleProjection(
        new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
        { left: x, right: x + size, bottom: y, top: y + size },
      );
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox!;
      const place = placeOf([...min, ...max], 0, projection);
      for (const touching of [false, true]) {
        const expected = isInRectangle(shape, projection, touching);
        expect(isInRectangle(shape, projection, touching, tree)).toBe(expected);
        if (place !== 'across') expect(place === 'inside').toBe(expected);
        if (expected) yes++;
        else no++;
      }
    }
    expect(Math.min(yes, no)).toBeGreaterThan(10);
  });
});

describe('of meshes', () => {
  it('small ones are looked at at once', () => {
    const { meshes, workers } = meshesWithWorkers();
    const sphere = new SphereGeometry(1, 16, 8);
    const mesh = new Mesh(sphere);
    expect(meshes.fall([{ mesh, middle: 0 }], [])).toBeCloseTo(-1, 6);
    expect(workers).toHaveLength(0);
  });

  it('large ones have a tree when the thread has made it, and the thread is asked once', async () => {
    const { meshes, workers } = meshesWithWorkers();
    const geometry = large();
    expect(triangleCount(geometry)).toBeGreaterThan(SMALL);
    const asked = meshes.tree(geometry);
    expect(asked).toBeInstanceOf(Promise);
    expect(meshes.tree(geometry)).toBe(asked);
    await asked;
    expect(meshes.tree(geometry)).toEqual(await treeOf(shapeOf(geometry)));
    await meshes.fall([{ mesh: new Mesh(geometry), middle: 0 }], []);
    // Its triangles went there with the first question alone.
    expect(workers).toHaveLength(1);
    expect(workers[0]?.asked).toMatchObject([
      { kind: 'tree', mesh: { shape: {} } },
      { kind: 'fall', bodies: [{ mesh: { shape: null } }] },
    ]);
  });

  it('fall as they do here', async () => {
    const { meshes } = meshesWithWorkers();
    const [above, below] = [new Mesh(large()), new Mesh(large())];
    above.position.set(0.2, 6, 0.1);
    above.rotation.set(0.3, 0.2, 0.1);
    below.scale.set(1.2, 0.8, 1);
    for (const mesh of [above, below]) mesh.updateMatrixWorld();
    const triangles = ({ geometry, matrixWorld }: Mesh) => worldTriangles(shapeOf(geometry), matrixWorld);
    const expected = fallOf([{ triangles: triangles(above), middle: 6 }], [triangles(below)]);
    expect(await meshes.fall([{ mesh: above, middle: 6 }], [below])).toBe(expected);
    expect(expected).toBeGreaterThan(0.5);

    // A ground at a height, or under others: as far as three.js finds their lowest corner.
    const own = new Box3().setFromObject(above, true).min.y;
    const body = [{ mesh: above, middle: 6 }];
    expect(await meshes.fall(body, [], 4)).toBeCloseTo(own - 4, 6);
    const lowest = new Box3().setFromObject(below, true).min.y;
    expect(await meshes.fall(body, [], [below])).toBeCloseTo(own - lowest, 6);
    expect(await meshes.fall(body, [], [])).toBeCloseTo(own, 6);
    const small = new Mesh(new SphereGeometry(0.5, 16, 8));
    small.position.y = -2;
    small.updateMatrixWorld();
    expect(meshes.fall([{ mesh: small, middle: -2 }], [], [small])).toBeCloseTo(0, 6);
  });

  it('what is given up fails, and can be asked for again', async () => {
    const { meshes, workers } = meshesWithWorkers();
    const geometry = large();
    const tree = meshes.tree(geometry);
    const fall = meshes.fall([{ mesh: new Mesh(geometry), middle: 0 }], []);
    meshes.cancel();
    await expect(tree).rejects.toThrow(ThreadEnded);
    await expect(fall).rejects.toThrow(ThreadEnded);
    await meshes.tree(geometry);
    expect(meshes.tree(geometry)).not.toBeInstanceOf(Promise);
    // Another thread knows nothing of the triangles.
    expect(workers).toHaveLength(2);
    expect(workers[1]?.asked[0]).toMatchObject({ kind: 'tree', mesh: { shape: {} } });
  });
});

describe('picking', () => {
  function sceneOf(...all: Mesh[]): SceneMirror {
    const scene = new Scene();
    scene.add(...all);
    scene.updateMatrixWorld();
    return {
      scene,
      camera: new PerspectiveCamera(),
      idFor: ({ name }: Mesh) => name,
    } as unknown as SceneMirror;
  }

  it('finds large and small meshes alike, the nearest first, once their trees are there', async () => {
    const { meshes } = meshesWithWorkers();
    const material = new MeshBasicMaterial();
    const all = [large(), new SphereGeometry(0.8, 24, 12), large()].map((geometry, i) => {
      const mesh = new Mesh(geometry, material);
      mesh.name = `mesh ${i}`;
      mesh.position.set(0, 0, -3 * i);
      mesh.rotation.set(i, 2 * i, 0);
      mesh.scale.set(1, 1 + i / 2, 1);
      return mesh;
    });
    const mirror = sceneOf(...all);
    for (let i = 0; i < 60; i++) {
      const origin = new Vector3(between(-1, 1), between(-1, 1), 5);
      const ray = new Ray(origin, new Vector3(between(-0.1, 0.1), between(-0.1, 0.1), -1).normalize());
      let found = pickAlong(mirror, ray, meshes);
      while (found instanceof Promise) {
        await found;
        found = pickAlong(mirror, ray, meshes);
      }
      const names: string[] = [];
      for (const { object } of new Raycaster(origin, ray.direction).intersectObjects(all))
        if (!names.includes(object.name)) names.push(object.name);
      expect(found.map(({ id }) => id)).toEqual(names);
    }
  });

  it('drops what comes when something else has been done since', async () => {
    const { meshes } = meshesWithWorkers();
    const mesh = new Mesh(new SphereGeometry(1, 90, 60), new MeshBasicMaterial());
    mesh.name = 'ball';
    const mirror = sceneOf(mesh);
    const ray = new Ray(new Vector3(0.1, 0.2, 5), new Vector3(0, 0, -1));
    let [state, late] = ['before', 0];
    const dropped = whenPicked(
      mirror,
      ray,
      () => [state],
      () => late++,
      meshes,
    );
    state = 'after';
    await dropped;
    expect(late).toBe(0);
    const ids: string[] = [];
    await whenPicked(
      mirror,
      ray,
      () => [state],
      (found) => ids.push(...found.map(({ id }) => id)),
      meshes,
    );
    expect(ids).toEqual(['ball']);
  });
});
