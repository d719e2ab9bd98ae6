import fc from 'fast-check';
import * as THREE from 'three/webgpu';
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import { readGlb, writeGlb } from '../../src/io/gltf/glb.ts';
import { addImported, GltfError, type ImportedModel, importGltf } from '../../src/io/gltf.ts';
import { decodeDataUrl, encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import { DocumentStore } from '../../src/scene/store.ts';

import { assets, bringInto, exported, images, type Json, png, triangle } from './gltf-files.ts';

let store: DocumentStore;
beforeEach(() => {
  store = new DocumentStore(createDocument());
});
const bring = (bytes: Uint8Array, files?: Map<string, Uint8Array>) => bringInto(store, bytes, files);

describe('objects', () => {
  test('stand where the nodes stand, however deep these are', async () => {
    const root = new THREE.Scene();
    const arm = new THREE.Group();
    arm.position.set(1, 2, 3);
    arm.rotation.set(0, Math.PI / 2, 0);
    const box = new THREE.Mesh(new THREE.BoxGeometry(1, 2, 3), new THREE.MeshStandardMaterial());
    box.name = 'Box';
    box.position.set(0, 0, 1);
    box.scale.set(2, 2, 2);
    arm.add(box);
    root.add(arm);
    const { document } = await bring(await exported(root));
    const [object] = Object.values(document.objects);
    expect(object).toMatchObject({ name: 'Box', visible: true });
    const near = (values: readonly number[] | undefined, expected: number[]) =>
      values?.forEach((value, i) => {
        expect(value).toBeCloseTo(expected[i]!, 4);
      });
    near(object?.position, [2, 2, 3]);
    near(object?.rotation, [0, 90, 0]);
    near(object?.scale, [2, 2, 2]);
    expect(Object.values(document.assets)).toMatchObject([
      { name: 'sample.glb', mediaType: 'model/gltf-binary' },
    ]);
    // What was imported is a document like any other.
    expect(parseDocument(serializeDocument(document), 'again.json')).toEqual(document);
    store.undo();
    expect(store.document).toEqual(createDocument());
  });

  test('appear in the mirror, with v upwards and with normals', async () => {
    const { document } = await bring(triangle());
    const errors: string[] = [];
    const mirror = new SceneMirror({ assets, onError: (message) => errors.push(message) });
    mirror.apply(document);
    await mirror.settled();
    const [id] = Object.keys(document.objects);
    const mesh = mirror.objectFor(id!)!;
    expect(errors).toEqual([]);
    expect(mesh.visible).toBe(true);
    expect([...mesh.geometry.getAttribute('uv').array]).toEqual([0, 1, 1, 1, 0, 0.75]);
    expect([...mesh.geometry.getAttribute('normal').array.slice(0, 3)]).toEqual([0, 0, 1]);
    mirror.dispose();
  });

  test('share what nodes share: one material, one asset', async () => {
    const nodes = [{ mesh: 0 }, { mesh: 0, translation: [1, 0, 0] }];
    const { document } = await bring(triangle({ nodes, scenes: [{ nodes: [0, 1] }] }));
    expect(Object.keys(document.objects)).toHaveLength(2);
    expect(Object.keys(document.materials)).toHaveLength(1);
    await bring(triangle({ nodes, scenes: [{ nodes: [0, 1] }] }));
    expect(Object.keys(store.document.assets)).toHaveLength(1);
    expect(Object.keys(store.document.objects)).toHaveLength(4);
  });

  test('of Suzanne and the bunny, which are Draco compressed', async () => {
    for (const load of [
      import('@pmndrs/assets/models/suzi.glb.js'),
      import('@pmndrs/assets/models/bunny.glb.js'),
    ]) {
      const { document } = await bring(decodeDataUrl((await load).default)!.bytes);
      for (const { geometry } of Object.values(document.objects))
        if (geometry.type === 'gltf') {
          const loaded = await assets.gltfGeometry(document.assets[geometry.asset]!, geometry.node, 0);
          expect(loaded.getAttribute('position').count).toBeGreaterThan(1000);
        }
    }
  });
});

describe('lights and cameras', () => {
  test('of KHR_lights_punctual, in their units', async () => {
    const extensions = {
      KHR_lights_punctual: {
        lights: [
          {
            type: 'spot',
            name: 'Lamp',
            intensity: 10,
            color: [1, 0.5, 0],
            spot: { innerConeAngle: 0.2, outerConeAngle: 0.4 },
          },
          { type: 'directional', intensity: 3 },
          { type: 'point', intensity: 7, range: 20 },
        ],
      },
    };
    const nodes = [
      { mesh: 0 },
      {
        translation: [0, 4, 0],
        rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2],
        extensions: { KHR_lights_punctual: { light: 0 } },
      },
      { extensions: { KHR_lights_punctual: { light: 1 } } },
      { extensions: { KHR_lights_punctual: { light: 2 } } },
    ];
    const { document } = await bring(triangle({ nodes, scenes: [{ nodes: [0, 1, 2, 3] }], extensions }));
    const [spot, sun, point] = Object.values(document.lights);
    expect(spot).toMatchObject({
      type: 'spot',
      name: 'Lamp',
      intensity: 10,
      color: [1, 0.5, 0],
      exponent: 0,
    });
    expect(spot).toMatchObject({ penumbra: 0.5, cutoff: THREE.MathUtils.radToDeg(0.4), position: [0, 4, 0] });
    // Turned by -90 degrees about x, -z is down.
    expect((spot as { target: number[] }).target[1]).toBeCloseTo(-1);
    expect(sun).toMatchObject({ type: 'directional', illuminance: 3 });
    expect(point).toMatchObject({ type: 'point', intensity: 7, range: 20, falloff: 'inverse-square' });
  });

  test('the camera is taken where there is no scene yet', async () => {
    const scene = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera(30, 1, 0.5, 100);
    camera.position.set(0, 0, 8);
    scene.add(camera, new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardMaterial()));
    const bytes = await exported(scene);
    const { document } = await bring(bytes);
    expect(document.camera).toMatchObject({ position: [0, 0, 8], near: 0.5, far: 100 });
    expect(document.camera.fov).toBeCloseTo(30, 3);
    const moved = { ...document.camera, position: [1, 1, 1] as [number, number, number] };
    store.edit('Move', (draft) => {
      draft.camera = moved;
    });
    expect((await bring(bytes)).document.camera).toEqual(moved);
  });
});

