/** What is made: plastics, paints, car paint, fabrics, ceramics, rubber, paper. */
import type { LibraryEntry } from './entry.ts';
import {
  BY_EYE,
  gloss,
  glossyMatte,
  grey,
  matte,
  nix,
  oke,
  patch,
  principled,
  spectral,
  substance,
} from './values.ts';

const indexOf = (name: string): string => `Gloss from the index of refraction: ${substance(name).source}.`;
const LOOKS = 'Colour and roughness by eye.';

// biome-ignore format: a table
export const PLASTICS: readonly LibraryEntry[] = [
  principled('plastics', 'plastic-red', 'Polystyrene, red', [0.5, 0.018, 0.02], { roughness: 0.22, specular: gloss('polystyrene') }, `${indexOf('polystyrene')} ${LOOKS}`),
  glossyMatte('plastics', 'plastic-yellow', 'Polystyrene, yellow', [0.72, 0.42, 0.012], 0.05, LOOKS),
  glossyMatte('plastics', 'plastic-white', 'Acrylic, white', [0.76, 0.76, 0.74], 0.03, LOOKS),
  principled('plastics', 'plastic-piano', 'Acrylic, piano black', grey(0.006), { roughness: 0.06, specular: gloss('acrylic') }, `${indexOf('acrylic')} ${LOOKS}`),
  principled('plastics', 'plastic-blue', 'Polycarbonate, blue', [0.02, 0.11, 0.42], { roughness: 0.34, specular: gloss('polycarbonate') }, `${indexOf('polycarbonate')} ${LOOKS}`),
  principled('plastics', 'plastic-grey', 'Polycarbonate, textured grey', grey(0.12), { roughness: 0.55, specular: gloss('polycarbonate') }, `${indexOf('polycarbonate')} ${LOOKS}`),
  matte('plastics', 'foam', 'Polystyrene, foamed', [0.839, 0.838, 0.841], spectral('no. 00090')),
  matte('plastics', 'spectralon', 'Spectralon, white standard', grey(0.99), 'Diffuse reflectance .99 in the visible: Labsphere, "Technical Guide: Reflectance Materials and Coatings".'),
];

const BINDER = 'Gloss of a binder of index 1.5; roughness by eye.';

/** A paint of the colour of a patch. */
function paint(id: string, title: string, number: Parameters<typeof patch>[0], roughness: number) {
  const { color, source } = patch(number);
  return principled('paints', id, title, color, { roughness, specular: gloss(1.5) }, `${source} ${BINDER}`);
}
const yellow = patch(16);

// biome-ignore format: a table
export const PAINTS: readonly LibraryEntry[] = [
  matte('paints', 'paint-white', 'Wall paint, white', [0.8, 0.79, 0.76], oke('8.1', 0.5, 0.9)),
  glossyMatte('paints', 'paint-white-satin', 'Paint, white satin', [0.84, 0.83, 0.8], 0.25, `${oke('8.1', 0.5, 0.9)} Roughness by eye.`),
  paint('paint-red', 'Enamel, red', 15, 0.14),
  glossyMatte('paints', 'paint-yellow', 'Enamel, yellow', yellow.color, 0.03, `${yellow.source} Roughness by eye.`),
  paint('paint-blue', 'Enamel, blue', 13, 0.14),
  paint('paint-green', 'Paint, green satin', 14, 0.38),
  paint('paint-orange', 'Paint, orange satin', 7, 0.38),
  paint('paint-purple', 'Paint, purple satin', 10, 0.4),
  paint('paint-foliage', 'Paint, olive matte', 4, 0.72),
  paint('paint-neutral', 'Paint, neutral grey', 22, 0.7),
  principled('paints', 'paint-black', 'Paint, black matte', grey(0.03), { roughness: 0.8, specular: gloss(1.5) }, `${oke('8.1', 0.02, 0.15)} ${BINDER}`),
];

const VARNISH = 'By eye: pigment below clear varnish of index 1.5.';
const COAT = 'By eye: flakes below clear varnish.';
/** One pigment: the gloss is that of the varnish alone, sharp and as strong as its index. */
const solid = { roughness: 0.1, specular: gloss(1.5) };
/** Burley's layer has a quarter of a real one's strength, so that flakes keep most of the light. */
const coat = { clearcoat: 1, clearcoatGloss: 1 };

// biome-ignore format: a table
export const CAR_PAINT: readonly LibraryEntry[] = [
  principled('car paint', 'car-red', 'Car paint, red', [0.36, 0.005, 0.008], solid, VARNISH),
  principled('car paint', 'car-green', 'Car paint, racing green', [0.004, 0.055, 0.022], solid, VARNISH),
  principled('car paint', 'car-black', 'Car paint, black', grey(0.004), solid, VARNISH),
  principled('car paint', 'car-silver', 'Car paint, silver metallic', [0.62, 0.63, 0.65], { metallic: 0.85, roughness: 0.42, ...coat }, COAT),
  principled('car paint', 'car-blue', 'Car paint, blue metallic', [0.015, 0.09, 0.42], { metallic: 0.8, roughness: 0.38, ...coat }, COAT),
  principled('car paint', 'car-copper', 'Car paint, copper metallic', [0.5, 0.16, 0.05], { metallic: 0.85, roughness: 0.4, ...coat }, COAT),
  principled('car paint', 'car-pearl', 'Car paint, pearl white', [0.72, 0.72, 0.7], { metallic: 0.25, roughness: 0.32, ...coat }, COAT),
];

const FIBRE = `Gloss of cellulose: ${substance('cellulose').source}. Colour, sheen and roughness by eye.`;
const fibre = { specular: gloss('cellulose') };

