import * as THREE from 'three/webgpu';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { loadScene, sceneNames } from '../../scenes/index.ts';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { addLight, addObject, putAsset, setField, setLightType } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { skyDefaults } from '../../src/scene/environment-schema.ts';
import { lightTypes } from '../../src/scene/light-schema.ts';
import {
  assignMaterial,
  setMaterialModel,
  setParameter,
  setTexture,
} from '../../src/scene/material-commands.ts';
import { textureRef } from '../../src/scene/material-schema.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { removeEntities } from '../../src/scene/selection-commands.ts';
import { DocumentStore } from '../../src/scene/store.ts';

let store: DocumentStore;
let mirror: SceneMirror;
let errors: string[];

beforeEach(() => {
  errors = [];
  store = new DocumentStore(createDocument());
  mirror = new SceneMirror({
    assets: new AssetLoader(nodeAssets),
    onError: (message) => errors.push(message),
  });
  mirror.apply(store.document);
  store.subscribe(({ document }) => mirror.apply(document));
});

afterEach(() => mirror.dispose());

/** One white pixel. */
const png =
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==';

const addBox = () => {
  const id = addObject(store, 'box');
  return { id, mesh: mirror.objectFor(id)!, material: store.document.objects[id]!.material };
};

describe('shipped scenes', () => {
  test.each(sceneNames)('%s: every light, object and material has its counterpart', async (name) => {
    const document = await loadScene(name);
    mirror.apply(document);
    await mirror.settled();
    expect(errors).toEqual([]);
    for (const id of Object.keys(document.objects)) {
      const mesh = mirror.objectFor(id)!;
      expect(mesh.visible).toBe(true);
      expect(mesh.geometry.getAttribute('position').count).toBeGreaterThan(3);
      expect(mesh.material).toBe(mirror.materialFor(document.objects[id]!.material));
      expect(mirror.idFor(mesh)).toBe(id);
    }
    for (const id of Object.keys(document.lights)) expect(mirror.lightFor(id)?.visible).toBe(true);
    expect(mirror.camera.fov).toBe(document.camera.fov);
  });
});

describe('a slider', () => {
  test('of a material sets one uniform: nothing is made anew', () => {
    const { id, mesh, material } = addBox();
    const three = mirror.materialFor(material)!;
    const { geometry } = mesh;
    const version = three.version;
    const set = vi.spyOn(three, 'set');
    setParameter(store, material, 'roughness', 0.25);
    expect(set.mock.calls).toEqual([['roughness', 0.25]]);
    expect(three.get('roughness')).toBe(0.25);
    expect(mirror.materialFor(material)).toBe(three);
    expect(mirror.objectFor(id)).toBe(mesh);
    expect(mesh.geometry).toBe(geometry);
    expect(three.version).toBe(version);
  });

  test('that is reset gives the model’s default back', () => {
    const { material } = addBox();
    setParameter(store, material, 'roughness', 0.25);
    store.undo();
    expect(mirror.materialFor(material)?.get('roughness')).toBe(0.5);
  });

  test('of a light sets a field of the same light', () => {
    const id = addLight(store, 'spot');
    const light = mirror.lightFor(id) as THREE.SpotLight;
    setField(store, ['lights', id, 'cutoff'], 45);
    setField(store, ['lights', id, 'target', 1], 2);
    expect(mirror.lightFor(id)).toBe(light);
    expect(light.angle).toBeCloseTo(Math.PI / 4);
    expect(light.target.position.y).toBe(2);
    expect(light.target.parent).not.toBeNull();
  });

  test('of an object moves the same mesh, by degrees', () => {
    const { id, mesh } = addBox();
    setField(store, ['objects', id, 'rotation'], [90, 0, 0]);
    expect(mirror.objectFor(id)).toBe(mesh);
    expect(mesh.rotation.x).toBeCloseTo(Math.PI / 2);
  });

  test('of a geometry makes that geometry anew and disposes of the old one', () => {
    const { id, mesh } = addBox();
    const other = addBox();
    const old = mesh.geometry;
    const disposed = vi.fn();
    old.addEventListener('dispose', disposed);
    expect(other.mesh.geometry).toBe(old);
    setField(store, ['objects', id, 'geometry', 'width'], 3);
    expect(mesh.geometry).not.toBe(old);
    expect(other.mesh.geometry).toBe(old);
    expect(disposed).not.toHaveBeenCalled();
    setField(store, ['objects', other.id, 'geometry', 'width'], 3);
    expect(other.mesh.geometry).toBe(mesh.geometry);
    expect(disposed).toHaveBeenCalledOnce();
  });

  test('of a constant environment’s colour keeps its texture', () => {
    store.edit('Constant', (draft) => {
      draft.environment.source = { type: 'constant', color: [1, 1, 1] };
    });
    const texture = mirror.scene.environment as THREE.DataTexture;
    setField(store, ['environment', 'source', 'color'], [0.5, 0, 0]);
    expect(mirror.scene.environment).toBe(texture);
    expect([...texture.image.data!.slice(0, 2)]).toEqual([THREE.DataUtils.toHalfFloat(0.5), 0]);
  });
});

