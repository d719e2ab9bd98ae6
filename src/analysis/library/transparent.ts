/** Glasses, liquids and gems, by their measured index of refraction. What colours them is by eye. */
import type { LibraryEntry } from './entry.ts';
import { clear } from './values.ts';

/** The way in metres after which a coloured body has its colour: that of objects as large as a hand. */
const DEPTH = 0.1;
const TINT = 'What it absorbs is by eye, for bodies of about 10 cm.';
const tint = (r: number, g: number, b: number) => ({
  transmissionColor: [r, g, b] as const,
  transmissionDepth: DEPTH,
});

// biome-ignore format: a table
export const TRANSPARENT: readonly LibraryEntry[] = [
  clear('window-glass', 'Window glass', 'window-glass'),
  clear('crown-glass', 'Crown glass', 'bk7'),
  clear('flint-glass', 'Flint glass', 'sf11'),
  clear('fused-silica', 'Fused silica', 'fused-silica'),
  clear('frosted-glass', 'Frosted glass', 'window-glass', { roughness: 0.45 }, 'Roughness by eye.'),
  clear('bottle-glass', 'Bottle glass, green', 'window-glass', tint(0.16, 0.48, 0.18), TINT),
  clear('cobalt-glass', 'Glass, cobalt blue', 'window-glass', tint(0.03, 0.09, 0.7), TINT),
  clear('amber-glass', 'Glass, amber', 'window-glass', tint(0.85, 0.4, 0.05), TINT),
  clear('water', 'Water', 'water'),
  clear('ice', 'Ice', 'ice', { roughness: 0.08 }, 'Roughness by eye.'),
  clear('glycerol', 'Glycerol', 'glycerol'),
  clear('acrylic', 'Acrylic, clear', 'acrylic'),
  clear('quartz', 'Rock crystal', 'quartz'),
  clear('rock-salt', 'Rock salt', 'rock-salt', { roughness: 0.12 }, 'Roughness by eye.'),
  clear('diamond', 'Diamond', 'diamond'),
  clear('sapphire', 'Sapphire', 'sapphire', tint(0.04, 0.1, 0.62), TINT),
  clear('ruby', 'Ruby', 'sapphire', tint(0.62, 0.015, 0.06), TINT),
  clear('spinel', 'Spinel, red', 'spinel', tint(0.7, 0.08, 0.14), TINT),
];
