import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { Pace } from '../../../src/pathtracer/scene/pace.ts';
import { ScenePacker } from '../../../src/pathtracer/scene/pack.ts';
import {
  readSkyMap,
  type SkyDistribution,
  type SkyMap,
  skyDistribution,
} from '../../../src/pathtracer/scene/sky.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { parseDocument } from '../../../src/scene/document.ts';
import { Reader, sequence } from './reader.ts';

const NONE = 0xffffffff;
const dark = { upper: [0, 0, 0] as [number, number, number], lower: [0, 0, 0] as [number, number, number] };

async function distributionOf(...[map, intensity, uniform]: [SkyMap | null, number, typeof dark]) {
  const pace = new Pace();
  try {
    return await skyDistribution(map, intensity, uniform, pace);
  } finally {
    pace.end();
  }
}

/** The density of a cell over the unit square. */
function density({ width, height, marginal, conditional }: SkyDistribution, x: number, y: number): number {
  const row = y * (width + 1) + x;
  return (conditional[row + 1]! - conditional[row]!) * width * (marginal[y + 1]! - marginal[y]!) * height;
}

function checkDistributionFunctions({ width, height, marginal, conditional }: SkyDistribution): void {
  const rows = [marginal];
  for (let y = 0; y < height; y += 1) rows.push(conditional.subarray(y * (width + 1), (y + 1) * (width + 1)));
  for (const row of rows) {
    expect(row[0]).toBe(0);
    expect(row.at(-1)).toBe(1);
    for (let i = 1; i < row.length; i += 1) expect(row[i]!).toBeGreaterThanOrEqual(row[i - 1]!);
  }
}

const gray = (width: number, height: number, value: (x: number, y: number) => number): SkyMap => {
  const texels = new Float32Array(4 * width * height);
  for (let i = 0; i < width * height; i += 1)
    texels.fill(value(i % width, Math.floor(i / width)), 4 * i, 4 * i + 3);
  return { texels, width, height };
};

describe('the distribution of the sky', () => {
  test('of even light is even over the sphere, as far as its rows are fine', async () => {
    const distribution = await distributionOf(null, 1, { upper: [1, 1, 1], lower: [1, 1, 1] });
    checkDistributionFunctions(distribution);
    // The mean of the cosine of the latitude over v.
    expect(distribution.integral).toBeCloseTo(2 / Math.PI, 6);
    for (let y = 0; y < distribution.height; y += 1) {
      const latitude = Math.PI * ((y + 0.5) / distribution.height - 0.5);
      const perSteradian = density(distribution, 0, y) / (2 * Math.PI ** 2 * Math.cos(latitude));
      expect(perSteradian * 4 * Math.PI).toBeCloseTo(1, 2);
    }
  });

  test('is in proportion to luminance times the cosine of the latitude', async () => {
    const random = sequence(5);
    const map = gray(96, 66, () => random() ** 4 * 20);
    const distribution = await distributionOf(map, 0.5, { upper: [0.2, 0.2, 0.2], lower: [0.1, 0.1, 0.1] });
    expect([distribution.width, distribution.height]).toEqual([96, 66]);
    checkDistributionFunctions(distribution);
    const texel = (x: number, y: number) =>
      map.texels[4 * (Math.min(Math.max(y, 0), 65) * 96 + ((x + 96) % 96))]!;
    let sum = 0;
    for (let y = 0; y < 66; y += 1)
      for (let x = 0; x < 96; x += 1) {
        // The integral over the cell of what is read between texels.
        let mean = 0;
        for (const [dx, wx] of [
          [-1, 1 / 8],
          [0, 6 / 8],
          [1, 1 / 8],
        ] as const)
          for (const [dy, wy] of [
            [-1, 1 / 8],
            [0, 6 / 8],
            [1, 1 / 8],
          ] as const)
            mean += wx * wy * texel(x + dx, y + dy);
        const latitude = Math.PI * ((y + 0.5) / 66 - 0.5);
        const f = (0.5 * mean + (y < 33 ? 0.1 : 0.2)) * Math.cos(latitude);
        sum += f;
        expect((density(distribution, x, y) * distribution.integral) / f).toBeCloseTo(1, 2);
      }
    expect(distribution.integral / (sum / (96 * 66))).toBeCloseTo(1, 3);
  });

  test('of large maps is smaller, and no light falls between its cells', async () => {
    const map = gray(2100, 1050, (x, y) => (x === 1047 && y === 524 ? 1e6 : 0));
    const distribution = await distributionOf(map, 1, dark);
    expect([distribution.width, distribution.height]).toEqual([1024, 512]);
    const lit: [number, number][] = [];
    for (let y = 0; y < 512; y += 1)
      for (let x = 0; x < 1024; x += 1) if (density(distribution, x, y) > 0) lit.push([x, y]);
    // Bilinear filtering spreads the texel over (1046.5, 523.5) to (1048.5, 525.5).
    for (const [u, v] of [
      [1046.6, 523.6],
      [1048.4, 525.4],
      [1046.6, 525.4],
    ] as const) {
      const cell = [Math.floor((u / 2100) * 1024), Math.floor((v / 1050) * 512)];
      expect(lit).toContainEqual(cell);
    }
    expect(lit.length).toBeLessThan(10);
  });

  test('of darkness is none', async () => {
    expect((await distributionOf(null, 1, dark)).integral).toBe(0);
    expect(
      (
        await distributionOf(
          gray(4, 2, () => 1),
          0,
          dark,
        )
      ).integral,
    ).toBe(0);
  });
});

