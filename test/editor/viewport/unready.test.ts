import {
  BoxGeometry,
  DirectionalLight,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  Scene,
  SphereGeometry,
  Texture,
} from 'three/webgpu';
import { beforeEach, describe, expect, it } from 'vitest';
import { UnreadyMeshes } from '../../../src/editor/viewport/unready.ts';

const box = new BoxGeometry();
const material = new MeshBasicMaterial();
let scene: Scene;
let unready: UnreadyMeshes;
let first: Mesh;
/** As it is drawn: a mesh for each, which may be hidden. */
const take = () => {
  const meshes: Mesh[] = [];
  scene.traverseVisible((object) => {
    if (object instanceof Mesh) meshes.push(object);
  });
  return unready.take(scene, meshes);
};
const add = (count: number) => {
  const meshes = Array.from({ length: count }, () => new Mesh(box, material));
  scene.add(...meshes);
  return meshes;
};

beforeEach(() => {
  scene = new Scene();
  unready = new UnreadyMeshes();
  [first] = add(1) as unknown as [Mesh];
  take();
});

describe('what is compiled ahead of a frame', () => {
  it('is nothing of what has been drawn, moved or not', () => {
    first.position.x = 3;
    expect(take()).toEqual([]);
  });

  it('is a mesh with a material that is new or was changed, and no other one', () => {
    const [other] = add(1) as unknown as [Mesh];
    other.material = new MeshBasicMaterial();
    expect(take()).toEqual([other]);
    (other.material as MeshBasicMaterial).needsUpdate = true;
    expect(take()).toEqual([other]);
    expect(take()).toEqual([]);
  });

  it('is not a few meshes more of what is there, but many are', () => {
    add(5);
    expect(take()).toEqual([]);
    first.geometry = new SphereGeometry();
    expect(take()).toEqual([]);
    const many = add(100);
    expect(take()).toEqual(many);
  });

  it('is nothing that is hidden, until it is shown', () => {
    const [other] = add(1) as unknown as [Mesh];
    other.material = new MeshBasicMaterial();
    other.visible = false;
    expect(take()).toEqual([]);
    other.visible = true;
    expect(take()).toEqual([other]);
  });

  it('is what stands for many of a material that was drawn for one only, and once', () => {
    const many = new InstancedMesh(box, material, 100);
    expect(unready.take(scene, [many])).toEqual([many]);
    expect(unready.take(scene, [many, first])).toEqual([]);
  });

  it('is everything after another light, or another environment, which may come at any time', () => {
    scene.add(new DirectionalLight());
    expect(take()).toEqual([first]);
    expect(unready.hasOtherEnvironment(scene)).toBe(false);
    scene.environment = new Texture();
    expect(unready.hasOtherEnvironment(scene)).toBe(true);
    expect(take()).toEqual([first]);
    expect(unready.hasOtherEnvironment(scene)).toBe(false);
  });
});