describe('lights', () => {
  test('of every type come, change their type and go', () => {
    const id = addLight(store, 'ambient');
    for (const type of lightTypes) {
      setLightType(store, id, type);
      expect(mirror.lightFor(id)).toBeInstanceOf(THREE.Light);
    }
    const group = mirror.lightFor(id)!.parent!;
    removeEntities(store, [{ kind: 'lights', id }]);
    expect(mirror.lightFor(id)).toBeUndefined();
    expect(group.children).toEqual([]);
  });

  test('that undo brings back are those that went, with what they are now: their sum is the same to the last bit', () => {
    const [first, second] = [addLight(store, 'point'), addLight(store, 'spot')];
    const before = [first, second].map((id) => mirror.lightFor(id));
    removeEntities(store, [{ kind: 'lights', id: first }]);
    setField(store, ['lights', second, 'intensity'], 7);
    setLightType(store, second, 'point');
    expect(mirror.lightFor(second)).not.toBe(before[1]);
    store.goTo(2);
    expect([first, second].map((id) => mirror.lightFor(id))).toEqual(before);
    expect(mirror.lightFor(first)).toBe(before[0]);
    expect(mirror.lightFor(second)?.intensity).not.toBe(7);
    expect(mirror.lightFor(first)?.parent).toBe(mirror.lightFor(second)?.parent);
  });

  test('have their colour times that of their temperature', () => {
    const id = addLight(store, 'point', { color: [1, 0.5, 0.5] });
    setField(store, ['lights', id, 'temperature'], 2000);
    const { color } = mirror.lightFor(id)!;
    expect(color.r).toBeGreaterThan(1);
    expect(color.b).toBeLessThan(0.2);
  });
});

describe('materials', () => {
  test('of another model are other materials, for their objects too', () => {
    const { mesh, material } = addBox();
    const old = mirror.materialFor(material);
    setMaterialModel(store, material, 'lambert');
    expect(mirror.materialFor(material)).not.toBe(old);
    expect(mesh.material).toBe(mirror.materialFor(material));
  });

  test('can be shared, taken away and brought back', () => {
    const [a, b] = [addBox(), addBox()];
    assignMaterial(store, [a.id], b.material);
    expect(a.mesh.material).toBe(b.mesh.material);
    removeEntities(store, [{ kind: 'materials', id: b.material }]);
    expect(b.mesh.material).toBe(mirror.materialFor(a.material));
    store.undo();
    expect(a.mesh.material).toBe(mirror.materialFor(b.material));
  });

  test('show a term alone when the view says so', () => {
    const [a, b] = [addBox(), addBox()];
    setField(store, ['view', 'term'], { material: a.material, name: 'specularLobe' });
    expect(mirror.materialFor(a.material)?.term).toBe('specularLobe');
    expect(mirror.materialFor(b.material)?.term).toBe('BRDF');
    setField(store, ['view', 'term'], null);
    expect(mirror.materialFor(a.material)?.term).toBe('BRDF');
    setField(store, ['materials', a.material, 'multipleScattering'], true);
    expect(mirror.materialFor(a.material)?.term).toBe('withMultipleScattering');
  });

  test('get textures when they have come, share them, and let them go', async () => {
    const { material } = addBox();
    let image = '';
    store.edit('Add image', (draft) => {
      image = putAsset(draft, 'white.png', 'image/png', png);
    });
    const three = mirror.materialFor(material)!;
    setTexture(store, material, 'roughness', textureRef(image, { channel: 'g' }));
    setTexture(store, material, 'metallic', textureRef(image, { channel: 'b' }));
    expect(three.getMap('roughness')).toBeNull();
    await mirror.settled();
    const texture = three.getMap('roughness')!;
    expect(three.getMap('metallic')).toBe(texture);
    expect(texture.image).toMatchObject({ width: 1, height: 1 });
    const disposed = vi.fn();
    texture.addEventListener('dispose', disposed);
    setTexture(store, material, 'roughness', null);
    setTexture(store, material, 'metallic', textureRef(image, { channel: 'b', repeat: [2, 2] }));
    await mirror.settled();
    // The last user moves the image without another upload.
    expect(three.getMap('metallic')).toBe(texture);
    expect(texture.repeat.x).toBe(2);
    setTexture(store, material, 'metallic', null);
    await mirror.settled();
    expect(disposed).toHaveBeenCalledOnce();
    expect(errors).toEqual([]);
  });
});

