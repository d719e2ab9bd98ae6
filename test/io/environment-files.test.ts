/** Images that light a scene, from strangers: read as Radiance and OpenEXR say, and refused where they are broken. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { ByteWriter } from '../../src/io/bytes.ts';
import { encodeExr } from '../../src/io/exr.ts';
import { checkExr } from '../../src/io/exr-check.ts';
import { fromHalf } from '../../src/io/half.ts';
import { decodeHdr } from '../../src/io/hdr.ts';

const head = (width: number, height: number, lines = 'FORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n') =>
  new TextEncoder().encode(`#?RADIANCE\n# by hand\n${lines}\n-Y ${height} +X ${width}\n`);
const joined = (...parts: (Uint8Array | number[])[]) => Uint8Array.from(parts.flatMap((part) => [...part]));
/** r, g, b of each texel. */
const colors = ({ pixels }: { pixels: Uint16Array }) =>
  Array.from({ length: pixels.length / 4 }, (_, i) => [0, 1, 2].map((c) => fromHalf(pixels[4 * i + c]!)));
const value = (mantissa: number, exponent: number) => (mantissa + 0.5) * 2 ** (exponent - 136);

describe('a Radiance HDR image', () => {
  test('of plain texels', () => {
    const bytes = joined(head(2, 1), [128, 64, 0, 129], [200, 200, 200, 0]);
    expect(colors(decodeHdr(bytes, 'a.hdr'))).toEqual([
      [value(128, 129), value(64, 129), value(0, 129)],
      [0, 0, 0],
    ]);
  });

  test('of rows packed in runs, the first row on top', () => {
    const row = (level: number) => [2, 2, 0, 10, 138, level, 10, ...Array(10).fill(8), 138, 0, 138, 130];
    const found = colors(decodeHdr(joined(head(10, 2), row(100), row(50)), 'a.hdr'));
    expect(found[0]).toEqual([value(100, 130), value(8, 130), value(0, 130)]);
    expect(found[19]).toEqual([value(50, 130), value(8, 130), value(0, 130)]);
  });

  test('of the older runs, which repeat a texel, 256 times as often the second time', () => {
    const texel = [10, 20, 30, 128];
    const bytes = joined(head(300, 1), texel, [1, 1, 1, 43], [1, 1, 1, 1]);
    const found = colors(decodeHdr(bytes, 'a.hdr'));
    expect(found).toHaveLength(300);
    expect(found.every((color) => color[1] === value(20, 128))).toBe(true);
  });

  test('brighter than half floats is as bright as they can be', () => {
    expect(colors(decodeHdr(joined(head(1, 1), [255, 1, 1, 200]), 'a.hdr'))[0]![0]).toBe(65504);
  });

  const packed = (...rest: number[]) => joined(head(8, 1), [2, 2, 0, 8], rest);
  test.each<[string, Uint8Array, string]>([
    ['another file', Uint8Array.of(1, 2, 3), 'byte 0: not a Radiance HDR image'],
    ['no texels', head(4, 4), 'for which the file is too short'],
    ['absurd sizes', joined(head(99999, 99999), [1, 2, 3, 4]), 'an image of 99999 x 99999 texels'],
    ['no size', head(0, 4), 'an image without texels'],
    [
      'XYZ',
      joined(head(1, 1, 'FORMAT=32-bit_rle_xyze\n'), [1, 2, 3, 4]),
      'its texels are in 32-bit_rle_xyze',
    ],
    ['no empty line', new TextEncoder().encode('#?RADIANCE\n-Y 1 +X 1\n'), 'the header does not end'],
    [
      'rows from the bottom',
      new TextEncoder().encode('#?RADIANCE\n\n+Y 1 +X 1\n    '),
      'a size of "+Y 1 +X 1"; expected "-Y height +X width"',
    ],
    ['a row that ends', packed(136, 1, 136), 'the file ends within a row'],
    ['a last run without its value', packed(136, 1, 136, 1, 136, 1, 136), 'the file ends within a row'],
    ['a run too long', packed(137, 1, 1, 1, 1, 1), 'a run of 9 that the row has no room for'],
    ['a run of none', packed(0, 1, 1, 1, 1, 1), 'a run of 0 that'],
    ['another width', joined(head(9, 1), [2, 2, 0, 8, 1, 1, 1, 1]), 'a row of another width'],
    ['a plain row that ends', joined(head(8, 1), [9, 9, 9, 9, 1]), 'the file ends within a row'],
    ['an old run of nothing', joined(head(2, 1), [1, 1, 1, 1]), 'a run of 1 that the row has no room for'],
    ['an old run too long', joined(head(2, 1), [9, 9, 9, 9], [1, 1, 1, 2]), 'a run of 2 that the row'],
  ])('with %s is refused, with the place', (_, bytes, message) => {
    expect(() => decodeHdr(bytes, 'bad.hdr')).toThrow(message);
    expect(() => decodeHdr(bytes, 'bad.hdr')).toThrow(/^bad\.hdr: byte \d+: /);
  });
});

