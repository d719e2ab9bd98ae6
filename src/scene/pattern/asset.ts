/** What the page knows of patterns before one is drawn. */
import type { Asset } from '../schema.ts';

export const patternNames = ['wood', 'marble', 'granite', 'concrete', 'weave', 'leather', 'brushed'] as const;
export type PatternName = (typeof patternNames)[number];

export const PATTERN_TYPE = 'application/x-irradia-pattern';

export const isPattern = (asset: Pick<Asset, 'mediaType'> | undefined): boolean =>
  asset?.mediaType === PATTERN_TYPE;

/** Which picture of a pattern a texture shows: `texture` of its reference. Null is the colour, too. */
export const COLOR = 0;
/** Tangent space normals, y towards growing v. */
export const NORMALS = 1;
/** r: height, g: roughness. */
export const SURFACE = 2;
