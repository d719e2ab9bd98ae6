/** What is made: plastics, paints, car paint, fabrics, ceramics, rubber, paper. */
import type { LibraryEntry } from './entry.ts';
import {
  BY_EYE,
  COLORCHECKER,
  gloss,
  glossyMatte,
  grey,
  matte,
  OKE,
  principled,
  srgb,
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
  matte('plastics', 'spectralon', 'Spectralon, white standard', grey(0.99), 'Diffuse reflectance .99 in the visible: Labsphere, "Technical Guide: Reflectance Materials and Coatings".'),
];

const chart = (color: readonly [number, number, number]) => srgb(...color);
const BINDER = 'Gloss of a binder of index 1.5; roughness by eye.';

// biome-ignore format: a table
export const PAINTS: readonly LibraryEntry[] = [
  matte('paints', 'paint-white', 'Wall paint, white', [0.8, 0.79, 0.76], OKE),
  glossyMatte('paints', 'paint-white-satin', 'Paint, white satin', [0.84, 0.83, 0.8], 0.25, `${OKE} Roughness by eye.`),
  principled('paints', 'paint-red', 'Enamel, red', chart([175, 54, 60]), { roughness: 0.14, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  glossyMatte('paints', 'paint-yellow', 'Enamel, yellow', chart([231, 199, 31]), 0.03, `${COLORCHECKER} Roughness by eye.`),
  principled('paints', 'paint-blue', 'Enamel, blue', chart([56, 61, 150]), { roughness: 0.14, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-green', 'Paint, green satin', chart([70, 148, 73]), { roughness: 0.38, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-orange', 'Paint, orange satin', chart([214, 126, 44]), { roughness: 0.38, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-purple', 'Paint, purple satin', chart([94, 60, 108]), { roughness: 0.4, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-foliage', 'Paint, olive matte', chart([87, 108, 67]), { roughness: 0.72, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-neutral', 'Paint, neutral grey', chart([122, 122, 121]), { roughness: 0.7, specular: gloss(1.5) }, `${COLORCHECKER} ${BINDER}`),
  principled('paints', 'paint-black', 'Paint, black matte', grey(0.03), { roughness: 0.8, specular: gloss(1.5) }, `${OKE} ${BINDER}`),
];

const COAT = 'By eye: a base under a layer of clear varnish.';
const coat = { clearcoat: 1, clearcoatGloss: 1 };

// biome-ignore format: a table
export const CAR_PAINT: readonly LibraryEntry[] = [
  principled('car paint', 'car-red', 'Car paint, red', [0.42, 0.006, 0.01], { roughness: 0.4, ...coat }, COAT),
  principled('car paint', 'car-green', 'Car paint, racing green', [0.004, 0.055, 0.022], { roughness: 0.4, ...coat }, COAT),
  principled('car paint', 'car-black', 'Car paint, black', grey(0.004), { roughness: 0.35, ...coat }, COAT),
  principled('car paint', 'car-silver', 'Car paint, silver metallic', [0.62, 0.63, 0.65], { metallic: 0.85, roughness: 0.42, ...coat }, COAT),
  principled('car paint', 'car-blue', 'Car paint, blue metallic', [0.015, 0.09, 0.42], { metallic: 0.8, roughness: 0.38, ...coat }, COAT),
  principled('car paint', 'car-copper', 'Car paint, copper metallic', [0.5, 0.16, 0.05], { metallic: 0.85, roughness: 0.4, ...coat }, COAT),
  principled('car paint', 'car-pearl', 'Car paint, pearl white', [0.72, 0.72, 0.7], { metallic: 0.25, roughness: 0.32, ...coat }, COAT),
];

const FIBRE = `Gloss of cellulose: ${substance('cellulose').source}. Colour, sheen and roughness by eye.`;
const fibre = { specular: gloss('cellulose') };

// biome-ignore format: a table
export const FABRICS: readonly LibraryEntry[] = [
  principled('fabrics', 'denim', 'Denim', [0.035, 0.07, 0.16], { roughness: 0.85, sheen: 0.35, sheenTint: 0.4, ...fibre }, FIBRE),
  principled('fabrics', 'linen', 'Linen', [0.42, 0.37, 0.27], { roughness: 0.85, sheen: 0.2, sheenTint: 0.8, ...fibre }, FIBRE),
  principled('fabrics', 'cotton-red', 'Cotton, red', [0.36, 0.03, 0.035], { roughness: 0.9, sheen: 0.3, ...fibre }, FIBRE),
  principled('fabrics', 'canvas', 'Canvas', [0.34, 0.31, 0.25], { roughness: 0.95, sheen: 0.1, ...fibre }, FIBRE),
  principled('fabrics', 'wool', 'Wool, grey', [0.13, 0.13, 0.135], { roughness: 1, specular: 0.2, sheen: 0.6, sheenTint: 0.3 }, BY_EYE),
  principled('fabrics', 'felt', 'Felt, green', [0.02, 0.14, 0.06], { roughness: 1, specular: 0.1, sheen: 0.5, sheenTint: 0.8 }, BY_EYE),
  principled('fabrics', 'velvet', 'Velvet, crimson', [0.14, 0.004, 0.016], { roughness: 1, specular: 0, sheen: 1, sheenTint: 0.9 }, BY_EYE),
  principled('fabrics', 'velvet-blue', 'Velvet, midnight blue', [0.006, 0.012, 0.07], { roughness: 1, specular: 0, sheen: 1, sheenTint: 0.85 }, BY_EYE),
  principled('fabrics', 'satin', 'Satin, ivory', [0.52, 0.45, 0.34], { roughness: 0.42, anisotropic: 0.7, specular: 1, specularTint: 0.4, sheen: 0.15 }, BY_EYE),
  principled('fabrics', 'leather', 'Leather, brown', [0.1, 0.042, 0.02], { roughness: 0.5, specular: 0.4, sheen: 0.05 }, BY_EYE),
];

const GLAZE = 'Gloss of a glaze of index 1.5. Colour and roughness by eye.';

// biome-ignore format: a table
export const CERAMICS: readonly LibraryEntry[] = [
  glossyMatte('ceramics', 'porcelain', 'Porcelain, glazed', [0.74, 0.75, 0.76], 0.015, LOOKS),
  principled('ceramics', 'celadon', 'Celadon', [0.3, 0.42, 0.33], { roughness: 0.16, specular: gloss(1.5), clearcoat: 0.3 }, GLAZE),
  principled('ceramics', 'tenmoku', 'Stoneware, dark glaze', [0.035, 0.018, 0.012], { roughness: 0.18, specular: gloss(1.5) }, GLAZE),
  glossyMatte('ceramics', 'bisque', 'Porcelain, unglazed', [0.78, 0.76, 0.72], 0.5, BY_EYE),
  principled('ceramics', 'terracotta', 'Terracotta', [0.44, 0.17, 0.085], { roughness: 0.85, specular: 0.25 }, BY_EYE),
  principled('ceramics', 'brick', 'Brick', [0.36, 0.14, 0.09], { roughness: 0.95, specular: 0.2 }, OKE),
];

const NATURAL_RUBBER =
  'Gloss of natural rubber, index 1.519: J. Brandrup and E. H. Immergut, "Polymer Handbook". Colour and roughness by eye.';

// biome-ignore format: a table
export const RUBBER: readonly LibraryEntry[] = [
  principled('rubber', 'tyre', 'Tyre', grey(0.018), { roughness: 0.72, specular: gloss(1.519) }, NATURAL_RUBBER),
  principled('rubber', 'rubber-red', 'Rubber, red', [0.32, 0.035, 0.03], { roughness: 0.6, specular: gloss(1.519) }, NATURAL_RUBBER),
  principled('rubber', 'latex', 'Latex', [0.5, 0.39, 0.2], { roughness: 0.5, subsurface: 0.4, specular: gloss(1.519) }, NATURAL_RUBBER),
  principled('rubber', 'silicone', 'Silicone, teal', [0.03, 0.28, 0.27], { roughness: 0.55, subsurface: 0.5, specular: gloss(1.41) }, 'Gloss of index 1.41, of silicone rubber. Colour and roughness by eye.'),
];

// biome-ignore format: a table
export const PAPER: readonly LibraryEntry[] = [
  matte('paper', 'paper-white', 'Office paper', [0.8, 0.82, 0.86], BY_EYE),
  matte('paper', 'newsprint', 'Newsprint', [0.55, 0.53, 0.47], BY_EYE),
  principled('paper', 'cardboard', 'Cardboard', [0.4, 0.27, 0.15], { roughness: 0.9, ...fibre }, FIBRE),
  glossyMatte('paper', 'photo-paper', 'Photographic paper', [0.72, 0.73, 0.74], 0.05, LOOKS),
  glossyMatte('paper', 'chart-white', 'ColorChecker, white patch', chart([243, 243, 242]), 0.6, COLORCHECKER),
];
