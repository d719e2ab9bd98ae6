/** What grows or lies about: skin, wax, food, wood, stone, ground. */
import type { LibraryEntry } from './entry.ts';
import {
  BY_EYE,
  gloss,
  glossyMatte,
  grey,
  JENSEN,
  matte,
  nix,
  oke,
  patch,
  principled,
  spectral,
} from './values.ts';

/** Burley's `subsurface` flattens the shading as scattering below the surface does; it is no transport of light. */
const SKIN_GLOSS =
  'Gloss of index 1.4, of the outer skin (V. Tuchin, 2007, "Tissue Optics"); roughness by eye.';
const [dark, light] = [patch(1), patch(2)];
const skin = { subsurface: 0.8, roughness: 0.44, specular: gloss(1.4) };

// biome-ignore format: a table
export const SKIN: readonly LibraryEntry[] = [
  principled('skin', 'skin-1', 'Skin, forearm 1', [0.44, 0.22, 0.13], skin, `${JENSEN} ${SKIN_GLOSS}`),
  principled('skin', 'skin-2', 'Skin, forearm 2', [0.63, 0.44, 0.34], skin, `${JENSEN} ${SKIN_GLOSS}`),
  principled('skin', 'skin-light', 'Skin, light', light.color, skin, `${light.source} ${SKIN_GLOSS}`),
  principled('skin', 'skin-dark', 'Skin, dark', dark.color, { ...skin, roughness: 0.42 }, `${dark.source} ${SKIN_GLOSS}`),
  principled('skin', 'skin-deep', 'Skin, deep', [0.052, 0.024, 0.015], { ...skin, roughness: 0.4 }, `Colour by eye. ${SKIN_GLOSS}`),
];

const PARAFFIN = 'Gloss of paraffin, index 1.44. Colour and roughness by eye.';

// biome-ignore format: a table
export const WAX: readonly LibraryEntry[] = [
  principled('wax', 'candle', 'Candle, ivory', [0.56, 0.47, 0.31], { subsurface: 0.8, roughness: 0.34, specular: gloss(1.44) }, PARAFFIN),
  principled('wax', 'beeswax', 'Beeswax', [0.58, 0.3, 0.05], { subsurface: 1, roughness: 0.36, specular: gloss(1.44) }, PARAFFIN),
  principled('wax', 'sealing-wax', 'Sealing wax', [0.36, 0.01, 0.012], { subsurface: 0.6, roughness: 0.26, specular: gloss(1.5) }, BY_EYE),
  principled('wax', 'soap', 'Soap', [0.52, 0.56, 0.43], { subsurface: 0.8, roughness: 0.4, specular: gloss(1.46) }, BY_EYE),
];

const WET = 'Gloss and roughness by eye.';

// biome-ignore format: a table
export const FOOD: readonly LibraryEntry[] = [
  glossyMatte('food', 'milk', 'Milk, whole', [0.91, 0.88, 0.76], 0.01, `${JENSEN} Roughness by eye.`),
  glossyMatte('food', 'milk-skimmed', 'Milk, skimmed', [0.81, 0.81, 0.69], 0.01, `${JENSEN} Roughness by eye.`),
  glossyMatte('food', 'cream', 'Cream', [0.98, 0.9, 0.73], 0.03, `${JENSEN} Roughness by eye.`),
  principled('food', 'ketchup', 'Ketchup', [0.16, 0.01, 0], { subsurface: 0.5, roughness: 0.2, specular: gloss(1.4) }, `${JENSEN} ${WET}`),
  glossyMatte('food', 'apple', 'Apple, flesh', [0.85, 0.84, 0.53], 0.12, `${JENSEN} Roughness by eye.`),
  glossyMatte('food', 'potato', 'Potato, flesh', [0.77, 0.62, 0.21], 0.14, `${JENSEN} Roughness by eye.`),
  principled('food', 'chicken', 'Chicken', [0.31, 0.15, 0.1], { subsurface: 0.6, roughness: 0.38, specular: gloss(1.38) }, `${JENSEN} ${WET}`),
  principled('food', 'chocolate', 'Chocolate', [0.162, 0.091, 0.06], { subsurface: 0.2, roughness: 0.34, specular: gloss(1.5) }, `${nix('Chocolate')} ${WET}`),
  principled('food', 'lemon', 'Lemon', [0.617, 0.366, 0.045], { subsurface: 0.3, roughness: 0.38, specular: gloss(1.45) }, `${nix('Lemon')} ${WET}`),
  principled('food', 'orange', 'Orange', [0.615, 0.205, 0.01], { subsurface: 0.3, roughness: 0.42, specular: gloss(1.45) }, `${nix('Orange')} ${WET}`),
  principled('food', 'banana', 'Banana', [0.634, 0.532, 0.111], { subsurface: 0.2, roughness: 0.5, specular: 0.3 }, `${spectral('no. 00379')} ${WET}`),
  principled('food', 'carrot', 'Carrot', [0.713, 0.17, 0.026], { subsurface: 0.4, roughness: 0.48, specular: 0.35 }, `${spectral('no. 00456')} ${WET}`),
  principled('food', 'egg', 'Egg, brown', [0.493, 0.248, 0.123], { subsurface: 0.2, roughness: 0.6, specular: 0.3 }, `${nix('Egg Shell (Brown)')} ${WET}`),
];

