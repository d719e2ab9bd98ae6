/**
 * Substances that let light through: formulae of dispersion as they were published. The coefficients were taken from
 * refractiveindex.info (M. N. Polyanskiy, 2024, Scientific Data 11, 94), whose data are in the public domain (CC0). Of
 * crystals that split light into two rays this is the ordinary one.
 */
import type { Cauchy, Sellmeier, Tabulated } from './substance.ts';

const RHEIMS =
  'J. Rheims, J. Koeser and T. Wriedt, 1997, "Refractive-index measurements in the near-IR using an Abbe refractometer", Meas. Sci. Technol. 8, 601';
const SULTANOVA =
  'N. Sultanova, S. Kasarova and I. Nikolov, 2009, "Dispersion properties of optical polymers", Acta Physica Polonica A 116, 585; formula fitted by refractiveindex.info';
const GHOSH =
  'G. Ghosh, 1999, "Dispersion-equation coefficients for the refractive index and birefringence of calcite and quartz crystals", Opt. Commun. 163, 95';
const ALKALI_HALIDES =
  'H. H. Li, 1976, "Refractive index of alkali halides and its wavelength and temperature derivatives", J. Phys. Chem. Ref. Data 5, 329';
const SCHOTT = 'SCHOTT, 2017, optical glass catalogue';

