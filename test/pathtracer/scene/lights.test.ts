import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { temperatureColor } from '../../../src/lights/units.ts';
import { groupCost, type LightBounds, uniteLights } from '../../../src/pathtracer/scene/light-bounds.ts';
import { type TreeLight, writeLightTree } from '../../../src/pathtracer/scene/light-tree.ts';
import { Pace } from '../../../src/pathtracer/scene/pace.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import { Words } from '../../../src/pathtracer/scene/words.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { SceneMirror } from '../../../src/scene/mirror.ts';
import { Reader, sequence, unitVector, type Vector } from './reader.ts';

const assets = new AssetLoader(nodeAssets);
const documentOf = (parts: object) => parseDocument({ format: 'irradia', version: 1, ...parts }, 'test');
const read = async (parts: object) => new Reader(await new ScenePacker(assets).pack(documentOf(parts)));

const close = (actual: readonly number[], expected: readonly number[]): void => {
  expect(actual.length).toBe(expected.length);
  for (const [i, value] of expected.entries()) expect(actual[i]).toBeCloseTo(value, 5);
};

const NONE = 0xffffffff;

describe('the document’s lights', () => {
  test('keep their units, colours and places', async () => {
    const position = [1, 2, 3];
    const reader = await read({
      lights: {
        point: {
          type: 'point',
          intensity: 8,
          color: [1, 0.5, 0],
          position,
          falloff: 'linear',
          range: 2,
          radius: 0.25,
        },
        spot: {
          type: 'spot',
          intensity: 3,
          temperature: 3000,
          position,
          target: [1, 2, 0],
          cutoff: 60,
          exponent: 5,
          penumbra: 0.5,
        },
        sun: {
          type: 'directional',
          illuminance: 4,
          position: [0, 3, 4],
          angularDiameter: 90,
          castShadow: false,
        },
      },
    });
    expect(reader.uint4(1)[2]).toBe(2);
    expect(reader.uint4(2)[1]).toBe(1);
    expect(reader.uint4(2)[3]).toBe(NONE);
    const point = reader.light(0);
    expect(reader.uint4(point).slice(0, 2)).toEqual([0, 1]);
    close(reader.float4(point + 1), [8, 4, 0, 0.25]);
    expect(reader.uint4(point)[2]).toBe(0);
    close(reader.float4(point + 2), [1, 2, 3, 1 / 16]);
    const spot = reader.light(1);
    expect(reader.uint4(spot).slice(0, 2)).toEqual([1, 0]);
    close(
      reader.float4(spot + 1).slice(0, 3),
      temperatureColor(3000).map((c) => 3 * c),
    );
    close(reader.float4(spot + 3), [0, 0, -1, 0.5]);
    close(reader.float4(spot + 4), [5, 1 / (Math.cos(Math.PI / 6) - 0.5), 0, 0]);
    const sun = reader.infiniteLight(0);
    // It passes through everything.
    expect([reader.uint4(sun)[0], reader.uint4(sun)[2]]).toEqual([4, 1]);
    close(reader.float4(sun + 1), [4, 4, 4, Math.tan(Math.PI / 4)]);
    close(reader.float4(sun + 2), [0, 0.6, 0.8, 0]);
  });

  test.each([
    [
      [0, 2, 0],
      [0, 0, 0],
    ],
    [
      [1, 2, 3],
      [0.5, -1, 2],
    ],
    [
      [1, 1, 1],
      [1, 1, 1],
    ],
  ])('a rectangle at %j towards %j lies as three.js turns it', async (position, target) => {
    const light = { type: 'rectangle', luminance: 5, position, target, width: 2, height: 3 };
    const parts = { lights: { light } };
    const reader = await read(parts);
    const mirror = new SceneMirror({ assets, onError: () => {} });
    mirror.apply(documentOf(parts));
    const three = mirror.lightFor('light') as THREE.RectAreaLight;
    three.updateMatrixWorld();
    const rotation = new THREE.Matrix4().extractRotation(three.matrixWorld);
    const turned = (x: number, y: number, z: number) =>
      new THREE.Vector3(x, y, z).applyMatrix4(rotation).toArray();
    const slot = reader.light(0);
    close(reader.float4(slot + 1), [5, 5, 5, 0]);
    close(reader.float4(slot + 2).slice(0, 3), position);
    close(reader.float4(slot + 3), [...turned(0, 0, -1), 6]);
    close(reader.float4(slot + 4).slice(0, 3), turned(1, 0, 0));
    close(reader.float4(slot + 5).slice(0, 3), turned(0, 1.5, 0));
  });

  test('that are hidden, black, off or point nowhere are left out', async () => {
    const reader = await read({
      lights: {
        hidden: { type: 'point', visible: false },
        black: { type: 'point', color: [0, 0, 0] },
        off: { type: 'rectangle', luminance: 0 },
        nowhere: { type: 'spot', position: [1, 1, 1], target: [1, 1, 1] },
        noDirection: { type: 'directional', position: [1, 1, 1], target: [1, 1, 1] },
        dark: { type: 'ambient', luminance: 0 },
      },
    });
    expect(reader.uint4(1).slice(1, 3)).toEqual([0, 0]);
    expect(reader.uint4(2)).toEqual([reader.uint4(2)[0], 0, 0, NONE]);
  });
});

