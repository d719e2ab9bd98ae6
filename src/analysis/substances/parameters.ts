/** A substance as parameters of a model; it knows no model, only names and types of parameters. */
import type { Parameter, ParameterValue } from '../../brdf/model.ts';
import { COLOR_NAMES } from '../../scene/carried-look.ts';
import { specularOf } from '../../scene/specular.ts';
import type { Rgb } from '../plots/curve.ts';
import { reflectedColor } from './reflectance.ts';
import { opticalConstants, type Substance } from './substance.ts';

/** The yellow line of sodium in nm, at which tables give the index of refraction. */
export const SODIUM_D = 589.3;

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
    const color = COLOR_NAMES.find((name) => find(name)?.type === 'color');
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
