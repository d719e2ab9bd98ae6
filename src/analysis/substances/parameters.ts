/**
 * A substance as parameters of a model. This is the one place that says what parameters mean for a substance; it knows
 * no model, only names and types of parameters.
 */
import type { Parameter, ParameterValue } from '../../brdf/model.ts';
import type { Rgb } from '../plots/curve.ts';
import { reflectedColor } from './reflectance.ts';
import { opticalConstants, type Substance } from './substance.ts';

/** `specular` 1 of Burley's model (2012, section 5.2) is a reflectance of 8 % at normal incidence. */
const SPECULAR_SCALE = 0.08;
/** The yellow line of sodium in nm, at which tables give the index of refraction. */
export const SODIUM_D = 589.3;

/** Names by which models call the colour of a metal's reflection. */
const COLORS = ['baseColor', 'albedo'];

/** `specular` of Burley's model for a smooth boundary of air and a body of that index of refraction. */
export function specularOf(ior: number): number {
  return ((ior - 1) / (ior + 1)) ** 2 / SPECULAR_SCALE;
}

export interface SubstanceParameters {
  readonly values: Readonly<Record<string, ParameterValue>>;
  /** Values that the model's range cut: what they should have been. */
  readonly outside: Readonly<Record<string, number>>;
}

/** What makes a model reflect like a substance; null if it has no parameters for that. */
export function substanceParameters(
  substance: Substance,
  parameters: readonly Parameter[],
): SubstanceParameters | null {
  const values: Record<string, ParameterValue> = {};
  const outside: Record<string, number> = {};
  const find = (name: string) => parameters.find((parameter) => parameter.name === name);
  const set = (name: string, value: number): boolean => {
    const parameter = find(name);
    if (parameter?.type !== 'float') return false;
    values[name] = Math.min(Math.max(value, parameter.min), parameter.max);
    if (values[name] !== value) outside[name] = value;
    return true;
  };
  const f0 = reflectedColor(substance, 1);
  if (substance.kind === 'conductor') {
    const color = COLORS.find((name) => find(name)?.type === 'color');
    if (color === undefined || !set('metallic', 1)) return null;
    values[color] = f0.map(inRange) as unknown as Rgb;
  } else {
    // A dielectric's own colour comes from what is in it and stays as it is.
    const [n] = opticalConstants(substance, SODIUM_D);
    if (!set('ior', n) && !set('specular', specularOf(n))) return null;
    set('specularTint', 0);
    set('metallic', 0);
  }
  return { values, outside };
}

const inRange = (value: number) => Math.min(Math.max(value, 0), 1);