describe('what emits', () => {
  const materials = {
    lamp: { model: 'principled', emissive: [1, 0.5, 0], emissiveIntensity: 6 },
    dark: { model: 'principled' },
  };
  const geometry = { type: 'plane', width: 2, height: 2 };

  test('is a light for each triangle, in the world, on the side that is seen', async () => {
    const reader = await read({
      materials: { ...materials, lamp: { ...materials.lamp, doubleSided: true } },
      lights: { point: { type: 'point' } },
      objects: {
        dark: { geometry, material: 'dark' },
        lamp: { geometry, material: 'lamp', position: [0, 3, 0], rotation: [90, 0, 0], scale: [2, 1, 1] },
      },
    });
    expect(reader.uint4(1)[2]).toBe(3);
    expect(reader.uint4(reader.instance(0) + 6)[3]).toBe(NONE);
    const [, material, , first] = reader.uint4(reader.instance(1) + 6);
    expect(first).toBe(1);
    expect(reader.uint4(material)[1]).toBe(1 | 8);
    close(reader.float4(material + 1), [6, 3, 0, 1]);
    for (const triangle of [0, 1]) {
      const slot = reader.light(1 + triangle);
      expect(reader.uint4(slot).slice(0, 3)).toEqual([3, 1, triangle]);
      close(reader.float4(slot + 1), [6, 3, 0, 1]);
      expect(reader.float4(slot + 3)[3]).toBeCloseTo(4);
      for (const corner of [2, 3, 4]) expect(reader.float4(slot + corner)[1]).toBeCloseTo(3);
    }
    // Two-sided in the tree, about the normal that looks down.
    const leaf = reader.uint4(1)[1];
    const trails = reader.lightLeaves();
    expect(trails.map(({ light }) => light).sort()).toEqual([0, 1, 2]);
    expect(reader.uint4(leaf + 3)[3]).toBe(1);
  });

  test('shines to the side that a mirrored object shows', async () => {
    for (const scale of [
      [1, 1, 1],
      [-1, 1, 1],
    ]) {
      const reader = await read({
        materials,
        objects: { lamp: { geometry, material: 'lamp', scale } },
      });
      const axis = reader.float4(reader.uint4(1)[1] + 2);
      close(axis, [0, 0, 1, 0]);
    }
  });

  test('has a texture’s mean as its power, and none where that is black', async () => {
    // Two texels, the left one white and the right one black, over the two triangles of each of two planes.
    const { default: sharp } = await import('sharp');
    const png = await sharp(Buffer.from([255, 255, 255, 0, 0, 0]), {
      raw: { width: 2, height: 1, channels: 3 },
    })
      .png()
      .toBuffer();
    const map = { asset: 'image', colorSpace: 'srgb', wrap: 'clamp' };
    const power = async (texture: object): Promise<number[]> => {
      const reader = await read({
        assets: { image: { name: 'image', mediaType: 'image/png', data: png.toString('base64') } },
        materials: { lamp: { ...materials.lamp, emissiveMap: { ...map, ...texture } } },
        objects: { lamp: { geometry, material: 'lamp' } },
      });
      return reader.lightLeaves().map(({ light, trail }) => {
        expect(reader.uint4(reader.light(light))[3]).toBe(trail);
        let node = reader.uint4(1)[1];
        for (let rest = trail; reader.uint4(node + 3)[2] === 0; rest >>>= 1)
          node = reader.uint4(node + 3)[rest & 1] as number;
        return reader.float4(node)[3];
      });
    };
    const luminance = 0.2126 * 6 + 0.7152 * 3;
    const even = await power({});
    expect((even[0]! + even[1]!) / (Math.PI * 4 * luminance)).toBeCloseTo(0.5, 1);
    expect(await power({ offset: [1, 0] })).toEqual([]);
  });
});

