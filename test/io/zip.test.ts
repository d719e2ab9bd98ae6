import fc from 'fast-check';
import { zipSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import { readZip } from '../../src/io/zip.ts';

const bytesOf = (text: string) => new TextEncoder().encode(text);
const sample = zipSync({
  'a/b.txt': bytesOf('hello '.repeat(50)),
  'c.txt': bytesOf('there'),
  '__MACOSX/._c.txt': bytesOf('x'),
  'a/.DS_Store': bytesOf('x'),
});

describe('a zip archive', () => {
  test('gives its files by path, without what file managers add', () => {
    const files = readZip(sample, 'a.zip');
    expect([...files.keys()]).toEqual(['a/b.txt', 'c.txt']);
    expect(new TextDecoder().decode(files.get('a/b.txt'))).toBe('hello '.repeat(50));
  });

  test('that claims to hold terabytes is refused before it is unpacked', () => {
    const bomb = sample.slice();
    const view = new DataView(bomb.buffer);
    // The sizes in the central directory, whose entries begin with this signature.
    for (let at = 0; at < bomb.length - 30; at++)
      if (view.getUint32(at, true) === 0x02014b50) view.setUint32(at + 24, 0xfffffff0, true);
    expect(() => readZip(bomb, 'bomb.zip')).toThrow('bomb.zip: its files take more than');
  });

  test('that is broken is an error with its name', () => {
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.nat(), fc.nat(255)), { minLength: 1, maxLength: 6 }),
        fc.nat(),
        (changes, cut) => {
          const bytes = sample.slice(0, cut % 3 === 0 ? cut % sample.length : sample.length);
          for (const [at, value] of changes) bytes[at % Math.max(1, bytes.length)] = value;
          try {
            readZip(bytes, 'x.zip');
          } catch (error) {
            expect((error as Error).message).toMatch(/^x\.zip: /);
          }
        },
      ),
      { numRuns: 300 },
    );
  });
});