describe('an OpenEXR image', () => {
  const pixels = new Float32Array(32).fill(0.7);
  const channels = ['R', 'G', 'B'].map((name) => ({ name, type: 'half' as const, pixels }));
  const sample = encodeExr({ width: 8, height: 4, channels });
  /** A header of attributes, without chunks. */
  function header(attributes: [name: string, type: string, bytes: number[]][], flags = 0): Uint8Array {
    const writer = new ByteWriter();
    writer.int32(20000630);
    writer.int32(2 | flags);
    for (const [name, type, bytes] of attributes) {
      writer.cString(name);
      writer.cString(type);
      writer.int32(bytes.length);
      writer.bytes(Uint8Array.from(bytes));
    }
    writer.uint8(0);
    return writer.finish();
  }
  const int = (value: number) => [value & 255, (value >> 8) & 255, (value >> 16) & 255, (value >>> 24) & 255];
  const list: [string, string, number[]] = ['channels', 'chlist', [82, 0, ...Array(16).fill(0), 0]];
  const window = (right: number, bottom: number): [string, string, number[]] => [
    'dataWindow',
    'box2i',
    [...int(0), ...int(0), ...int(right), ...int(bottom)],
  ];
  const tiles = (width: number): [string, string, number[]] => [
    'tiles',
    'tiledesc',
    [...int(width), ...int(8), 0],
  ];
  const none: [string, string, number[]] = ['compression', 'compression', [0]];

  test('of scan lines, tiles or several parts passes', () => {
    checkExr(sample, 'a.exr');
    checkExr(header([list, window(7, 7), none, tiles(8)], 0x200), 'a.exr');
    const parts = header([list, window(7, 7), none, tiles(8)], 0x1200);
    checkExr(joined(parts, parts.slice(8), [0, 0]), 'a.exr');
  });

  test.each<[string, Uint8Array, string]>([
    ['another file', Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8), 'not an OpenEXR file'],
    ['deep data', header([list], 0x800), 'deep data'],
    ['no window', header([list, none]), 'the header has no dataWindow'],
    ['no compression', header([list, window(7, 7)]), 'the header has no compression'],
    ['no channels', header([window(7, 7), none]), 'the header has no channels'],
    ['an unknown compression', header([list, ['compression', 'compression', [77]]]), 'compression 77'],
    ['absurd sizes', header([list, window(2e9, 2e9), none]), 'an image of 2000000001 x 2000000001 texels'],
    ['an empty window', header([list, window(-1, 5), none]), 'an image of 0 x 6 texels'],
    ['a short window', header([['dataWindow', 'box2i', [0, 0, 0, 0]]]), '4 bytes for a box2i; expected 16'],
    ['channels without end', header([['channels', 'chlist', [82, 0, ...Array(16).fill(0)]]]), 'does not end'],
    ['no chunks', header([list, window(7, 7), none]), 'the file ends here; expected 128 more bytes'],
    ['tiles of no size', header([list, window(7, 7), none], 0x200), 'the header has no tiles'],
    ['empty tiles', header([list, window(7, 7), none, tiles(0)], 0x200), 'tiles of 0 x 8 texels'],
    [
      'a chunk elsewhere',
      joined(header([list, window(0, 0), none]), [255, 255, 0, 0, 0, 0, 0, 0], Array(8).fill(0)),
      'chunk 0 is at byte 65535, outside the file',
    ],
    ['a name without end', header([list]).slice(0, -1), 'a name that does not end'],
  ])('with %s is refused, with the place', (_, bytes, message) => {
    expect(() => checkExr(bytes, 'bad.exr')).toThrow(message);
    expect(() => checkExr(bytes, 'bad.exr')).toThrow(/^bad\.exr: byte \d+: /);
  });
});

test('whatever bytes are changed, the end is an image or a ByteError', () => {
  const hdr = joined(head(8, 2), ...[0, 1].map(() => [2, 2, 0, 8, 136, 9, 136, 8, 136, 7, 136, 129]));
  const exr = encodeExr({
    width: 8,
    height: 4,
    channels: [{ name: 'Y', type: 'float', pixels: new Float32Array(32) }],
  });
  const changes = fc.array(fc.tuple(fc.nat(), fc.nat(255)), { minLength: 1, maxLength: 6 });
  fc.assert(
    fc.property(fc.boolean(), changes, fc.nat(), (isHdr, edits, cut) => {
      const source = isHdr ? hdr : exr;
      const bytes = source.slice(0, cut % 4 === 0 ? cut % source.length : source.length);
      for (const [at, to] of edits) bytes[at % Math.max(1, bytes.length)] = to;
      try {
        if (isHdr) decodeHdr(bytes, 'x');
        else checkExr(bytes, 'x');
      } catch (error) {
        expect((error as Error).name).toBe('ByteError');
      }
    }),
    { numRuns: 1000 },
  );
});
