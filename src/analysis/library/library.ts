/** All materials of the library, by id: what is measured first. */
import type { LibraryEntry } from './entry.ts';
import { CAR_PAINT, CERAMICS, FABRICS, PAINTS, PAPER, PLASTICS, RUBBER } from './made.ts';
import { METALS } from './metals.ts';
import { FOOD, GROUND, SKIN, STONE, WAX, WOOD } from './natural.ts';
import { TRANSPARENT } from './transparent.ts';

export const materialLibrary: ReadonlyMap<string, LibraryEntry> = new Map(
  [
    ...METALS,
    ...TRANSPARENT,
    ...PLASTICS,
    ...PAINTS,
    ...CAR_PAINT,
    ...FABRICS,
    ...SKIN,
    ...WAX,
    ...FOOD,
    ...WOOD,
    ...STONE,
    ...CERAMICS,
    ...RUBBER,
    ...PAPER,
    ...GROUND,
  ].map((entry) => [entry.id, entry]),
);