// biome-ignore format: a table
export const FABRICS: readonly LibraryEntry[] = [
  principled('fabrics', 'denim', 'Denim', [0.035, 0.07, 0.16], { roughness: 0.85, sheen: 0.7, sheenTint: 0.4, ...fibre }, FIBRE),
  principled('fabrics', 'linen', 'Linen', [0.42, 0.37, 0.27], { roughness: 0.85, sheen: 0.2, sheenTint: 0.8, ...fibre }, FIBRE),
  principled('fabrics', 'cotton-red', 'Cotton, red', [0.36, 0.03, 0.035], { roughness: 0.9, sheen: 0.6, ...fibre }, FIBRE),
  principled('fabrics', 'canvas', 'Canvas', [0.34, 0.31, 0.25], { roughness: 0.95, sheen: 0.1, ...fibre }, FIBRE),
  principled('fabrics', 'wool', 'Wool, grey', [0.1, 0.1, 0.105], { roughness: 1, specular: 0.1, sheen: 1, sheenTint: 0.3 }, BY_EYE),
  principled('fabrics', 'felt', 'Felt, green', [0.012, 0.09, 0.038], { roughness: 1, specular: 0.1, sheen: 1, sheenTint: 0.6 }, BY_EYE),
  principled('fabrics', 'velvet', 'Velvet, crimson', [0.03, 0.0008, 0.0035], { roughness: 1, specular: 0, sheen: 1, sheenTint: 0.5 }, BY_EYE),
  principled('fabrics', 'velvet-blue', 'Velvet, midnight blue', [0.0015, 0.003, 0.018], { roughness: 1, specular: 0, sheen: 1, sheenTint: 0.5 }, BY_EYE),
  principled('fabrics', 'satin', 'Satin, ivory', [0.6, 0.5, 0.36], { metallic: 0.3, roughness: 0.38, anisotropic: 0.9, specular: 1, specularTint: 0.5 }, BY_EYE),
  principled('fabrics', 'leather', 'Leather, brown', [0.1, 0.042, 0.02], { roughness: 0.38, specular: 0.5, clearcoat: 0.3, clearcoatGloss: 0.6 }, BY_EYE),
];

const GLAZE = 'Gloss of a glaze of index 1.5. Colour and roughness by eye.';

// biome-ignore format: a table
export const CERAMICS: readonly LibraryEntry[] = [
  glossyMatte('ceramics', 'porcelain', 'Porcelain, glazed', [0.745, 0.745, 0.723], 0.015, `${nix('Porcelain')} Roughness by eye.`),
  principled('ceramics', 'celadon', 'Celadon', [0.3, 0.42, 0.33], { roughness: 0.16, specular: gloss(1.5), clearcoat: 0.3 }, GLAZE),
  principled('ceramics', 'tenmoku', 'Stoneware, dark glaze', [0.035, 0.018, 0.012], { roughness: 0.18, specular: gloss(1.5) }, GLAZE),
  glossyMatte('ceramics', 'bisque', 'Porcelain, unglazed', [0.78, 0.76, 0.72], 0.5, BY_EYE),
  principled('ceramics', 'terracotta', 'Terracotta', [0.555, 0.212, 0.11], { roughness: 0.85, specular: 0.25 }, `${nix('Terracotta')} Gloss and roughness by eye.`),
  principled('ceramics', 'brick', 'Brick', [0.262, 0.095, 0.061], { roughness: 0.95, specular: 0.2 }, `${nix('Brick')} Gloss and roughness by eye.`),
];

const NATURAL_RUBBER =
  'Gloss of natural rubber, index 1.519: J. Brandrup and E. H. Immergut, "Polymer Handbook".';

// biome-ignore format: a table
export const RUBBER: readonly LibraryEntry[] = [
  principled('rubber', 'tyre', 'Tyre', grey(0.023), { roughness: 0.72, specular: gloss(1.519) }, `${nix('Tire')} ${NATURAL_RUBBER} Roughness by eye.`),
  principled('rubber', 'rubber-red', 'Rubber, red', [0.32, 0.035, 0.03], { roughness: 0.6, specular: gloss(1.519) }, `${NATURAL_RUBBER} ${LOOKS}`),
  principled('rubber', 'latex', 'Latex', [0.5, 0.39, 0.2], { roughness: 0.5, subsurface: 0.4, specular: gloss(1.519) }, `${NATURAL_RUBBER} ${LOOKS}`),
  principled('rubber', 'silicone', 'Silicone, teal', [0.03, 0.28, 0.27], { roughness: 0.55, subsurface: 0.5, specular: gloss(1.41) }, 'Gloss of index 1.41, of silicone rubber. Colour and roughness by eye.'),
];

const white = patch(19);

// biome-ignore format: a table
export const PAPER: readonly LibraryEntry[] = [
  matte('paper', 'paper-white', 'Office paper', [0.794, 0.834, 0.884], nix('Office Paper')),
  matte('paper', 'tissue', 'Tissue paper', [0.83, 0.835, 0.784], nix('Toilet Paper')),
  matte('paper', 'newsprint', 'Newsprint', [0.55, 0.53, 0.47], BY_EYE),
  principled('paper', 'cardboard', 'Cardboard', [0.351, 0.208, 0.11], { roughness: 0.9, ...fibre }, `${nix('Cardboard')} Gloss and roughness by eye.`),
  glossyMatte('paper', 'photo-paper', 'Photographic paper', [0.72, 0.73, 0.74], 0.05, LOOKS),
  glossyMatte('paper', 'chart-white', 'ColorChecker, white patch', white.color, 0.6, `${white.source} Roughness by eye.`),
];
