import sharp from 'sharp';
import * as THREE from 'three/webgpu';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { loadScene, sceneNames } from '../../../scenes/index.ts';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { PathTracerError } from '../../../src/pathtracer/scene/error.ts';
import * as meshes from '../../../src/pathtracer/scene/mesh.ts';
import { Pace } from '../../../src/pathtracer/scene/pace.ts';
import { type PackedScene, ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { createDocument, parseDocument } from '../../../src/scene/document.ts';
import * as primitives from '../../../src/scene/mirror/geometry.ts';
import type { Document } from '../../../src/scene/schema.ts';
import { Reader, type Vector } from './reader.ts';

const assets = new AssetLoader(nodeAssets);
const documentOf = (parts: object): Document =>
  parseDocument({ format: 'irradia', version: 1, ...parts }, 'test');
const pack = (document: Document) => new ScenePacker(assets).pack(document);

const plain = { m: { model: 'principled' } };
const NONE = 0xffffffff;

afterEach(() => vi.restoreAllMocks());

/** Every float that the layout says is one: bounds are infinite only for children that are not there. */
function expectNoNaN(scene: PackedScene): void {
  const reader = new Reader(scene);
  const faults: string[] = [];
  const finite = (slot: number) => {
    for (let word = 4 * slot; word < 4 * slot + 4; word += 1)
      if (!Number.isFinite(reader.floats[word])) faults.push(`word ${word} is ${reader.floats[word]}`);
  };
  const seen = new Set<number>();
  const visit = (node: number, leaf: (reference: number) => void): void => {
    for (let lane = 0; lane < 4; lane += 1) {
      const child = reader.uints[4 * (node + 6) + lane]!;
      if (child === NONE) continue;
      for (let i = 0; i < 6; i += 1)
        if (!Number.isFinite(reader.floats[4 * (node + i) + lane])) faults.push(`bounds of node ${node}`);
      if (child >= 0x80000000) leaf(child - 0x80000000);
      else visit(child, leaf);
    }
  };
  for (let slot = 3; slot < 9; slot += 1) finite(slot);
  visit(reader.uint4(0)[0], (instance) => {
    const slot = reader.instance(instance);
    for (let i = 0; i < 6; i += 1) finite(slot + i);
    const [mesh, material] = reader.uint4(slot + 6);
    finite(material + 1);
    finite(material + 2);
    if (seen.has(mesh)) return;
    seen.add(mesh);
    const [root, vertices, indices, stride] = reader.uint4(mesh);
    visit(root, (block) => {
      for (let i = 0; i < 9; i += 1) finite(block + i);
      for (const triangle of reader.uint4(block + 9)) {
        if (triangle === NONE) continue;
        for (let corner = 0; corner < 3; corner += 1) {
          const vertex = vertices + stride * reader.uints[indices + 3 * triangle + corner]!;
          for (let i = 0; i < stride; i += 1) finite(vertex + i);
          const length = Math.hypot(...reader.floats.subarray(4 * vertex, 4 * vertex + 3));
          if (Math.abs(length - 1) > 1e-5) faults.push(`normal of length ${length}`);
        }
      }
    });
  });
  for (let light = 0; light < reader.uint4(1)[2]; light += 1)
    for (let i = 1; i < 6; i += 1) finite(reader.light(light) + i);
  expect(faults).toEqual([]);
}

describe('shipped scenes', () => {
  test.each(sceneNames)('%s is packed whole', async (name) => {
    const document = await loadScene(name);
    const scene = await pack(document);
    const reader = new Reader(scene);
    expect(reader.instances).toBe(Object.keys(document.objects).length);
    expect(scene.words.length % 4).toBe(0);
    expect([...scene.words.subarray(64, 128)].every((word) => word === 0)).toBe(true);
    expect(scene.stack).toBeLessThanOrEqual(96);
    expect(scene.triangles).toBeGreaterThan(1000);
    // There is something where the camera looks.
    const { position, target } = document.camera;
    const hits = Array.from({ length: 16 }, (_, i) => {
      const aside = [(i % 4) - 1.5, Math.floor(i / 4) - 1.5, 0].map((x) => 0.2 * x);
      const direction = target.map((x, axis) => x + aside[axis]! - position[axis]!) as Vector;
      return reader.trace([...position] as Vector, direction);
    });
    expect(hits.filter((hit) => hit !== null).length).toBeGreaterThan(4);
    expectNoNaN(scene);
  });
});

describe('materials', () => {
  test('have their parameters, textures and maps where the kernel looks for them', async () => {
    // Rows from the top: red, half transparent green.
    const pixels = Buffer.from([255, 0, 0, 255, 0, 255, 0, 128]);
    const png = await sharp(pixels, { raw: { width: 1, height: 2, channels: 4 } })
      .png()
      .toBuffer();
    const image = { name: 'image', mediaType: 'image/png', data: png.toString('base64') };
    const color = { asset: 'image', colorSpace: 'srgb', repeat: [2, 3], offset: [0.5, 0], wrap: 'mirror' };
    const document = documentOf({
      assets: { image },
      materials: {
        m: {
          model: 'principled',
          parameters: { baseColor: [0.1, 0.2, 0.3], roughness: 0.25 },
          textures: {
            baseColor: color,
            roughness: { asset: 'image', channel: 'g', uv: 1 },
            metallic: { asset: 'image' },
          },
          normalMap: { asset: 'image', scale: 0.5 },
          bumpMap: { asset: 'image', scale: 2 },
          emissiveMap: { ...color, scale: 2 },
          opacityMap: { asset: 'image', scale: 0.5 },
          emissive: [1, 0, 0.5],
          emissiveIntensity: 3,
          alphaMode: 'mask',
          alphaCutoff: 0.25,
          opacity: 0.5,
        },
      },
      objects: { o: { material: 'm', geometry: { type: 'box' } } },
    });
    const scene = await pack(document);
    const reader = new Reader(scene);
    const model = scene.models[0]!;
    expect(scene.models.map(({ name }) => name)).toEqual(['principled']);
    const slot = reader.material(0);
    const [index, flags, parameters] = reader.uint4(slot);
    expect([index, flags]).toEqual([0, 2 | 8]);
    expect(reader.float4(slot + 1)).toEqual([6, 0, 3, 0.25]);
    expect(reader.float4(slot + 2)).toEqual([0.25, 0.5, 2, 0]);
    const at = (name: string): number => parameters + model.parameters.findIndex((p) => p.name === name);
    const baseColor = reader.uint4(at('baseColor'))[3];
    expect(reader.float4(at('baseColor')).slice(0, 3)).toEqual([0.1, 0.2, 0.3].map(Math.fround));
    expect(baseColor >>> 29).toBe(4);
    expect(reader.float4(at('roughness'))[0]).toBe(0.25);
    expect(reader.uint4(at('roughness'))[3] >>> 29).toBe(1);
    expect(reader.uint4(at('metallic'))[3] >>> 29).toBe(0);
    expect(reader.uint4(at('specular'))[3]).toBe(0);

    const use = baseColor & 0x1fffffff;
    const [texels, width, height, settings] = reader.uint4(use);
    expect([width, height, settings]).toEqual([1, 2, 1]);
    // The lowest row first; red in the lowest byte.
    expect([...reader.uints.subarray(texels, texels + 2)]).toEqual([0x8000ff00, 0xff0000ff]);
    expect(reader.float4(use + 1)).toEqual([2, 0, 0.5, 0]);
    expect(reader.float4(use + 2).map((x) => x + 0)).toEqual([0, 3, 0, 0]);
    const roughness = reader.uint4(at('roughness'))[3] & 0x1fffffff;
    expect(reader.uint4(roughness)).toEqual([texels, 1, 2, (1 << 4) | (1 << 8)]);
    const maps = reader.uint4(slot + 3);
    expect(maps[0]).toBe(reader.uint4(at('metallic'))[3] & 0x1fffffff);
    expect(maps[1]).toBe(0);
    expect(maps[2]).toBe(use);
    expect(maps[3]).toBe(maps[0]);
    expect(reader.uint4(slot + 4)[0]).toBe(3);
    // sRGB to linear.
    const table = reader.uint4(1)[3];
    expect(reader.floats[table + 255]).toBe(1);
    expect(reader.floats[table + 128]).toBeCloseTo(0.2158605, 6);
  });

  test('that are opaque or cut nothing off need not be asked', async () => {
    const map = { asset: 'image' };
    const png = await sharp({ create: { width: 1, height: 1, channels: 3, background: 'red' } })
      .png()
      .toBuffer();
    const reader = new Reader(
      await pack(
        documentOf({
          assets: { image: { name: 'image', mediaType: 'image/png', data: png.toString('base64') } },
          materials: {
            opaque: { model: 'principled', opacity: 0.5, opacityMap: map },
            whole: { model: 'principled', alphaMode: 'mask', alphaCutoff: 0 },
            blend: { model: 'lambert', alphaMode: 'blend', opacity: 0.5, doubleSided: true },
          },
          objects: Object.fromEntries(
            ['opaque', 'whole', 'blend'].map((id) => [id, { material: id, geometry: { type: 'plane' } }]),
          ),
        }),
      ),
    );
    expect([0, 1, 2].map((i) => reader.uint4(reader.material(i))[1])).toEqual([0, 0, 1 | 4]);
    expect([0, 1, 2].map((i) => reader.float4(reader.material(i) + 1)[3])).toEqual([1, 1, 0.5]);
    expect(reader.uint4(reader.material(0) + 3)[3]).toBe(0);
    expect(reader.uint4(reader.material(2))[0]).toBe(1);
  });
});

describe('an edit', () => {
  const document = documentOf({
    materials: plain,
    objects: {
      a: { material: 'm', geometry: { type: 'sphere' } },
      b: { material: 'm', geometry: { type: 'torus' } },
    },
    lights: { l: { type: 'point' } },
  });
  const with_ = <K extends 'objects' | 'materials'>(key: K, id: string, change: object): Document => ({
    ...document,
    [key]: { ...document[key], [id]: { ...document[key][id], ...change } },
  });

  test('of a material or a transform builds no mesh, and moves none in memory', async () => {
    const packer = new ScenePacker(assets);
    const before = await packer.pack(document);
    const build = vi.spyOn(meshes, 'packMesh');
    const meshOf = ({ words }: PackedScene) => {
      const reader = new Reader({ words });
      return [0, 1].map((i) => reader.uint4(reader.instance(i) + 6)[0]);
    };
    for (const edited of [
      with_('materials', 'm', { parameters: { roughness: 0.125 } }),
      with_('objects', 'a', { position: [1, 2, 3] }),
    ]) {
      const after = await packer.pack(edited);
      expect(meshOf(after)).toEqual(meshOf(before));
      expect(after.words.length).toBe(before.words.length);
      expect(after.words).not.toEqual(before.words);
    }
    expect(build).not.toHaveBeenCalled();
    const same = await packer.pack(document);
    expect(same.words).toEqual(before.words);
    await packer.pack(with_('objects', 'a', { geometry: { type: 'box', ...boxFields } }));
    expect(build).toHaveBeenCalledTimes(1);
  });
});

const boxFields = { width: 1, height: 1, depth: 1, widthSegments: 1, heightSegments: 1, depthSegments: 1 };

describe('limits', () => {
  const segments = 400;
  const fine = documentOf({
    materials: plain,
    objects: {
      o: {
        name: 'Fine',
        material: 'm',
        geometry: { type: 'plane', widthSegments: segments, heightSegments: segments },
      },
    },
  });

  test('memory: a scene beyond it is refused with both figures, before its trees are built', async () => {
    const build = vi.spyOn(meshes, 'packMesh');
    const packing = new ScenePacker(assets).pack(fine, { maxBytes: 20e6 });
    await expect(packing).rejects.toThrow(PathTracerError);
    await expect(packing).rejects.toThrow(/320000 triangles take at least \d{8} bytes.*limit is 20000000/);
    expect(build).not.toHaveBeenCalled();
    // Far too many are not even made.
    const make = vi.spyOn(primitives, 'createPrimitive');
    await expect(new ScenePacker(assets).pack(fine, { maxBytes: 2e6 })).rejects.toThrow(
      /about 320000 triangles.*limit is 2000000/,
    );
    expect(make).not.toHaveBeenCalled();
    await expect(pack_(createDocument(), 100)).rejects.toThrow(/takes \d+ bytes.*limit is 100$/);
  });

  const pack_ = (document: Document, maxBytes: number) =>
    new ScenePacker(assets).pack(document, { maxBytes });

  test('work: it rests for others, tells how far it is, and can be stopped', async () => {
    const parts: number[] = [];
    let others = 0;
    const timer = setInterval(() => {
      others += 1;
    }, 1);
    const controller = new AbortController();
    const packing = new ScenePacker(assets).pack(fine, {
      signal: controller.signal,
      onProgress(part) {
        parts.push(part);
        if (part > 0.1) controller.abort();
      },
    });
    await expect(packing).rejects.toMatchObject({ name: 'AbortError' });
    clearInterval(timer);
    expect(others).toBeGreaterThan(2);
    expect(parts.length).toBeGreaterThan(1);
    expect(parts).toEqual([...parts].sort((a, b) => a - b));
    expect(parts.at(-1)).toBeLessThan(0.5);
    const stopped = new ScenePacker(assets).pack(createDocument(), { signal: AbortSignal.abort() });
    await expect(stopped).rejects.toMatchObject({ name: 'AbortError' });
  });
});

describe('hostile scenes', () => {
  test('with nothing in them are trees without leaves', async () => {
    const scene = await pack(documentOf({}));
    const reader = new Reader(scene);
    expect(reader.instances).toBe(0);
    expect(reader.trace([0, 0, 5], [0, 0, -1])).toBeNull();
    expect(scene).toMatchObject({ triangles: 0, lights: 0, models: [] });
    expectNoNaN(scene);
  });

  test('with hidden, flat and vanishing objects', async () => {
    const geometry = { type: 'box' };
    const scales = { point: [0, 0, 0], line: [1, 0, 0], flat: [1, 0, 2], tiny: [1e-30, 1e-30, 1e-30] };
    const scene = await pack(
      documentOf({
        materials: plain,
        objects: {
          hidden: { material: 'm', geometry, visible: false },
          ...Object.fromEntries(
            Object.entries(scales).map(([id, scale]) => [id, { material: 'm', geometry, scale }]),
          ),
        },
      }),
    );
    const reader = new Reader(scene);
    expect(reader.instances).toBe(1);
    expectNoNaN(scene);
    expect(reader.trace([0.3, 5, 0.3], [0, -1, 0])?.distance).toBeCloseTo(5, 4);
  });

  test('with triangles without area, far away, or of vertices that are not there', async () => {
    const pace = new Pace();
    const mesh = (positions: number[], index: number[] | null, normals?: number[]) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
      if (normals) geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(normals), 3));
      geometry.setIndex(index);
      return meshes.packMesh(geometry, 2 ** 32, pace);
    };
    const triangle = [0, 0, 0, 1, 0, 0, 0, 1, 0];
    const degenerate = await mesh(triangle, [0, 1, 1, 0, 0, 0, 0, 1, 2]);
    expect(degenerate).toMatchObject({ triangles: 3, blocks: 1 });
    expect((await mesh([0, 0, 0, 1, 1, 1, 2, 2, 2], null)).bounds).toBeNull();
    expect((await mesh([], null)).bounds).toBeNull();
    const far = await mesh(
      triangle.map((x) => 1e30 * x),
      null,
    );
    expect([...far.bounds!].every(Number.isFinite)).toBe(true);
    const bad = await mesh(triangle, null, [Number.NaN, 0, 0, 0, 0, 0, 0, 0, 5]);
    const floats = new Float32Array(bad.words.buffer);
    for (let vertex = 0; vertex < 3; vertex += 1)
      expect([...floats.subarray(4 * (bad.words[1]! + 2 * vertex)).subarray(0, 3)]).toEqual([0, 0, 1]);
    await expect(mesh(triangle, [0, 1, 3])).rejects.toThrow(/triangle 0 has the vertex 3, but there are 3/);
    await expect(mesh([...triangle.slice(1), Number.NaN], null)).rejects.toThrow(/vertex 2 is not finite/);
    pace.end();
  });
});
