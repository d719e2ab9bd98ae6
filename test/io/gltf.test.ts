import fc from 'fast-check';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import * as THREE from 'three/webgpu';
import { afterAll, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { readGlb, writeGlb } from '../../src/io/gltf/glb.ts';
import { addImported, GltfError, type ImportedModel, importGltf } from '../../src/io/gltf.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { decodeDataUrl, encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import type { Document, Material } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const assets = new AssetLoader(nodeAssets);
let store: DocumentStore;
beforeEach(() => {
  store = new DocumentStore(createDocument());
});

const put = (imported: ImportedModel): void =>
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });

async function bring(
  bytes: Uint8Array,
  files?: Map<string, Uint8Array>,
): Promise<{ notes: string[]; document: Document }> {
  const imported = await importGltf(bytes, 'sample.glb', assets, files && { companions: files });
  put(imported);
  return { notes: imported.notes, document: store.document };
}

async function onlyMaterial(bytes: Uint8Array): Promise<Material & { notes: string[] }> {
  const { document, notes } = await bring(bytes);
  const materials = Object.values(document.materials);
  expect(materials).toHaveLength(1);
  return { ...materials[0]!, notes };
}

/** Node has none, and three's exporter wants one. */
class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend?.();
    });
  }
}
vi.stubGlobal('FileReader', BlobReader);
afterAll(() => void vi.unstubAllGlobals());

/** What three.js writes for a scene. */
async function exported(scene: THREE.Object3D): Promise<Uint8Array> {
  const result = await new GLTFExporter().parseAsync(scene, { binary: true });
  return new Uint8Array(result as ArrayBuffer);
}

type Json = Record<string, unknown>;

/** A triangle with everything that a test adds to or replaces in the file. */
function triangle(changes: Json = {}, material: Json = {}): Uint8Array {
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const uv = new Float32Array([0, 0, 1, 0, 0, 0.25]);
  const binary = new Uint8Array(60);
  binary.set(new Uint8Array(positions.buffer));
  binary.set(new Uint8Array(uv.buffer), 36);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'Triangle' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{ name: 'Paint', ...material }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 3, type: 'VEC2' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 24 },
    ],
    buffers: [{ byteLength: 60 }],
    ...changes,
  };
  return writeGlb(json, binary);
}

/** One white pixel. */
const png =
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==';
const images = { images: [{ uri: `data:image/png;base64,${png}` }], textures: [{ source: 0 }] };

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

