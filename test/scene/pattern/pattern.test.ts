import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../../src/cli/node-assets.ts';
import { srgbToLinear } from '../../../src/color/srgb.ts';
import { AssetLoader } from '../../../src/scene/assets.ts';
import { encodeBase64 } from '../../../src/scene/base64.ts';
import { fieldInfo } from '../../../src/scene/fields.ts';
import { COLOR, NORMALS, PATTERN_TYPE, patternNames, SURFACE } from '../../../src/scene/pattern/asset.ts';
import { drawPattern, MEAN_ROUGHNESS } from '../../../src/scene/pattern/draw.ts';
import type { Point } from '../../../src/scene/pattern/kind.ts';
import { gradientNoise, hash } from '../../../src/scene/pattern/noise.ts';
import {
  defaultPattern,
  kindOf,
  type Pattern,
  patternAsset,
  readPattern,
  shapeOf,
} from '../../../src/scene/pattern/pattern.ts';

const small = (pattern: (typeof patternNames)[number], values: object = {}): Pattern => ({
  ...defaultPattern(pattern),
  size: 64,
  ...values,
});

function mean(data: Uint8Array, channel: number, of: (value: number) => number): number {
  let sum = 0;
  for (let i = channel; i < data.length; i += 4) sum += of(data[i]! / 255);
  return (4 * sum) / data.length;
}

/** Of 64 x 64 texels: the pictures of documents that people keep do not change. */
const CHECKSUMS: Readonly<Record<string, number>> = {
  wood: 903747162,
  marble: 3781002528,
  granite: 3560137953,
  concrete: 321326644,
  weave: 379795973,
  leather: 1437708790,
  brushed: 1992789507,
};

const checksum = (data: Uint8Array): number => data.reduce((sum, byte, i) => hash(byte, i, sum), 0);

describe.each(patternNames)('the pattern %s', (name) => {
  test('goes on at its edges, in both directions', () => {
    const sample = kindOf(name).sampler(small(name) as never);
    const at = (u: number, v: number): number[] => {
      const point: Point = { red: 0, green: 0, blue: 0, height: 0, roughness: 0 };
      sample(u, v, point);
      return Object.values(point);
    };
    for (let i = 0; i < 400; i++) {
      const [u, v] = [hash(i, 0, 1) / 2 ** 32, hash(i, 1, 1) / 2 ** 32];
      for (const [du, dv] of [
        [1, 0],
        [0, 1],
        [-1, -1],
      ] as const) {
        const there = at(u + du, v + dv);
        for (const [k, value] of at(u, v).entries()) expect(there[k]).toBeCloseTo(value, 6);
      }
    }
  });

  test('has the mean colour that it is given, and the mean roughness', () => {
    for (const color of [
      [0.83, 0.79, 0.75],
      [0.3, 0.165, 0.07],
      [0.016, 0.012, 0.01],
    ] as const) {
      const pattern = small(name, { color });
      const { data } = drawPattern(pattern, COLOR);
      for (const [c, value] of color.entries()) {
        // A byte is a step of 3 % where it is darkest.
        const found = mean(data, c, srgbToLinear);
        expect(Math.abs(found - value), `${c}`).toBeLessThan(0.003 * value + 1e-4);
      }
      expect(mean(data, 3, (alpha) => alpha)).toBe(1);
    }
    expect(mean(drawPattern(small(name), SURFACE).data, 1, Number)).toBeCloseTo(MEAN_ROUGHNESS, 2);
  });

  test('is the same for the same numbers, and another for another seed', () => {
    const draw = (values?: object) => checksum(drawPattern(small(name, values), COLOR).data);
    const first = draw();
    expect(draw({ seed: 2 })).not.toBe(first);
    expect(draw()).toBe(first);
    expect(first).toBe(CHECKSUMS[name]);
  });

  test('has no slider without an effect, and no sum that is no number', () => {
    const usual = small(name, { size: 32 });
    const pictures = (pattern: Pattern) =>
      [COLOR, NORMALS, SURFACE].map((texture) => checksum(drawPattern(pattern, texture).data)).join();
    const before = pictures(usual);
    for (const [field, schema] of Object.entries(shapeOf(name))) {
      const info = fieldInfo(schema as never)!;
      const isColor = info.kind === 'color';
      const values = isColor
        ? [
            [0, 0, 0],
            [1, 0.2, 0.9],
          ]
        : field === 'size'
          ? [16]
          : [info.min!, info.max!];
      const changes = values.map((value) => {
        const pattern = small(name, { size: 32, [field]: value });
        const sample = kindOf(name).sampler(pattern as never);
        const point: Point = { red: 0, green: 0, blue: 0, height: 0, roughness: 0 };
        for (let i = 0; i < 50; i++) {
          sample(hash(i, 2, 1) / 2 ** 32, hash(i, 3, 1) / 2 ** 32, point);
          expect(Object.values(point).every(Number.isFinite), `${field} = ${value}`).toBe(true);
        }
        return pictures(pattern) !== before;
      });
      expect(changes, field).toContain(true);
    }
  });

  test('is flat where it has no relief, and else leans both ways alike', () => {
    expect(drawPattern(small(name, { relief: 0 }), NORMALS).data.slice(0, 4)).toEqual(
      Uint8Array.of(128, 128, 255, 255),
    );
    const { data } = drawPattern(small(name), NORMALS);
    for (const c of [0, 1]) expect(Math.abs(mean(data, c, Number) - 0.5)).toBeLessThan(0.02);
  });
});