describe('files that come in parts', () => {
  const parts = () => {
    const { json, binary } = readGlb(
      triangle(images, { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }),
      '',
    );
    const gltf = JSON.parse(new TextDecoder().decode(json)) as { buffers: Json[]; images: Json[] };
    return { gltf, binary: binary! };
  };
  const text = (json: unknown) => new TextEncoder().encode(JSON.stringify(json));

  test('embedded as data URLs', async () => {
    const { gltf, binary } = parts();
    gltf.buffers = [{ byteLength: 60, uri: `data:application/octet-stream;base64,${encodeBase64(binary)}` }];
    const { document, notes } = await bring(text(gltf));
    expect(Object.keys(document.objects)).toEqual(['triangle']);
    expect(notes).toEqual([]);
  });

  test('beside it, found by name', async () => {
    const { gltf, binary } = parts();
    gltf.buffers = [{ byteLength: 60, uri: 'data/mesh%201.bin' }];
    gltf.images = [{ uri: 'white.png' }];
    const files = new Map([
      ['model/data/mesh 1.bin', binary],
      ['model/white.png', decodeDataUrl(`data:;base64,${png}`)!.bytes],
    ]);
    const { document, notes } = await bring(text(gltf), files);
    expect(Object.values(document.materials)[0]?.textures.baseColor).toBeDefined();
    expect(notes).toEqual([]);
    await expect(bring(text(gltf))).rejects.toThrow(
      /sample\.glb: buffers\[0\]: needs the file data\/mesh 1\.bin/,
    );
  });

  test('without an image, which is told; of two models each has its own', async () => {
    const { gltf, binary } = parts();
    gltf.buffers = [{ byteLength: 60, uri: 'mesh.bin' }];
    gltf.images = [{ uri: 'textures/white.png' }];
    const { document, notes } = await bring(text(gltf), new Map([['mesh.bin', binary]]));
    expect(Object.values(document.materials)[0]?.textures).toEqual({});
    expect(notes).toEqual([
      'the image textures/white.png did not come along: drop the whole folder, or a zip of it, to have it',
    ]);
    gltf.images = [{ uri: 'https://example.com/white.png' }];
    const remote = await bring(text(gltf), new Map([['mesh.bin', binary]]));
    expect(remote.notes.join()).toContain('on another server, and not fetched');
  });

  test('elsewhere are not fetched', async () => {
    const { gltf } = parts();
    gltf.buffers = [{ byteLength: 60, uri: 'https://example.com/mesh.bin' }];
    await expect(bring(text(gltf))).rejects.toThrow(/not fetched/);
  });
});

