/**
 * Metals, and semiconductors that look like metals: n and k as they were published, at the wavelengths of the
 * publication that cover 380 to 780 nm. The figures were taken from the tables of refractiveindex.info (M. N.
 * Polyanskiy, 2024, Scientific Data 11, 94), which are in the public domain (CC0).
 */
import type { LorentzDrude, Tabulated } from './substance.ts';

const NOBLE =
  'P. B. Johnson and R. W. Christy, 1972, "Optical Constants of the Noble Metals", Phys. Rev. B 6, 4370';
const TRANSITION =
  'P. B. Johnson and R. W. Christy, 1974, "Optical constants of transition metals", Phys. Rev. B 9, 5056';
const FILMS =
  'A. D. Rakic, A. B. Djurisic, J. M. Elazar and M. L. Majewski, 1998, "Optical properties of metallic films for vertical-cavity optoelectronic devices", Appl. Opt. 37, 5271';
const SEMICONDUCTORS =
  'D. E. Aspnes and A. A. Studna, 1983, "Dielectric functions and optical parameters of Si, Ge, GaP, GaAs, GaSb, InP, InAs, and InSb from 1.5 to 6.0 eV", Phys. Rev. B 27, 985';

export const CONDUCTORS: readonly (Tabulated | LorentzDrude)[] = [
  {
    name: 'aluminium',
    title: 'Aluminium, Al',
    kind: 'conductor',
    source:
      'A. D. Rakic, 1995, "Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum", Appl. Opt. 34, 4755',
    // biome-ignore format: a table
    samples: [
      [364.66, 0.39877, 4.3957], [413.28, 0.52135, 5.0008], [442.8, 0.6079, 5.3676], [476.87, 0.7278, 5.7781], [516.6, 0.8734, 6.2418],
      [563.57, 1.0728, 6.7839], [619.93, 1.366, 7.4052], [652.25, 1.5724, 7.7354], [688.81, 1.8301, 8.0601], [729.32, 2.1606, 8.3565],
      [774.91, 2.6154, 8.4914], [794.78, 2.7675, 8.3866],
    ],
  },
  {
    name: 'beryllium',
    title: 'Beryllium, Be',
    kind: 'conductor',
    source: FILMS,
    lorentzDrude: {
      plasma: 18.51,
      free: [0.084, 0.035],
      bound: [
        [0.031, 1.664, 0.1],
        [0.14, 3.395, 1.032],
        [0.53, 4.454, 3.183],
        [0.13, 1.802, 4.604],
      ],
    },
  },
  {
    name: 'brass',
    title: 'Brass, 70 % Cu and 30 % Zn',
    kind: 'conductor',
    source: 'M. R. Querry, 1985, "Optical constants", Contractor Report CRDC-CR-85034',
    // biome-ignore format: a table
    samples: [
      [380, 1.487, 1.818], [400, 1.445, 1.805], [420, 1.35, 1.786], [440, 1.191, 1.797], [460, 0.994, 1.883],
      [480, 0.816, 2.046], [500, 0.686, 2.25], [520, 0.602, 2.464], [540, 0.549, 2.668], [560, 0.505, 2.86],
      [580, 0.468, 3.059], [600, 0.45, 3.253], [620, 0.449, 3.434], [640, 0.444, 3.609], [660, 0.445, 3.778],
      [680, 0.444, 3.943], [700, 0.446, 4.106], [720, 0.45, 4.266], [740, 0.455, 4.424], [760, 0.458, 4.579],
      [780, 0.464, 4.737],
    ],
  },
  {
    name: 'chromium',
    title: 'Chromium, Cr',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.87, 2.69], [381, 1.92, 2.74], [397, 2, 2.83], [413, 2.08, 2.93], [431, 2.19, 3.04],
      [451, 2.33, 3.14], [471, 2.51, 3.24], [496, 2.75, 3.3], [521, 2.94, 3.33], [549, 3.18, 3.33],
      [582, 3.22, 3.3], [617, 3.17, 3.3], [659, 3.09, 3.34], [704, 3.05, 3.39], [756, 3.08, 3.42],
      [821, 3.2, 3.48],
    ],
  },
  {
    name: 'cobalt',
    title: 'Cobalt, Co',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.5, 2.71], [381, 1.53, 2.82], [397, 1.57, 2.93], [413, 1.61, 3.05], [431, 1.67, 3.17],
      [451, 1.74, 3.28], [471, 1.81, 3.41], [496, 1.88, 3.55], [521, 1.97, 3.68], [549, 2.05, 3.82],
      [582, 2.13, 3.96], [617, 2.19, 4.11], [659, 2.25, 4.27], [704, 2.31, 4.45], [756, 2.4, 4.64],
      [821, 2.53, 4.88],
    ],
  },
  {
    name: 'copper',
    title: 'Copper, Cu',
    kind: 'conductor',
    source: NOBLE,
    // biome-ignore format: a table
    samples: [
      [367.9, 1.36, 1.975], [381.5, 1.33, 2.045], [397.4, 1.32, 2.116], [413.3, 1.28, 2.207], [430.5, 1.25, 2.305],
      [450.9, 1.24, 2.397], [471.4, 1.25, 2.483], [495.9, 1.22, 2.564], [520.9, 1.18, 2.608], [548.6, 1.02, 2.577],
      [582.1, 0.7, 2.704], [616.8, 0.3, 3.205], [659.5, 0.22, 3.747], [704.5, 0.21, 4.205], [756, 0.24, 4.665],
      [821.1, 0.26, 5.18],
    ],
  },
  {
    name: 'germanium',
    title: 'Germanium, Ge, a semiconductor',
    kind: 'conductor',
    source: SEMICONDUCTORS,
    // biome-ignore format: a table
    samples: [
      [375.7, 4.128, 2.469], [387.5, 4.157, 2.34], [399.9, 4.141, 2.215], [413.3, 4.082, 2.145], [427.5, 4.037, 2.14],
      [442.8, 4.035, 2.181], [459.2, 4.082, 2.24], [476.9, 4.18, 2.309], [495.9, 4.34, 2.384], [516.6, 4.61, 2.455],
      [539.1, 5.062, 2.318], [563.6, 5.283, 2.049], [590.4, 5.748, 1.634], [619.9, 5.588, 0.933], [652.5, 5.294, 0.638],
      [688.8, 5.067, 0.5], [729.3, 4.897, 0.401], [774.9, 4.763, 0.345], [826.6, 4.653, 0.298],
    ],
  },
  {
    name: 'gold',
    title: 'Gold, Au',
    kind: 'conductor',
    source: NOBLE,
    // biome-ignore format: a table
    samples: [
      [367.9, 1.48, 1.895], [381.5, 1.46, 1.933], [397.4, 1.47, 1.952], [413.3, 1.46, 1.958], [430.5, 1.45, 1.948],
      [450.9, 1.38, 1.914], [471.4, 1.31, 1.849], [495.9, 1.04, 1.833], [520.9, 0.62, 2.081], [548.6, 0.43, 2.455],
      [582.1, 0.29, 2.863], [616.8, 0.21, 3.272], [659.5, 0.14, 3.697], [704.5, 0.13, 4.103], [756, 0.14, 4.542],
      [821.1, 0.16, 5.083],
    ],
  },
  {
    name: 'iron',
    title: 'Iron, Fe',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 2.02, 2.43], [381, 2.12, 2.5], [397, 2.24, 2.58], [413, 2.35, 2.65], [431, 2.48, 2.71],
      [451, 2.59, 2.77], [471, 2.67, 2.82], [496, 2.74, 2.88], [521, 2.86, 2.91], [549, 2.95, 2.93],
      [582, 2.94, 2.99], [617, 2.88, 3.05], [659, 2.92, 3.1], [704, 2.86, 3.19], [756, 2.87, 3.28],
      [821, 2.94, 3.39],
    ],
  },
  {
    name: 'manganese',
    title: 'Manganese, Mn',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.89, 2.59], [381, 1.92, 2.67], [397, 1.96, 2.74], [413, 2, 2.82], [431, 2.06, 2.9],
      [451, 2.11, 2.98], [471, 2.19, 3.06], [496, 2.25, 3.14], [521, 2.32, 3.23], [549, 2.39, 3.33],
      [582, 2.47, 3.43], [617, 2.51, 3.54], [659, 2.56, 3.65], [704, 2.62, 3.78], [756, 2.7, 3.91],
      [821, 2.83, 4.03],
    ],
  },
  {
    name: 'mercury',
    title: 'Mercury, Hg, liquid',
    kind: 'conductor',
    source:
      'T. Inagaki, E. T. Arakawa and M. W. Williams, 1981, "Optical properties of liquid mercury", Phys. Rev. B 23, 5246',
    // biome-ignore format: a table
    samples: [
      [364.66, 0.71303, 3.0735], [387.45, 0.79824, 3.2935], [413.28, 0.898, 3.5379], [442.8, 1.027, 3.8019], [476.86, 1.186, 4.0898],
      [516.6, 1.3833, 4.4061], [563.56, 1.6209, 4.7505], [619.92, 1.9099, 5.1495], [688.8, 2.2842, 5.5819], [774.9, 2.7461, 6.054],
      [885.6, 3.3238, 6.5573],
    ],
  },
  {
    name: 'molybdenum',
    title: 'Molybdenum, Mo',
    kind: 'conductor',
    source:
      'M. M. Kirillova, L. V. Nomerovannaya and M. M. Noskov, 1971, "Optical properties of molybdenum single crystals", Sov. Phys. JETP 33, 1210',
    // biome-ignore format: a table
    samples: [
      [365, 2.65, 3.5], [404, 2.66, 3.41], [425, 2.71, 3.41], [450, 2.84, 3.51], [475, 2.95, 3.64],
      [500, 3.15, 3.73], [525, 3.22, 3.74], [550, 3.47, 3.56], [575, 3.42, 3.55], [600, 3.38, 3.56],
      [650, 3.45, 3.67], [675, 3.47, 3.74], [700, 3.48, 3.7], [725, 3.5, 3.8], [750, 3.52, 3.65],
      [775, 3.47, 3.57], [800, 3.46, 3.65],
    ],
  },
  {
    name: 'nickel',
    title: 'Nickel, Ni',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.7, 2.4], [381, 1.72, 2.48], [397, 1.72, 2.57], [413, 1.7, 2.69], [431, 1.71, 2.82],
      [451, 1.73, 2.95], [471, 1.78, 3.09], [496, 1.82, 3.25], [521, 1.85, 3.42], [549, 1.92, 3.61],
      [582, 1.96, 3.8], [617, 1.99, 4.02], [659, 1.99, 4.26], [704, 2.06, 4.5], [756, 2.13, 4.73],
      [821, 2.26, 4.97],
    ],
  },
  {
    name: 'palladium',
    title: 'Palladium, Pd',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.24, 2.74], [381, 1.26, 2.83], [397, 1.3, 2.93], [413, 1.33, 3.03], [431, 1.37, 3.14],
      [451, 1.41, 3.26], [471, 1.46, 3.39], [496, 1.52, 3.54], [521, 1.57, 3.68], [549, 1.64, 3.84],
      [582, 1.68, 4.02], [617, 1.75, 4.21], [659, 1.8, 4.42], [704, 1.86, 4.65], [756, 1.95, 4.89],
      [821, 2.06, 5.19],
    ],
  },
  {
    name: 'platinum',
    title: 'Platinum, Pt',
    kind: 'conductor',
    source: FILMS,
    lorentzDrude: {
      plasma: 9.59,
      free: [0.333, 0.08],
      bound: [
        [0.191, 0.517, 0.78],
        [0.659, 1.838, 1.314],
        // biome-ignore lint/suspicious/noApproximativeNumericConstant: an energy in eV, not pi
        [0.547, 3.668, 3.141],
        [3.576, 8.517, 9.249],
      ],
    },
  },
  {
    name: 'rhodium',
    title: 'Rhodium, Rh',
    kind: 'conductor',
    source:
      'J. H. Weaver, C. G. Olson and D. W. Lynch, 1977, "Optical investigation of the electronic structure of bulk Rh and Ir", Phys. Rev. B 15, 4115; figures in E. D. Palik, 1985, "Handbook of Optical Constants of Solids"',
    // biome-ignore format: a table
    samples: [
      [375.7, 1.2, 3.97], [387.5, 1.3, 4.09], [400, 1.41, 4.2], [413.3, 1.53, 4.29], [427.5, 1.63, 4.36],
      [459.2, 1.8, 4.49], [476.9, 1.85, 4.55], [495.9, 1.88, 4.65], [516.6, 1.9, 4.78], [539.1, 1.94, 4.94],
      [563.6, 2, 5.11], [590.4, 2.05, 5.3], [619.9, 2.12, 5.51], [652.6, 2.2, 5.76], [688.8, 2.3, 6.02],
      [729.3, 2.42, 6.33], [774.9, 2.6, 6.64], [826.6, 2.78, 6.97],
    ],
  },
  {
    name: 'silicon',
    title: 'Silicon, Si, a semiconductor',
    kind: 'conductor',
    source: SEMICONDUCTORS,
    // biome-ignore format: a table
    samples: [
      [375.7, 6.709, 1.32], [387.5, 6.062, 0.63], [399.9, 5.57, 0.387], [413.3, 5.222, 0.269], [427.5, 4.961, 0.203],
      [442.8, 4.753, 0.163], [459.2, 4.583, 0.13], [476.9, 4.442, 0.09], [495.9, 4.32, 0.073], [516.6, 4.215, 0.06],
      [539.1, 4.123, 0.048], [563.6, 4.042, 0.032], [590.4, 3.969, 0.03], [619.9, 3.906, 0.022], [652.5, 3.847, 0.016],
      [688.8, 3.796, 0.013], [729.3, 3.752, 0.01], [774.9, 3.714, 0.008], [826.6, 3.673, 0.005],
    ],
  },
  {
    name: 'silver',
    title: 'Silver, Ag',
    kind: 'conductor',
    source: NOBLE,
    // biome-ignore format: a table
    samples: [
      [367.9, 0.07, 1.657], [381.5, 0.05, 1.864], [397.4, 0.05, 2.07], [413.3, 0.05, 2.275], [430.5, 0.04, 2.462],
      [450.9, 0.04, 2.657], [471.4, 0.05, 2.869], [495.9, 0.05, 3.093], [520.9, 0.05, 3.324], [548.6, 0.06, 3.586],
      [582.1, 0.05, 3.858], [616.8, 0.06, 4.152], [659.5, 0.05, 4.483], [704.5, 0.04, 4.838], [756, 0.03, 5.242],
      [821.1, 0.04, 5.727],
    ],
  },
  {
    name: 'stainless-steel',
    title: 'Stainless steel, 18 % Cr and 9 % Ni',
    kind: 'conductor',
    source:
      'B. Karlsson and C. G. Ribbing, 1982, "Optical constants and spectral selectivity of stainless steel and its oxides", J. Appl. Phys. 53, 6340',
    // biome-ignore format: a table
    samples: [
      [380, 1.4786, 2.6681], [400, 1.5249, 2.7925], [420, 1.5762, 2.924], [440, 1.6386, 3.0555], [460, 1.7169, 3.1785],
      [480, 1.7921, 3.2933], [500, 1.8636, 3.401], [520, 1.9349, 3.5072], [540, 2.0072, 3.6166], [560, 2.0807, 3.7298],
      [580, 2.1557, 3.8451], [600, 2.2325, 3.9594], [620, 2.3122, 4.0504], [640, 2.3962, 4.1378], [660, 2.4839, 4.2261],
      [680, 2.5731, 4.3155], [700, 2.6617, 4.4066], [720, 2.7486, 4.5036], [740, 2.8331, 4.5851], [760, 2.9143, 4.6435],
      [780, 2.9915, 4.7009],
    ],
  },
  {
    name: 'titanium',
    title: 'Titanium, Ti',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 1.9, 2.9], [381, 1.99, 2.93], [397, 2.08, 2.95], [413, 2.14, 2.98], [431, 2.21, 3.01],
      [451, 2.27, 3.04], [471, 2.32, 3.1], [496, 2.36, 3.19], [521, 2.44, 3.3], [549, 2.54, 3.43],
      [582, 2.6, 3.58], [617, 2.67, 3.72], [659, 2.76, 3.84], [704, 2.86, 3.96], [756, 3, 4.01],
      [821, 3.21, 4.01],
    ],
  },
  {
    name: 'tungsten',
    title: 'Tungsten, W',
    kind: 'conductor',
    source: FILMS,
    lorentzDrude: {
      plasma: 13.22,
      free: [0.206, 0.064],
      bound: [
        [0.054, 0.53, 1.004],
        [0.166, 1.281, 1.917],
        [0.706, 3.332, 3.58],
        [2.59, 5.836, 7.498],
      ],
    },
  },
  {
    name: 'vanadium',
    title: 'Vanadium, V',
    kind: 'conductor',
    source: TRANSITION,
    // biome-ignore format: a table
    samples: [
      [368, 2.68, 3.4], [381, 2.87, 3.45], [397, 3.07, 3.48], [413, 3.31, 3.49], [431, 3.52, 3.49],
      [451, 3.59, 3.46], [471, 3.81, 3.38], [496, 3.92, 3.26], [521, 3.86, 3.18], [549, 4, 3.04],
      [582, 3.83, 3], [617, 3.54, 3.02], [659, 3.25, 3.09], [704, 3.18, 3.15], [756, 3.2, 3.2],
      [821, 3.16, 3.25],
    ],
  },
];
