/**
 * The air of the Earth as light meets it, in bands of the visible spectrum: air itself (Rayleigh), haze (Mie) and ozone, each
 * with its profile over height. docs/decisions/sky.md has what was chosen and why.
 */
import { CIE_1931, FIRST_WAVELENGTH, WAVELENGTH_STEP } from '../../color/cie-1931.ts';
import { type Triple, transform } from '../../color/matrix.ts';
import { XYZ_TO_RGB } from '../../color/rec709.ts';

/** In metres. */
export const EARTH_RADIUS = 6.371e6;
export const TOP_RADIUS = EARTH_RADIUS + 1e5;

/** Of the eyes that see the sky, in metres. */
export const EYE_HEIGHT = 2;

/** Half the angle that the sun fills at 1 AU: its radius of 695 700 km (IAU, 2015) over 149 597 871 km. */
export const SUN_ANGULAR_RADIUS = Math.asin(695_700 / 149_597_870.7);

/** Outside the air, in lx: S. Darula, R. Kittler and C. Gueymard, 2005, "Reference luminous solar constant". */
const SOLAR_ILLUMINANCE = 133_334;
/** The IAU's nominal temperature of the sun in K: its spectrum is taken to be a black body's. */
const SUN_TEMPERATURE = 5772;

/** A band's wavelengths are so many of the observer's table. */
const TABLE_ROWS_PER_BAND = 6;

interface Band {
  /** nm, weighted by what the eye sees of the sun. */
  readonly wavelength: number;
  /** Linear Rec. 709 in lx that the sun has in this band outside the air. */
  readonly sun: Triple;
}

const planck = (nm: number): number => 1 / (nm ** 5 * Math.expm1(1.438777e7 / (SUN_TEMPERATURE * nm)));

function makeBands(): readonly Band[] {
  const rows = CIE_1931.map(([x, y, z], i) => {
    const nm = FIRST_WAVELENGTH + i * WAVELENGTH_STEP;
    const power = planck(nm);
    return { nm, xyz: [x * power, y * power, z * power] as Triple };
  });
  const scale = SOLAR_ILLUMINANCE / rows.reduce((sum, { xyz }) => sum + xyz[1], 0);
  const bands: Band[] = [];
  for (let first = 0; first < rows.length; first += TABLE_ROWS_PER_BAND) {
    const within = rows.slice(first, first + TABLE_ROWS_PER_BAND);
    const sum = (of: (row: (typeof rows)[number]) => number) =>
      within.reduce((total, row) => total + of(row), 0);
    const seen = sum(({ xyz }) => xyz[0] + xyz[1] + xyz[2]);
    const xyz = [0, 1, 2].map((c) => scale * sum((row) => row.xyz[c]!)) as unknown as Triple;
    bands.push({
      wavelength: sum((row) => row.nm * (row.xyz[0] + row.xyz[1] + row.xyz[2])) / seen,
      sun: transform(XYZ_TO_RGB, xyz),
    });
  }
  // Beyond 680 nm the eye sees almost nothing: one band holds it.
  const last = bands.findIndex(({ wavelength }) => wavelength > 680);
  const rest = bands.splice(last);
  const sun = [0, 1, 2].map((c) => rest.reduce((total, band) => total + band.sun[c]!, 0));
  return [...bands, { wavelength: rest[0]!.wavelength, sun: sun as unknown as Triple }];
}

export const bands = makeBands();
export const BANDS = bands.length;

/** Per metre at the sea's level; lambda in micrometres: A. Bucholtz, 1995, by the power law that fits it within 2 % here. */
const rayleigh = (nm: number): number => 1.24062e-6 * (nm / 1000) ** -4;

/** Cross-sections of ozone in the Chappuis band, 1e-25 m^2, every 25 nm from 400 nm: V. Gorshelev et al., 2014, rounded. */
const OZONE = [0.01, 0.03, 0.17, 0.5, 1.2, 2.1, 3.3, 4.75, 5.1, 3.9, 2.5, 1.45, 0.87, 0.5, 0.35, 0.3];
/** 300 Dobson units, in molecules/m^2. */
const OZONE_COLUMN = 300 * 2.687e20;

function ozone(nm: number): number {
  const place = Math.min(Math.max((nm - 400) / 25, 0), OZONE.length - 1.001);
  const i = Math.floor(place);
  return 1e-25 * (OZONE[i]! + (OZONE[i + 1]! - OZONE[i]!) * (place - i));
}

const RAYLEIGH_HEIGHT = 8000;
const HAZE_HEIGHT = 1200;
/** Ozone is a tent between 10 and 40 km: its integral is half its width. */
const OZONE_PEAK = 25_000;
const OZONE_HALF_WIDTH = 15_000;