describe('assets that are broken', () => {
  test('are reported with their name, and the rest is shown', async () => {
    const { id, material } = addBox();
    store.edit('Add junk', (draft) => {
      const image = putAsset(draft, 'junk.png', 'image/png', 'AAAA');
      const model = putAsset(draft, 'junk.glb', 'model/gltf-binary', 'AAAA');
      const hdr = putAsset(draft, 'junk.hdr', 'image/vnd.radiance', 'AAAA');
      draft.materials[material]!.textures.baseColor = textureRef(image);
      draft.objects[id]!.geometry = { type: 'gltf', asset: model, node: 0, primitive: 0 };
      draft.environment.source = { type: 'hdr', asset: hdr };
    });
    await mirror.settled();
    expect(errors.map((message) => message.split(':')[0]).sort()).toEqual([
      'junk.glb',
      'junk.hdr',
      'junk.png',
    ]);
    removeEntities(store, [{ kind: 'objects', id }]);
    expect(mirror.objectFor(id)).toBeUndefined();
  });
});

test('what is loaded too late is not shown', async () => {
  const preset = (name: 'studio' | 'park') =>
    store.edit(name, (draft) => {
      draft.environment.source = { type: 'preset', name };
    });
  preset('studio');
  preset('park');
  await mirror.settled();
  expect(mirror.scene.environment?.name).toBe('park');
  store.undo();
  store.undo();
  expect(mirror.scene.environment).toBeNull();
});

test('an object that undo brings back has the mesh that it had, with its geometry and material', () => {
  const { id, mesh } = addBox();
  const { geometry, material } = mesh;
  removeEntities(store, [{ kind: 'objects', id }]);
  expect([mesh.parent, mesh.geometry === geometry, mesh.material === material]).toEqual([null, false, false]);
  store.undo();
  expect(mirror.objectFor(id)).toBe(mesh);
  expect(mesh.material).toBe(material);
  expect(mesh.geometry.getAttribute('position').count).toBe(geometry.getAttribute('position').count);
});

test('nothing of another document is kept, nor used for what has the same id in one that is opened later', () => {
  const { id } = addBox();
  const light = addLight(store, 'point');
  const full = store.document;
  const kept = () => [mirror.objectFor(id), mirror.lightFor(light)];
  const first = kept();
  removeEntities(store, [
    { kind: 'objects', id },
    { kind: 'lights', id: light },
  ]);
  mirror.open(full);
  const second = kept();
  expect(second.map((three, i) => three !== undefined && three !== first[i])).toEqual([true, true]);
  mirror.open(createDocument());
  mirror.apply(full);
  expect(kept().map((three, i) => three !== undefined && three !== second[i])).toEqual([true, true]);
});

test('undo and redo of everything leave nothing behind', async () => {
  addBox();
  addLight(store, 'spot');
  addObject(store, 'suzanne');
  await mirror.settled();
  while (store.canUndo) store.undo();
  const left = mirror.scene.children.flatMap((group) => group.children);
  expect(left).toEqual([]);
  while (store.canRedo) store.redo();
  await mirror.settled();
  expect(mirror.scene.children.flatMap((group) => group.children)).toHaveLength(4);
});

test('of skies that a hand drags through, the first and the last are computed, and a late one is dropped', async () => {
  const asked: { turbidity: number; answer(): void }[] = [];
  const map = (value: number) => ({ texels: new Float32Array(32).fill(value), width: 4, height: 2 });
  mirror.dispose();
  mirror = new SceneMirror({
    assets: new AssetLoader({
      ...nodeAssets,
      computeEnvironment: (source) =>
        new Promise((resolve) => {
          const turbidity = source.type === 'sky' ? source.turbidity : 0;
          asked.push({ turbidity, answer: () => resolve(map(turbidity)) });
        }),
    }),
    onError: (message) => errors.push(message),
  });
  const shown = () => {
    const data = (mirror.scene.environment as THREE.DataTexture | null)?.image.data as
      | Uint16Array
      | undefined;
    return data && THREE.DataUtils.fromHalfFloat(data[0] as number);
  };
  const sky = (turbidity: number) =>
    store.edit('Haze', (draft) => {
      draft.environment.source = { ...structuredClone(skyDefaults), turbidity };
    });
  sky(2);
  await expect.poll(() => asked).toHaveLength(1);
  for (const turbidity of [3, 4, 5]) sky(turbidity);
  asked[0]?.answer();
  await expect.poll(() => asked).toHaveLength(2);
  // It is nearer to what is asked for than what was there.
  expect(shown()).toBe(2);
  asked[1]?.answer();
  await mirror.settled();
  expect(shown()).toBe(5);
  expect(asked.map(({ turbidity }) => turbidity)).toEqual([2, 5]);

  sky(6);
  await expect.poll(() => asked).toHaveLength(3);
  setField(store, ['environment', 'source'], { type: 'none' });
  asked[2]?.answer();
  await mirror.settled();
  expect(mirror.scene.environment).toBeNull();
  expect(errors).toEqual([]);
});
