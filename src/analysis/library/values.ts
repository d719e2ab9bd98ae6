/** How values of the library are derived from what is published. */
import type { ParameterValue } from '../../brdf/model.ts';
import { srgbToLinear } from '../../color/srgb.ts';
import { findModel } from '../../scene/models.ts';
import type { Rgb } from '../plots/curve.ts';
import { SODIUM_D, specularOf, substanceParameters } from '../substances/parameters.ts';
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

/** Linear Rec. 709 of 8-bit sRGB, to four digits. */
export function srgb(...bytes: readonly [number, number, number]): Rgb {
  const linear = (byte: number) => Number(srgbToLinear(byte / 255).toFixed(4));
  return [linear(bytes[0]), linear(bytes[1]), linear(bytes[2])];
}

export const grey = (value: number): Rgb => [value, value, value];

export const BY_EYE = 'By eye.';
export const JENSEN =
  'Diffuse reflectance measured by H. W. Jensen, S. R. Marschner, M. Levoy and P. Hanrahan, 2001, "A Practical Model for Subsurface Light Transport", table 1.';
export const OKE =
  'Albedo within the range of T. R. Oke, 1987, "Boundary Layer Climates", 2nd edition, tables 1.1 and 8.1; hue by eye.';
/** C. S. McCamy et al. made the chart; its maker publishes the patches' sRGB. */
export const COLORCHECKER =
  'Colour of a patch of the ColorChecker (C. S. McCamy, H. Marcus and J. G. Davidson, 1976, "A Color-Rendition Chart", J. Appl. Photogr. Eng. 2, 95), in its maker’s sRGB values.';