const VARNISH = 'By eye: the mean colour of the wood; its grain is a pattern.';

// biome-ignore format: a table
export const WOOD: readonly LibraryEntry[] = [
  principled('wood', 'pine', 'Pine, planed', [0.56, 0.36, 0.18], { roughness: 0.55, specular: 0.4, anisotropic: 0.5 }, VARNISH),
  principled('wood', 'oak', 'Oak, oiled', [0.3, 0.165, 0.07], { roughness: 0.42, specular: 0.5, anisotropic: 0.5 }, VARNISH),
  principled('wood', 'walnut', 'Walnut, oiled', [0.115, 0.052, 0.025], { roughness: 0.4, specular: 0.5, anisotropic: 0.5 }, VARNISH),
  principled('wood', 'cherry', 'Cherry, varnished', [0.27, 0.09, 0.035], { roughness: 0.2, specular: gloss(1.5), clearcoat: 0.6, clearcoatGloss: 0.95 }, VARNISH),
  principled('wood', 'mahogany', 'Mahogany, French polish', [0.15, 0.032, 0.014], { roughness: 0.1, specular: gloss(1.5), clearcoat: 1 }, VARNISH),
  principled('wood', 'ebony', 'Ebony', [0.016, 0.012, 0.01], { roughness: 0.3, specular: 0.5 }, VARNISH),
  principled('wood', 'cork', 'Cork', [0.38, 0.22, 0.11], { roughness: 0.95, specular: 0.15 }, VARNISH),
];

// biome-ignore format: a table
export const STONE: readonly LibraryEntry[] = [
  glossyMatte('stone', 'marble', 'Marble, polished', [0.83, 0.79, 0.75], 0.03, `${JENSEN} Roughness by eye.`),
  principled('stone', 'granite', 'Granite, polished', [0.16, 0.14, 0.13], { roughness: 0.2, specular: gloss(1.54) }, 'Gloss of quartz, index 1.54. Colour by eye, the mean of its grains.'),
  principled('stone', 'concrete', 'Concrete', [0.27, 0.265, 0.25], { roughness: 0.9, specular: 0.25 }, oke('8.1', 0.1, 0.35)),
  principled('stone', 'limestone', 'Limestone', [0.44, 0.4, 0.32], { roughness: 0.85, specular: 0.3 }, BY_EYE),
  principled('stone', 'sandstone', 'Sandstone', [0.35, 0.24, 0.15], { roughness: 0.9, specular: 0.25 }, oke('8.1', 0.2, 0.35)),
  principled('stone', 'slate', 'Slate', [0.055, 0.06, 0.066], { roughness: 0.52, specular: 0.5 }, BY_EYE),
  principled('stone', 'basalt', 'Basalt', [0.045, 0.044, 0.043], { roughness: 0.75, specular: 0.4 }, BY_EYE),
  principled('stone', 'jade', 'Jade', [0.1, 0.3, 0.13], { subsurface: 0.8, roughness: 0.2, specular: gloss(1.62) }, 'Gloss of nephrite, index 1.62. Colour and roughness by eye.'),
  glossyMatte('stone', 'alabaster', 'Alabaster', [0.76, 0.72, 0.63], 0.1, BY_EYE),
];

// biome-ignore format: a table
export const GROUND: readonly LibraryEntry[] = [
  matte('ground', 'snow', 'Snow, fresh', [0.86, 0.88, 0.91], oke('1.1', 0.4, 0.95)),
  principled('ground', 'sand', 'Sand, dry', [0.42, 0.33, 0.2], { roughness: 1, specular: 0.15 }, oke('1.1', 0.2, 0.45)),
  principled('ground', 'soil', 'Soil, wet', [0.07, 0.048, 0.03], { roughness: 0.6, specular: 0.35 }, oke('1.1', 0.05, 0.4)),
  principled('ground', 'asphalt', 'Asphalt, worn', [0.09, 0.09, 0.092], { roughness: 0.9, specular: 0.3 }, oke('8.1', 0.05, 0.2)),
  principled('ground', 'asphalt-fresh', 'Asphalt, fresh', [0.043, 0.041, 0.04], { roughness: 0.7, specular: gloss(1.6) }, `${spectral('no. 00117')} ${WET}`),
  principled('ground', 'grass', 'Grass', [0.105, 0.133, 0.041], { roughness: 0.7, specular: 0.35, subsurface: 0.4 }, `${spectral('nos. 01110 and 00633')} ${WET}`),
  principled('ground', 'charcoal', 'Charcoal', grey(0.02), { roughness: 0.9, specular: 0.3 }, BY_EYE),
];