/** Relative densities at a height in metres, each 1 where it is greatest. */
export const rayleighDensity = (height: number): number => Math.exp(-height / RAYLEIGH_HEIGHT);
export const hazeDensity = (height: number): number => Math.exp(-height / HAZE_HEIGHT);
export const ozoneDensity = (height: number): number =>
  Math.max(0, 1 - Math.abs(height - OZONE_PEAK) / OZONE_HALF_WIDTH);

/** Of haze: the part that is scattered, and the exponent by which there is more of it at short wavelengths. */
const HAZE_ALBEDO = 0.92;
const ANGSTROM_EXPONENT = 1.3;
/** Mean cosine of the angle by which haze turns light. */
export const HAZE_ANISOTROPY = 0.76;

/**
 * Where light is scattered often, the part of haze's scattering that counts as none, and the mean cosine of the rest:
 * J. H. Joseph, W. J. Wiscombe and J. A. Weinman, 1976, "The Delta-Eddington Approximation for Radiative Flux Transfer".
 */
const STRAIGHT_ON = HAZE_ANISOTROPY ** 2;
const TURNING_ANISOTROPY = HAZE_ANISOTROPY / (1 + HAZE_ANISOTROPY);

/** Coefficients in 1/m where densities are 1, by band. */
export interface Atmosphere {
  readonly rayleigh: Float64Array;
  readonly hazeScattering: Float64Array;
  readonly hazeExtinction: Float64Array;
  /** The same without what is scattered straight on. */
  readonly hazeTurning: Float64Array;
  readonly hazeDimming: Float64Array;
  readonly ozone: Float64Array;
  /** What the ground reflects. */
  readonly ground: Float64Array;
}

/**
 * @param turbidity the optical thickness of air and haze over that of air alone, upwards at 550 nm: 1 is air without haze
 * @param ground linear Rec. 709
 */
export function createAtmosphere(turbidity: number, ground: Triple): Atmosphere {
  const thickness = (turbidity - 1) * rayleigh(550) * RAYLEIGH_HEIGHT;
  const haze = (nm: number) => (thickness / HAZE_HEIGHT) * (nm / 550) ** -ANGSTROM_EXPONENT;
  const of = (value: (nm: number) => number) =>
    Float64Array.from(bands, ({ wavelength }) => value(wavelength));
  return {
    rayleigh: of(rayleigh),
    hazeScattering: of((nm) => HAZE_ALBEDO * haze(nm)),
    hazeExtinction: of(haze),
    hazeTurning: of((nm) => (1 - STRAIGHT_ON) * HAZE_ALBEDO * haze(nm)),
    hazeDimming: of((nm) => (1 - STRAIGHT_ON * HAZE_ALBEDO) * haze(nm)),
    ozone: of((nm) => (ozone(nm) * OZONE_COLUMN) / OZONE_HALF_WIDTH),
    // Blue, green and red share the spectrum: grey stays grey.
    ground: of((nm) => (nm < 490 ? ground[2] : nm < 580 ? ground[1] : ground[0])),
  };
}

export const rayleighPhase = (cosine: number): number => (3 / (16 * Math.PI)) * (1 + cosine * cosine);

/** W. M. Cornette and J. G. Shanks, 1992, "Physically reasonable analytic expression for the single-scattering phase function". */
export const hazePhase = (cosine: number): number => cornetteShanks(cosine, HAZE_ANISOTROPY);
/** Of what is not scattered straight on. */
export const turningPhase = (cosine: number): number => cornetteShanks(cosine, TURNING_ANISOTROPY);
/** Of the rest, over all of haze's scattering: its integral is that part. */
export const straightPhase = (cosine: number): number =>
  hazePhase(cosine) - (1 - STRAIGHT_ON) * turningPhase(cosine);

function cornetteShanks(cosine: number, g: number): number {
  const factor = (3 * (1 - g * g)) / (8 * Math.PI * (2 + g * g));
  const base = 1 + g * g - 2 * g * cosine;
  return (factor * (1 + cosine * cosine)) / (base * Math.sqrt(base));
}

/** Light of the sun's spectrum, of which so much of each band is left, in linear Rec. 709; negative where that lacks the colour. */
export function rgbOfBands(weights: ArrayLike<number>): [number, number, number] {
  const rgb: [number, number, number] = [0, 0, 0];
  for (let b = 0; b < BANDS; b += 1) {
    const weight = weights[b]!;
    for (const c of [0, 1, 2] as const) rgb[c] += weight * bands[b]!.sun[c];
  }
  return rgb;
}
