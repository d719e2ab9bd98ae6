/** How values of the library are derived from what is published. */
import type { ParameterValue } from '../../brdf/model.ts';
import { labToRgb } from '../../color/lab.ts';
import { findModel } from '../../scene/models.ts';
import { specularOf } from '../../scene/specular.ts';
import type { Rgb } from '../plots/curve.ts';
import { SODIUM_D, substanceParameters } from '../substances/parameters.ts';
import { opticalConstants, type Substance } from '../substances/substance.ts';
import { substances } from '../substances/table.ts';
import type { Category, LibraryEntry, Look } from './entry.ts';

type Parameters = Readonly<Record<string, ParameterValue>>;

export function substance(name: string): Substance {
  const found = substances.get(name);
  if (!found) throw new Error(`there is no substance ${name}`);
  return found;
}

const shipped = (model: string) => findModel({ models: {}, assets: {} }, model)?.parameters ?? [];

function largest(model: string, name: string): number {
  const parameter = shipped(model).find((each) => each.name === name);
  if (parameter?.type !== 'float') throw new Error(`${model} has no number ${name}`);
  return parameter.max;
}

/** What makes a shipped model reflect like a substance. */
function reflectLike(name: string, model: string): Parameters {
  const found = substanceParameters(substance(name), shipped(model));
  if (!found) throw new Error(`${model} cannot be ${name}`);
  return found.values;
}

/** A metal of measured n and k. Rough ones keep their brightness: facets reflect to one another. */
export function metal(id: string, title: string, of: string, surface: Parameters): LibraryEntry {
  const look: Look = {
    model: 'principled',
    parameters: { ...reflectLike(of, 'principled'), ...surface },
    multipleScattering: true,
  };
  const source = `Colour from measured n and k: ${substance(of).source}. Surface by eye.`;
  return { id, title, category: 'metals', look, source };
}

/** A clear body of a measured index of refraction. */
export function clear(
  id: string,
  title: string,
  of: string,
  inside: Parameters = {},
  note = '',
): LibraryEntry {
  const look: Look = {
    model: 'dielectric',
    parameters: { ...reflectLike(of, 'dielectric'), ...inside },
    multipleScattering: false,
  };
  const source = `Index of refraction: ${substance(of).source}.${note && ` ${note}`}`;
  return { id, title, category: 'transparent', look, source };
}

/** `specular` of the principled model for an index of refraction, or for a substance at the sodium line. */
export function gloss(of: number | string): number {
  return specularOf(typeof of === 'number' ? of : opticalConstants(substance(of), SODIUM_D)[0]);
}

/** An opaque body: Burley's model with a colour. */
export function principled(
  category: Category,
  id: string,
  title: string,
  baseColor: Rgb,
  parameters: Parameters,
  source: string,
): LibraryEntry {
  const look: Look = {
    model: 'principled',
    parameters: { baseColor, ...parameters },
    multipleScattering: false,
  };
  return { id, title, category, look, source };
}

/** A matte body that keeps energy at every angle, which Burley's diffuse law does not where it is bright and rough. */
export function matte(
  category: Category,
  id: string,
  title: string,
  albedo: Rgb,
  source: string,
): LibraryEntry {
  const look: Look = { model: 'lambert', parameters: { albedo }, multipleScattering: false };
  return { id, title, category, look, source };
}

/** The largest index that the model takes. */
const STRONGEST = largest('cook-torrance', 'ior');
/** What is left to the gloss, so that it reflects 4 % head-on, as an index of 1.5 does. */
const GLOSS_SHARE = 0.04 / ((STRONGEST - 1) / (STRONGEST + 1)) ** 2;
const SHARED = 'Base and gloss share the light, so that the gloss is at most 16 % at grazing angles.';

/**
 * A bright body under a gloss that keeps energy at every angle: Burley's model adds the gloss to the base, and so gives
 * back more than it receives where both are strong.
 *
 * @param color head-on, without the gloss
 * @param slope root mean square slope of the gloss's facets
 */
export function glossyMatte(
  category: Category,
  id: string,
  title: string,
  color: Rgb,
  slope: number,
  source: string,
): LibraryEntry {
  const kd = Math.max(1 - GLOSS_SHARE, ...color);
  const albedo = color.map((value) => value / kd) as unknown as Rgb;
  const parameters = { albedo, kd, roughness: slope, ior: STRONGEST };
  const look: Look = { model: 'cook-torrance', parameters, multipleScattering: false };
  return { id, title, category, look, source: `${source} ${SHARED}` };
}

export const grey = (value: number): Rgb => [value, value, value];

export const BY_EYE = 'By eye.';
export const JENSEN =
  'Diffuse reflectance measured by H. W. Jensen, S. R. Marschner, M. Levoy and P. Hanrahan, 2001, "A Practical Model for Subsurface Light Transport", in their table of parameters.';

/** Of the ColorChecker, by their numbers: L*a*b* under D50 that its maker published in 2005. */
export const PATCHES = {
  1: [37.986, 13.555, 14.059],
  2: [65.711, 18.13, 17.81],
  4: [43.139, -13.095, 21.905],
  7: [62.661, 36.067, 57.096],
  10: [30.325, 22.976, -21.587],
  13: [28.778, 14.179, -50.297],
  14: [55.261, -38.342, 31.37],
  15: [42.101, 53.378, 28.19],
  16: [81.733, 4.039, 79.819],
  19: [96.539, -0.425, 1.186],
  22: [50.867, -0.153, -0.27],
} as const satisfies Record<number, Rgb>;

interface Published {
  readonly color: Rgb;
  readonly source: string;
}

/** A patch of charts made before November 2014, when pigments changed. */
export function patch(number: keyof typeof PATCHES): Published {
  return {
    color: labToRgb(PATCHES[number]).map((value) => Number(value.toFixed(4))) as unknown as Rgb,
    source: `Colour of patch ${number} of the ColorChecker (C. S. McCamy, H. Marcus and J. G. Davidson, 1976, "A Color-Rendition Chart", J. Appl. Photogr. Eng. 2, 95) by its maker’s L*a*b* of 2005.`,
  };
}

/** @param low of the range that the table gives, for sunlight with its infrared @param table its number there */
export function oke(table: '1.1' | '8.1', low: number, high: number): string {
  return `Albedo between ${low} and ${high}, as T. R. Oke, 1987, "Boundary Layer Climates", 2nd edition, table ${table}, has it for sunlight with its infrared; hue by eye.`;
}

/** Measured with a spectrophotometer of the hand; figures of deploy/v2/materials.json of April 2026, which is CC0. */
export const nix = (subject: string): string =>
  `Colour measured by A. Palmqvist, 2026, physicallybased.info, as “${subject}”.`;

/** Of a measured spectrum. @param numbers of the measurements there */
export const spectral = (numbers: string): string =>
  `Colour of a measured spectrum: J. A. Jakubiec, Spectral Materials Database, ${numbers}, by physicallybased.info.`;