export const DIELECTRICS: readonly (Sellmeier | Cauchy | Tabulated)[] = [
  {
    name: 'acetone',
    title: 'Acetone at 20 degrees',
    kind: 'dielectric',
    source: RHEIMS,
    cauchy: [
      [1.34979, 0],
      [0.00306, -2],
      [6e-5, -4],
    ],
    range: [477, 830],
  },
  {
    name: 'acrylic',
    title: 'Acrylic glass, PMMA',
    kind: 'dielectric',
    source: SULTANOVA,
    sellmeier: { constant: 1, terms: [[1.1819, 0.011313]] },
    range: [437, 1052],
  },
  {
    name: 'barium-fluoride',
    title: 'Barium fluoride, BaF2',
    kind: 'dielectric',
    source: 'I. H. Malitson, 1964, "Refractive properties of barium fluoride", J. Opt. Soc. Am. 54, 628',
    sellmeier: {
      constant: 1,
      terms: [
        [0.643356, 0.003339568521],
        [0.506762, 0.0120297024],
        [3.8261, 2151.698105],
      ],
    },
    range: [265, 10346],
  },
  {
    name: 'bk7',
    title: 'Crown glass, SCHOTT N-BK7',
    kind: 'dielectric',
    source: SCHOTT,
    sellmeier: {
      constant: 1,
      terms: [
        [1.03961212, 0.00600069867],
        [0.231792344, 0.0200179144],
        [1.01046945, 103.560653],
      ],
    },
    range: [300, 2500],
  },
  {
    name: 'calcite',
    title: 'Calcite, CaCO3, ordinary ray',
    kind: 'dielectric',
    source: GHOSH,
    sellmeier: {
      constant: 1.73358749,
      terms: [
        [0.96464345, 0.0194325203],
        [1.82831454, 120],
      ],
    },
    range: [204, 2172],
  },
  {
    name: 'cellulose',
    title: 'Cellulose',
    kind: 'dielectric',
    source: SULTANOVA,
    sellmeier: { constant: 1, terms: [[1.124, 0.011087]] },
    range: [437, 1052],
  },
  {
    name: 'diamond',
    title: 'Diamond, C',
    kind: 'dielectric',
    source:
      'F. Peter, 1923, "Ueber Brechungsindizes und Absorptionskonstanten des Diamanten zwischen 644 und 226 mu", Zeitschrift fuer Physik 15, 358',
    sellmeier: {
      constant: 1,
      terms: [
        [0.3306, 0.030625],
        [4.3356, 0.011236],
      ],
    },
    range: [226, 760],
  },
  {
    name: 'ethanol',
    title: 'Ethanol at 20 degrees',
    kind: 'dielectric',
    source: RHEIMS,
    cauchy: [
      [1.35265, 0],
      [0.00306, -2],
      [2e-5, -4],
    ],
    range: [477, 830],
  },
  {
    name: 'fluorite',
    title: 'Fluorite, CaF2',
    kind: 'dielectric',
    source:
      'I. H. Malitson, 1963, "A redetermination of some optical properties of calcium fluoride", Appl. Opt. 2, 1103',
    sellmeier: {
      constant: 1,
      terms: [
        [0.5675888, 0.002526429988],
        [0.4710914, 0.0100783328],
        [3.8484723, 1200.555973],
      ],
    },
    range: [230, 9700],
  },
  {
    name: 'fused-silica',
    title: 'Fused silica, SiO2',
    kind: 'dielectric',
    source:
      'I. H. Malitson, 1965, "Interspecimen comparison of the refractive index of fused silica", J. Opt. Soc. Am. 55, 1205',
    sellmeier: {
      constant: 1,
      terms: [
        [0.6961663, 0.004679148258],
        [0.4079426, 0.01351206307],
        [0.8974794, 97.93400254],
      ],
    },
    range: [210, 6700],
  },
  {
    name: 'glycerol',
    title: 'Glycerol at 25 degrees',
    kind: 'dielectric',
    source: RHEIMS,
    cauchy: [
      [1.45797, 0],
      [0.00598, -2],
      [-0.00036, -4],
    ],
    range: [589, 1050],
  },
  {
    name: 'ice',
    title: 'Ice',
    kind: 'dielectric',
    source:
      'S. G. Warren and R. E. Brandt, 2008, "Optical constants of ice from the ultraviolet to the microwave: A revised compilation", J. Geophys. Res. 113, D14220',
    samples: [
      [350, 1.3249, 2e-11],
      [400, 1.3194, 2.365e-11],
      [450, 1.3157, 9.239e-11],
      [500, 1.313, 5.889e-10],
      [550, 1.311, 2.289e-9],
      [600, 1.3094, 5.73e-9],
      [650, 1.308, 1.43e-8],
      [700, 1.3069, 2.9e-8],
      [750, 1.3059, 5.87e-8],
      [780, 1.3053, 1.02e-7],
    ],
  },
  {
    name: 'magnesium-fluoride',
    title: 'Magnesium fluoride, MgF2, ordinary ray',
    kind: 'dielectric',
    source: 'M. J. Dodge, 1984, "Refractive properties of magnesium fluoride", Appl. Opt. 23, 1980',
    sellmeier: {
      constant: 1,
      terms: [
        [0.48755108, 0.001882178397],
        [0.39875031, 0.008951888472],
        [2.3120353, 566.1355913],
      ],
    },
    range: [200, 7000],
  },
  {
    name: 'polycarbonate',
    title: 'Polycarbonate',
    kind: 'dielectric',
    source: SULTANOVA,
    sellmeier: { constant: 1, terms: [[1.4182, 0.021304]] },
    range: [437, 1052],
  },
  {
    name: 'polystyrene',
    title: 'Polystyrene',
    kind: 'dielectric',
    source: SULTANOVA,
    sellmeier: { constant: 1, terms: [[1.4435, 0.020216]] },
    range: [437, 1052],
  },
  {
    name: 'quartz',
    title: 'Quartz, SiO2, ordinary ray',
    kind: 'dielectric',
    source: GHOSH,
    sellmeier: {
      constant: 1.28604141,
      terms: [
        [1.07044083, 0.0100585997],
        [1.10202242, 100],
      ],
    },
    range: [198, 2053],
  },
  {
    name: 'rock-salt',
    title: 'Rock salt, NaCl',
    kind: 'dielectric',
    source: ALKALI_HALIDES,
    sellmeier: {
      constant: 1.00055,
      terms: [
        [0.198, 0.0025],
        [0.48398, 0.01],
        [0.38696, 0.016384],
        [0.25998, 0.024964],
        [0.08796, 1640.25],
        [3.17064, 3718.5604],
        [0.30038, 14481.7156],
      ],
    },
    range: [200, 30000],
  },
  {
    name: 'rutile',
    title: 'Rutile, TiO2, ordinary ray',
    kind: 'dielectric',
    source:
      'J. R. Devore, 1951, "Refractive indices of rutile and sphalerite", J. Opt. Soc. Am. 41, 416, whose n^2 = 5.913 + .2441/(w^2 - .0803) this is',
    sellmeier: { constant: 2.87314944, terms: [[3.03985056, 0.0803]] },
    range: [430, 1530],
  },
  {
    name: 'sapphire',
    title: 'Sapphire, ruby, Al2O3, ordinary ray',
    kind: 'dielectric',
    source:
      'I. H. Malitson and M. J. Dodge, 1972, "Refractive index and birefringence of synthetic sapphire", J. Opt. Soc. Am. 62, 1405',
    sellmeier: {
      constant: 1,
      terms: [
        [1.4313493, 0.005279926102],
        [0.65054713, 0.01423826471],
        [5.3414021, 325.0178341],
      ],
    },
    range: [200, 5000],
  },
  {
    name: 'sf11',
    title: 'Flint glass, SCHOTT N-SF11',
    kind: 'dielectric',
    source: SCHOTT,
    sellmeier: {
      constant: 1,
      terms: [
        [1.73759695, 0.013188707],
        [0.313747346, 0.0623068142],
        [1.89878101, 155.23629],
      ],
    },
    range: [370, 2500],
  },
  {
    name: 'spinel',
    title: 'Spinel, MgAl2O4',
    kind: 'dielectric',
    source:
      'W. J. Tropf and M. E. Thomas, 1991, "Magnesium aluminum spinel", in E. D. Palik, "Handbook of Optical Constants of Solids II"',
    sellmeier: {
      constant: 1,
      terms: [
        [1.8938, 0.0098843364],
        [3.0755, 250.462276],
      ],
    },
    range: [350, 5500],
  },
  {
    name: 'strontium-titanate',
    title: 'Strontium titanate, SrTiO3',
    kind: 'dielectric',
    source:
      'W. L. Bond, 1965, "Measurement of the refractive indices of several crystals", J. Appl. Phys. 36, 1674; formula of M. J. Dodge, 1986',
    sellmeier: {
      constant: 1,
      terms: [
        [3.042143, 0.02178286714],
        [1.170065, 0.08720716923],
        [30.83326, 1101.314578],
      ],
    },
    range: [430, 3800],
  },
  {
    name: 'sylvite',
    title: 'Sylvite, KCl',
    kind: 'dielectric',
    source: ALKALI_HALIDES,
    sellmeier: {
      constant: 1.26486,
      terms: [
        [0.30523, 0.01],
        [0.4162, 0.017161],
        [0.1887, 0.026244],
        [2.62, 4958.9764],
      ],
    },
    range: [180, 35000],
  },
  {
    name: 'water',
    title: 'Water at 20 degrees',
    kind: 'dielectric',
    source:
      'M. Daimon and A. Masumura, 2007, "Measurement of the refractive index of distilled water from the near-infrared region to the ultraviolet region", Appl. Opt. 46, 3811',
    sellmeier: {
      constant: 1,
      terms: [
        [0.5684027565, 0.005101829712],
        [0.1726177391, 0.01821153936],
        [0.02086189578, 0.02620722293],
        [0.1130748688, 10.69792721],
      ],
    },
    range: [182, 1129],
  },
  {
    name: 'window-glass',
    title: 'Window glass, soda-lime',
    kind: 'dielectric',
    source: 'M. Rubin, 1985, "Optical properties of soda lime silica glasses", Sol. Energy Mater. 12, 275',
    cauchy: [
      [1.513, 0],
      [-0.003169, 2],
      [0.003962, -2],
    ],
    range: [310, 4600],
  },
  {
    name: 'yag',
    title: 'Garnet, Y3Al5O12',
    kind: 'dielectric',
    source:
      'D. E. Zelmon, D. L. Small and R. Page, 1998, "Refractive-index measurements of undoped yttrium aluminum garnet from 0.4 to 5.0 um", Appl. Opt. 37, 4933',
    sellmeier: {
      constant: 1,
      terms: [
        [2.282, 0.01185],
        [3.27644, 282.734],
      ],
    },
    range: [400, 5000],
  },
];