describe('the tree of lights', () => {
  const random = sequence(7);
  const lights = Object.fromEntries(
    Array.from({ length: 60 }, (_, i) => {
      const position = [10 * random(), 4 * random(), 10 * random()];
      const target = [10 * random(), -2, 10 * random()];
      const type = (['point', 'spot', 'rectangle'] as const)[i % 3];
      const strength = type === 'rectangle' ? { luminance: 5 * random() } : { intensity: 5 * random() };
      return [`l${i}`, { type, position, ...(type === 'point' ? {} : { target }), ...strength }];
    }),
  );

  test('chooses each light with a probability, which add up to 1; trails lead to their lights', async () => {
    const reader = await read({ lights });
    const leaves = reader.lightLeaves();
    expect(leaves.map(({ light }) => light).sort((a, b) => a - b)).toEqual(
      Array.from({ length: 60 }, (_, i) => i),
    );
    for (const { light, trail, depth } of leaves) {
      expect(reader.uint4(reader.light(light))[3]).toBe(trail);
      expect(depth).toBeLessThanOrEqual(31);
    }
    for (let i = 0; i < 50; i += 1) {
      const p = unitVector(random).map((x, axis) => 5 + 8 * x + (axis === 1 ? 3 : 0)) as Vector;
      const probabilities = reader.lightProbabilities(p);
      const sum = [...probabilities.values()].reduce((a, b) => a + b, 0);
      // What is left is at nodes none of whose lights shines this way.
      expect(sum).toBeLessThanOrEqual(1 + 1e-9);
      if (probabilities.size === 60) expect(sum).toBeCloseTo(1, 9);
      // Points shine everywhere.
      for (let light = 0; light < 60; light += 1)
        if (reader.uint4(reader.light(light))[0] === 0) expect(probabilities.get(light)).toBeGreaterThan(0);
    }
  });

  test('of points alone gives every light its share everywhere', async () => {
    const points = Object.fromEntries(Object.entries(lights).filter((_, i) => i % 3 === 0));
    const reader = await read({ lights: points });
    for (let i = 0; i < 50; i += 1) {
      const probabilities = reader.lightProbabilities(unitVector(random).map((x) => 20 * x) as Vector);
      expect(probabilities.size).toBe(20);
      expect([...probabilities.values()].reduce((a, b) => a + b, 0)).toBeCloseTo(1, 9);
    }
  });

  test('never says 0 of a light that reaches a point', async () => {
    const reader = await read({ lights });
    const reaches = (slot: number, p: Vector): boolean => {
      const [type] = reader.uint4(slot);
      if (type === 0) return true;
      const [place, axis] = [reader.float4(slot + 2), reader.float4(slot + 3)];
      const away = p.map((x, i) => x - place[i]!);
      const cosine = away.reduce((sum, x, i) => sum + x * axis[i]!, 0) / Math.hypot(...away);
      return cosine > (type === 1 ? axis[3] : 0) + 1e-4;
    };
    for (let i = 0; i < 200; i += 1) {
      const p = unitVector(random).map((x) => 5 + 7 * x) as Vector;
      const probabilities = reader.lightProbabilities(p);
      for (let light = 0; light < 60; light += 1)
        if (reaches(reader.light(light), p)) expect(probabilities.get(light) ?? 0).toBeGreaterThan(0);
    }
  });

  test('is at most 31 deep, however the lights lie', async () => {
    const bounds = (x: number): LightBounds => ({
      box: [x, 0, 0, x, 0, 0],
      axis: [0, 0, 1],
      cosNormals: -1,
      cosEmission: 0,
      power: x,
      twoSided: false,
    });
    const many = Array.from({ length: 900 }, (_, i): TreeLight => ({ light: i, bounds: bounds(1.5 ** i) }));
    const words = new Words();
    const pace = new Pace();
    const trails = new Map<number, number>();
    await writeLightTree(words, many, pace, (light, trail) => trails.set(light, trail));
    pace.end();
    expect(trails.size).toBe(900);
    expect(Math.max(...trails.values())).toBeLessThan(2 ** 31);
  });
});

test('cones around cones hold both; their cost grows', () => {
  const random = sequence(9);
  const some = (): LightBounds => {
    const low = unitVector(random);
    return {
      box: [...low, ...(low.map((x) => x + random()) as Vector)],
      axis: unitVector(random),
      cosNormals: 2 * random() - 1,
      cosEmission: random(),
      power: random(),
      twoSided: false,
    };
  };
  const angleOf = (cosine: number): number => Math.acos(Math.min(Math.max(cosine, -1), 1));
  for (let i = 0; i < 1000; i += 1) {
    const [a, b] = [some(), some()];
    const both = uniteLights(a, b) as LightBounds;
    expect(Math.hypot(...both.axis)).toBeCloseTo(1, 9);
    for (const one of [a, b]) {
      const between = angleOf(one.axis.reduce((sum, x, k) => sum + x * both.axis[k]!, 0));
      expect(Math.min(between + angleOf(one.cosNormals), Math.PI)).toBeLessThan(
        angleOf(both.cosNormals) + 1e-6,
      );
    }
    expect(groupCost(both, 1)).toBeGreaterThanOrEqual(Math.max(groupCost(a, 1), groupCost(b, 1)));
  }
});