test('noise is as large as it is said to be, and nothing at the points of its lattice', () => {
  let most = 0;
  for (let i = 0; i < 20_000; i++)
    most = Math.max(
      most,
      Math.abs(gradientNoise(hash(i, 0, 5) / 2 ** 28, hash(i, 1, 5) / 2 ** 28, 16, 16, 1)),
    );
  expect(most).toBeGreaterThan(0.8);
  expect(most).toBeLessThanOrEqual(1);
  for (let i = 0; i < 16; i++) expect(gradientNoise(i, 3, 16, 16, 1)).toBe(0);
});

describe('a pattern from a stranger', () => {
  const refused = (text: string) => {
    try {
      readPattern(new TextEncoder().encode(text), 'hall');
    } catch (error) {
      return (error as Error).message;
    }
    return 'taken';
  };

  test.each([
    ['', 'hall: not JSON'],
    ['[1]', 'hall: expected a JSON object'],
    ['{"pattern":"__proto__"}', 'hall: pattern: expected wood'],
    ['{"pattern":"wood","size":1e9}', 'hall: size: '],
    ['{"pattern":"wood","size":100000}', 'hall: size: '],
    ['{"pattern":"weave","repeats":65}', 'hall: repeats: '],
    ['{"pattern":"wood","rings":2.5}', 'hall: rings: '],
    ['{"pattern":"wood","color":[1,2]}', 'hall: color'],
    ['{"pattern":"wood","colour":[1,1,1]}', 'hall: colour: there is no such field'],
    [`{"pattern":"wood","x":"${'a'.repeat(5000)}"}`, 'hall: too long'],
  ])('%.40s is refused, with the field', (text, message) => {
    expect(refused(text)).toContain(message);
  });

  test('that is right gets what it left out', () => {
    const read = readPattern(new TextEncoder().encode('{"pattern":"wood","rings":3}'), 'hall');
    expect(read).toEqual({ ...defaultPattern('wood'), rings: 3 });
  });

  test('is an image like any other, and says what is wrong with it', async () => {
    const assets = new AssetLoader(nodeAssets);
    const pattern = small('marble');
    const image = await assets.image(patternAsset(pattern), null);
    expect('data' in image && checksum(image.data)).toBe(checksum(drawPattern(pattern, COLOR).data));
    const asset = {
      name: 'hall',
      mediaType: PATTERN_TYPE,
      data: encodeBase64(new TextEncoder().encode('{"pattern":1}')),
    };
    await expect(assets.image(asset, null)).rejects.toThrow('hall: pattern: expected wood');
    await expect(assets.image(patternAsset(pattern), 3)).rejects.toThrow('has no picture 3');
  });
});