describe('materials become principled', () => {
  test('with the metallic-roughness factors', async () => {
    const material = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: {
            baseColorFactor: [0.1, 0.2, 0.3, 0.4],
            metallicFactor: 0.6,
            roughnessFactor: 0.7,
          },
          alphaMode: 'BLEND',
          doubleSided: true,
          emissiveFactor: [0.5, 0.25, 0],
          extensions: { KHR_materials_emissive_strength: { emissiveStrength: 4 } },
        },
      ),
    );
    expect(material).toMatchObject({
      name: 'Paint',
      model: 'principled',
      parameters: { baseColor: [0.1, 0.2, 0.3], metallic: 0.6, roughness: 0.7 },
      alphaMode: 'blend',
      opacity: 0.4,
      doubleSided: true,
      emissive: [1, 0.5, 0],
      emissiveIntensity: 2,
      notes: [],
    });
  });

  test('with the textures in their channels and colour spaces', async () => {
    const map = { index: 0 };
    const material = await onlyMaterial(
      triangle(images, {
        pbrMetallicRoughness: { baseColorTexture: map, metallicRoughnessTexture: map },
        normalTexture: { index: 0, scale: 0.5 },
        occlusionTexture: { index: 0, strength: 0.75 },
        emissiveTexture: map,
        emissiveFactor: [1, 1, 1],
      }),
    );
    expect(material.textures).toMatchObject({
      baseColor: { texture: 0, colorSpace: 'srgb', channel: null },
      metallic: { texture: 0, colorSpace: 'linear', channel: 'b' },
      roughness: { texture: 0, colorSpace: 'linear', channel: 'g' },
    });
    expect(material.normalMap).toMatchObject({ texture: 0, scale: 0.5, colorSpace: 'linear' });
    expect(material.occlusionMap).toMatchObject({ scale: 0.75, channel: 'r' });
    expect(material.emissiveMap).toMatchObject({ colorSpace: 'srgb' });
    expect(material.notes).toEqual([]);
  });

  test('with the alpha of their colour as opacity, where it counts', async () => {
    const pbrMetallicRoughness = { baseColorTexture: { index: 0 } };
    const mask = await onlyMaterial(
      triangle(images, { pbrMetallicRoughness, alphaMode: 'MASK', alphaCutoff: 0.3 }),
    );
    expect(mask).toMatchObject({
      alphaMode: 'mask',
      alphaCutoff: 0.3,
      opacityMap: { texture: 0, channel: 'a' },
    });
    store = new DocumentStore(createDocument());
    const opaque = await onlyMaterial(triangle(images, { pbrMetallicRoughness }));
    expect(opaque.opacityMap).toBeNull();
  });

  test('with the extensions that have a counterpart', async () => {
    const { parameters } = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            KHR_materials_clearcoat: { clearcoatFactor: 0.8, clearcoatRoughnessFactor: 0.1 },
            KHR_materials_sheen: { sheenColorFactor: [0.5, 0.25, 0.5] },
            KHR_materials_ior: { ior: 1.8 },
            KHR_materials_anisotropy: { anisotropyStrength: 0.5 },
          },
        },
      ),
    );
    expect(parameters).toMatchObject({ clearcoat: 0.8, sheen: 0.5, sheenTint: 0.5 });
    expect(parameters.clearcoatGloss).toBeCloseTo(0.9091, 3);
    // An ior of 1.8 is what 1 stands for.
    expect(parameters.specular).toBeCloseTo(1.0204, 3);
    // With roughness 1 both widths are 1, however strong the anisotropy.
    expect(parameters.anisotropic).toBe(0);
  });

  test('anisotropic as KHR_materials_anisotropy is', async () => {
    const roughness = 0.4;
    const strength = 0.6;
    const { parameters } = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: { roughnessFactor: roughness },
          extensions: { KHR_materials_anisotropy: { anisotropyStrength: strength } },
        },
      ),
    );
    const aspect = Math.sqrt(1 - 0.9 * Number(parameters.anisotropic));
    const alpha = Number(parameters.roughness) ** 2;
    expect(alpha * aspect).toBeCloseTo(roughness ** 2, 5);
    expect(alpha / aspect).toBeCloseTo(roughness ** 2 * (1 - strength ** 2) + strength ** 2, 5);
  });

  test('with texture transforms that look up the same texels', async () => {
    const transform = { offset: [0.1, 0.2], rotation: 0.3, scale: [2, 2] };
    const info = { index: 0, extensions: { KHR_texture_transform: transform } };
    const { textures } = await onlyMaterial(
      triangle(images, { pbrMetallicRoughness: { baseColorTexture: info } }),
    );
    const ref = textures.baseColor!;
    const matrix = new THREE.Matrix3().setUvTransform(
      ...ref.offset,
      ...ref.repeat,
      THREE.MathUtils.degToRad(ref.rotation),
      0,
      0,
    );
    // What three's own loader does with v downwards.
    const downwards = new THREE.Matrix3().setUvTransform(0.1, 0.2, 2, 2, 0.3, 0, 0);
    for (const [u, v] of [
      [0.3, 0.4],
      [0, 1],
      [0.9, 0.2],
    ] as const) {
      const expected = new THREE.Vector2(u, v).applyMatrix3(downwards);
      const found = new THREE.Vector2(u, 1 - v).applyMatrix3(matrix);
      expect(found.x).toBeCloseTo(expected.x, 6);
      expect(1 - found.y).toBeCloseTo(expected.y, 6);
    }
  });

  test('and what cannot be mapped is said', async () => {
    const { notes } = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            KHR_materials_iridescence: { iridescenceFactor: 1 },
            KHR_materials_dispersion: { dispersion: 0.1 },
            KHR_materials_anisotropy: { anisotropyStrength: 0.5, anisotropyRotation: 1 },
          },
        },
      ),
    );
    expect(notes).toEqual([
      'Paint: the rotation of the anisotropy has no counterpart',
      'Paint: iridescence has no counterpart',
      'Paint: dispersion has no counterpart',
    ]);
  });

  test('that let light through are principled-bsdf: thin without a volume, otherwise bodies', async () => {
    const transmission = { KHR_materials_transmission: { transmissionFactor: 0.9 } };
    const thin = await onlyMaterial(triangle({}, { extensions: transmission }));
    expect(thin).toMatchObject({
      model: 'principled-bsdf',
      parameters: { specTrans: 0.9, thin: true, ior: 1.5 },
    });
    store = new DocumentStore(createDocument());
    const body = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            ...transmission,
            KHR_materials_ior: { ior: 1.33 },
            KHR_materials_volume: {
              thicknessFactor: 1,
              attenuationDistance: 2,
              attenuationColor: [0.5, 0.6, 0.7],
            },
          },
        },
      ),
    );
    expect(body.parameters).toMatchObject({
      thin: false,
      ior: 1.33,
      transmissionColor: [0.5, 0.6, 0.7],
      transmissionDepth: 2,
    });
    expect(body.parameters).not.toHaveProperty('specular');
  });

  test('that are unlit emit their colour', async () => {
    const material = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: { baseColorFactor: [0.5, 0.25, 0, 1] },
          extensions: { KHR_materials_unlit: {} },
        },
      ),
    );
    expect(material).toMatchObject({
      emissive: [1, 0.5, 0],
      emissiveIntensity: 0.5,
      parameters: { baseColor: [0, 0, 0], specular: 0 },
    });
  });

  test('of the specular-glossiness workflow: a metal and a dielectric', async () => {
    const workflow = (specularFactor: number[], diffuseFactor: number[]) =>
      triangle(
        {},
        {
          extensions: {
            KHR_materials_pbrSpecularGlossiness: { specularFactor, diffuseFactor, glossinessFactor: 0.75 },
          },
        },
      );
    const metal = await onlyMaterial(workflow([0.9, 0.6, 0.3], [0, 0, 0, 1]));
    expect(metal.parameters.metallic).toBeCloseTo(1, 2);
    expect(metal.parameters.roughness).toBe(0.25);
    store = new DocumentStore(createDocument());
    const paint = await onlyMaterial(workflow([0.04, 0.04, 0.04], [0.5, 0.2, 0.1, 1]));
    expect(paint.parameters.metallic).toBeCloseTo(0, 6);
    (paint.parameters.baseColor as number[]).forEach((value, c) => {
      expect(value).toBeCloseTo([0.5, 0.2, 0.1][c]!, 6);
    });
  });

  test('of variants are there, beside the one that is shown', async () => {
    const primitive = {
      attributes: { POSITION: 0 },
      material: 0,
      extensions: {
        KHR_materials_variants: {
          mappings: [
            { material: 0, variants: [0] },
            { material: 1, variants: [1] },
          ],
        },
      },
    };
    const { document, notes } = await bring(
      triangle({
        meshes: [{ primitives: [primitive] }],
        materials: [{ name: 'Blue' }, { name: 'Green' }],
        extensions: { KHR_materials_variants: { variants: [{ name: 'day' }, { name: 'night' }] } },
      }),
    );
    expect(Object.values(document.materials).map(({ name }) => name)).toEqual(['Blue', 'Green']);
    expect(Object.values(document.objects)).toMatchObject([{ material: Object.keys(document.materials)[0] }]);
    expect(notes.join()).toContain('variants day, night');
  });

  test('hidden nodes hide what is below them', async () => {
    const hidden = { KHR_node_visibility: { visible: false } };
    const { document } = await bring(
      triangle({ nodes: [{ children: [1], extensions: hidden }, { mesh: 0 }], scenes: [{ nodes: [0] }] }),
    );
    expect(Object.values(document.objects)).toMatchObject([{ visible: false }]);
  });

  test('without an image that cannot be read', async () => {
    const broken = { images: [{ uri: 'data:image/png;base64,AAAA' }], textures: [{ source: 0 }] };
    const material = await onlyMaterial(
      triangle(broken, { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }),
    );
    expect(material.textures).toEqual({});
    expect(material.notes[0]).toMatch(/sample\.glb, textures\[0\]: the image cannot be read/);
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