describe('the map', () => {
  test('has its bottom row first, however the file has it, and only numbers that can be summed', () => {
    const texture = (type: THREE.TextureDataType, data: Float32Array | Uint16Array, flipY: boolean) => {
      const made = new THREE.DataTexture(data, 1, 2, THREE.RGBAFormat, type);
      made.flipY = flipY;
      return made;
    };
    const rows = [1, 2, 3, 1, Number.NaN, -1, Number.POSITIVE_INFINITY, 1];
    const float = texture(THREE.FloatType, Float32Array.from(rows), false);
    expect([...readSkyMap(float).texels]).toEqual([1, 2, 3, 1, 0, 0, 65504, 1]);
    const half = texture(THREE.HalfFloatType, Uint16Array.from(rows, THREE.DataUtils.toHalfFloat), true);
    expect([...readSkyMap(half).texels.subarray(4)]).toEqual([1, 2, 3, 1]);
  });
});

describe('the document’s sky', () => {
  const assets = new AssetLoader(nodeAssets);
  const read = async (parts: object) =>
    new Reader(
      await new ScenePacker(assets).pack(parseDocument({ format: 'irradia', version: 1, ...parts }, 'test')),
    );

  test('gathers environment, ambient and hemisphere lights', async () => {
    const reader = await read({
      environment: { source: { type: 'constant', color: [0.5, 0.25, 1] }, intensity: 3, rotation: 30 },
      background: { type: 'environment', blur: 0 },
      lights: {
        ambient: { type: 'ambient', luminance: 2, color: [1, 0, 0] },
        hemisphere: { type: 'hemisphere', luminance: 1, color: [0, 1, 0], groundColor: [0, 0, 1] },
        sun: { type: 'directional' },
      },
    });
    const [first, count, sky, index] = reader.uint4(2);
    expect([count, index]).toEqual([2, 1]);
    expect(reader.uint4(first + 6)[0]).toBe(5);
    expect(reader.float4(3)).toEqual([0, 0, 0, 1]);
    expect(reader.float4(4)).toEqual([2, 1, 0, 0]);
    expect(reader.float4(5)).toEqual([2, 0, 1, 0]);
    const [width, height, texels] = reader.uint4(sky);
    expect([width, height]).toEqual([1, 1]);
    expect(reader.float4(texels)).toEqual([0.5, 0.25, 1, 1]);
    const [intensity, cos, sin] = reader.float4(sky + 2);
    expect(intensity).toBe(3);
    expect(cos).toBeCloseTo(Math.cos(Math.PI / 6));
    expect(sin).toBeCloseTo(0.5);
    const [columns, rows, marginal, conditional] = reader.uint4(sky + 1);
    expect([columns, rows]).toEqual([1, 64]);
    expect([reader.floats[marginal], reader.floats[marginal + rows]]).toEqual([0, 1]);
    expect([...reader.floats.subarray(conditional, conditional + 2)]).toEqual([0, 1]);
  });

  test('is not there where nothing shines', async () => {
    const reader = await read({ background: { type: 'color', color: [0.25, 0.5, 1] } });
    expect(reader.uint4(2).slice(1)).toEqual([0, 0, NONE]);
    expect(reader.float4(3)).toEqual([0.25, 0.5, 1, 0]);
  });

  test('a shipped environment is kept from one packing to the next', async () => {
    const packer = new ScenePacker(assets);
    const document = parseDocument(
      {
        format: 'irradia',
        version: 1,
        environment: { source: { type: 'preset', name: 'studio' }, intensity: 1 },
      },
      'test',
    );
    const reader = new Reader(await packer.pack(document));
    const sky = reader.uint4(2)[2];
    const [width, height, texels] = reader.uint4(sky);
    expect(width).toBe(2 * height);
    const all = reader.floats.subarray(4 * texels, 4 * (texels + width * height));
    expect(all.every((value) => value >= 0 && value < 1e5)).toBe(true);
    expect(Math.max(...all.subarray(0, 4 * width))).toBeGreaterThan(0);
    const turned = await packer.pack({ ...document, environment: { ...document.environment, rotation: 90 } });
    expect(turned.words.length).toBe(reader.uints.length);
  });
});
