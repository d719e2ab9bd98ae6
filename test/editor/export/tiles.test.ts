import fc from 'fast-check';
import { expect, test } from 'vitest';
import { tilesOf } from '../../../src/editor/panels/export/tiles.ts';

test('tiles cover every pixel once, and none is larger than asked for', () => {
  const side = fc.integer({ min: 1, max: 60 });
  fc.assert(
    fc.property(side, side, fc.integer({ min: 1, max: 70 }), (width, height, largest) => {
      const seen = new Uint8Array(width * height);
      for (const tile of tilesOf({ width, height }, largest)) {
        expect(Math.max(tile.width, tile.height)).toBeLessThanOrEqual(largest);
        for (let y = tile.y; y < tile.y + tile.height; y++)
          for (let x = tile.x; x < tile.x + tile.width; x++) seen[y * width + x]! += 1;
      }
      expect(seen.every((count) => count === 1)).toBe(true);
    }),
  );
});
