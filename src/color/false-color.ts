/**
 * Luminance as colours, one for each stop about middle grey, as those who light a set read exposure: below grey from
 * black through blue to green, at grey grey, above it from yellow to red and white.
 */

/** The reflectance that looks midway between black and white. Zone 0 is half a stop to either side of it. */
export const MIDDLE_GRAY = 0.18;

/** Zones to either side of middle grey; the outermost hold all beyond. */
export const ZONES_EACH_SIDE = 6;

/** sRGB, from the darkest zone to the brightest. Lightness rises throughout, but that grey stands out. */
export const ZONE_COLORS: readonly (readonly [r: number, g: number, b: number])[] = [
  [0, 0, 0],
  [44, 0, 72],
  [38, 22, 140],
  [20, 62, 196],
  [0, 118, 190],
  [0, 150, 110],
  [128, 128, 128],
  [120, 186, 40],
  [226, 214, 30],
  [250, 164, 26],
  [246, 98, 22],
  [226, 26, 40],
  [255, 255, 255],
];

/** The luminance in nits at the lower bound of a zone, -5 to 6, for an exposure in EV. */
export function zoneBound(zone: number, exposure: number): number {
  return MIDDLE_GRAY * 2 ** (zone - 0.5 - exposure);
}

/** The number of a luminance's colour in ZONE_COLORS. */
export function zoneIndex(nits: number, exposure: number): number {
  if (!(nits > 0)) return 0;
  const zone = Math.floor(Math.log2(nits / MIDDLE_GRAY) + exposure + 0.5);
  return Math.min(ZONES_EACH_SIDE, Math.max(-ZONES_EACH_SIDE, zone)) + ZONES_EACH_SIDE;
}

/** For what is counted: none, one, two, ... and all beyond. sRGB; lightness rises throughout. */
export const COUNT_COLORS: readonly (readonly [r: number, g: number, b: number])[] = [
  [0, 0, 0],
  [36, 18, 84],
  [78, 18, 123],
  [129, 37, 129],
  [181, 54, 122],
  [229, 80, 100],
  [251, 135, 97],
  [254, 194, 135],
  [252, 253, 191],
];