describe('a file that is broken', () => {
  const accessor = { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' };
  test.each<[string, Uint8Array, RegExp]>([
    ['empty', new Uint8Array(), /neither GLB nor JSON/],
    ['text', new TextEncoder().encode('hello'), /neither GLB nor JSON/],
    ['cut within the header', triangle().slice(0, 10), /ends within the GLB header/],
    ['cut within the data', triangle().slice(0, -20), /truncated/],
    ['glTF 1', triangle({ asset: { version: '1.0' } }), /glTF version 1\.0/],
    ['without surfaces', triangle({ nodes: [{}] }), /no surfaces and no lights/],
    ['a field of another type', triangle({ nodes: [{ mesh: 'first' }] }), /nodes\[0\]\.mesh: .*number/],
    [
      'a mesh that is not there',
      triangle({ nodes: [{ mesh: 7 }] }),
      /nodes\[0\]\.mesh: there is no meshes\[7\]/,
    ],
    [
      'data beyond the buffer',
      triangle({ bufferViews: [{ buffer: 0, byteLength: 1e6 }] }),
      /bufferViews\[0\]/,
    ],
    [
      'more elements than bytes',
      triangle({ accessors: [{ ...accessor, count: 4e9 }, accessor] }),
      /accessors\[0\]/,
    ],
    [
      'elements without bytes',
      triangle({ accessors: [{ componentType: 5126, count: 4e9, type: 'VEC3' }, accessor] }),
      /more data than can be loaded/,
    ],
    [
      'its own child',
      triangle({ nodes: [{ mesh: 0, children: [1] }, { children: [0] }], scenes: [{ nodes: [0] }] }),
      /its own descendants/,
    ],
    [
      'a child of two',
      triangle({ nodes: [{ children: [2] }, { children: [2] }, { mesh: 0 }], scenes: [{ nodes: [0, 1] }] }),
      /already has a parent/,
    ],
  ])('%s: says so with its name, and changes nothing', async (_, bytes, message) => {
    const before = store.document;
    const failure = bring(bytes);
    await expect(failure).rejects.toThrow(GltfError);
    await expect(failure).rejects.toThrow(message);
    await expect(failure).rejects.toThrow(/^sample\.glb: /);
    expect(store.document).toBe(before);
  });

  test('in its positions', async () => {
    const bytes = triangle();
    const { binary } = readGlb(bytes, '');
    binary!.fill(0xff, 0, 12);
    await expect(bring(bytes)).rejects.toThrow(/positions that are not finite/);
  });

  test('a deep tree is no reason to fail', async () => {
    const depth = 20_000;
    const nodes = Array.from({ length: depth }, (_, i) =>
      i + 1 < depth ? { children: [i + 1] } : { mesh: 0 },
    );
    const { document } = await bring(triangle({ nodes }));
    expect(Object.keys(document.objects)).toHaveLength(1);
  });

  describe('at random', () => {
    let sample: Uint8Array;
    beforeAll(async () => {
      // The loader of geometry warns of what it can live with.
      vi.spyOn(console, 'warn').mockReturnValue();
      const mesh = new THREE.Mesh(
        new THREE.TorusGeometry(1, 0.3, 4, 6),
        new THREE.MeshPhysicalMaterial({ clearcoat: 1, ior: 1.4 }),
      );
      sample = await exported(mesh);
    });

    /** An import works, or fails with a GltfError that names the file. */
    async function survives(bytes: Uint8Array): Promise<void> {
      const target = new DocumentStore(createDocument());
      const result = await importGltf(bytes, 'hostile.glb', assets).catch((error: unknown) => error);
      if (result instanceof Error) {
        expect(result).toBeInstanceOf(GltfError);
        expect(result.message).toMatch(/^hostile\.glb: /);
      } else {
        const imported = result as ImportedModel;
        target.edit(imported.label, (draft) => {
          addImported(draft, imported);
        });
      }
    }

    test('bytes changed', async () => {
      const change = fc.tuple(fc.nat(), fc.nat(255));
      await fc.assert(
        fc.asyncProperty(fc.array(change, { minLength: 1, maxLength: 8 }), async (changes) => {
          const bytes = sample.slice();
          for (const [at, value] of changes) bytes[at % bytes.length] = value;
          await survives(bytes);
        }),
        { numRuns: 150 },
      );
    });

    test('values changed', async () => {
      const { json, binary } = readGlb(sample, '');
      const value = fc.oneof(
        fc.jsonValue({ maxDepth: 2 }),
        fc.integer(),
        fc.constantFrom(-1, 1e9, 4294967295, null),
      );
      await fc.assert(
        fc.asyncProperty(fc.nat(), value, async (at, changed) => {
          const gltf = JSON.parse(new TextDecoder().decode(json)) as object;
          const places = holders(gltf);
          const [holder, key] = places[at % places.length]!;
          (holder as Json)[key] = changed;
          await survives(writeGlb(gltf, binary!));
        }),
        { numRuns: 200 },
      );
    });

    function holders(json: unknown): [object, string][] {
      if (typeof json !== 'object' || json === null) return [];
      return Object.entries(json).flatMap(([key, child]) => [
        [json, key] as [object, string],
        ...holders(child),
      ]);
    }
  });
});
