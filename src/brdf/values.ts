import { BrdfParameterError } from './error.ts';
import type { BrdfFile, Parameter, ParameterValue, ParameterValues, Rgb } from './model.ts';

/**
 * A value for every parameter of a model: the given ones, defaults for the rest.
 *
 * Numbers beyond a parameter's range are allowed (a range is a slider's, not a law); numbers that are not
 * finite, values of another type and names that the model does not have are refused.
 *
 * @throws BrdfParameterError naming the model and the parameter
 */
export function resolveParameters(
  file: Pick<BrdfFile, 'name' | 'parameters'>,
  values: Readonly<Record<string, unknown>> = {},
): ParameterValues {
  for (const name of Object.keys(values)) {
    if (!file.parameters.some((parameter) => parameter.name === name)) {
      const names = file.parameters.map((parameter) => parameter.name).join(', ');
      throw new BrdfParameterError(
        file.name,
        name,
        `there is none; ${names ? `there are ${names}` : 'the model has none'}`,
      );
    }
  }
  const resolved: Record<string, ParameterValue> = {};
  for (const parameter of file.parameters) {
    const value = Object.hasOwn(values, parameter.name) ? values[parameter.name] : undefined;
    resolved[parameter.name] =
      value === undefined ? parameter.default : checkValue(file.name, parameter, value);
  }
  return resolved;
}

/** Checks one value against its parameter's type and returns it. @throws BrdfParameterError */
export function checkValue(model: string, parameter: Parameter, value: unknown): ParameterValue {
  switch (parameter.type) {
    case 'float':
      if (typeof value === 'number' && Number.isFinite(value)) return value;
      throw new BrdfParameterError(model, parameter.name, 'expected a finite number');
    case 'bool':
      if (typeof value === 'boolean') return value;
      if (value === 0 || value === 1) return value === 1;
      throw new BrdfParameterError(model, parameter.name, 'expected true or false');
    case 'color':
      if (
        Array.isArray(value) &&
        value.length === 3 &&
        value.every((v) => typeof v === 'number' && Number.isFinite(v))
      ) {
        return value as unknown as Rgb;
      }
      throw new BrdfParameterError(model, parameter.name, 'expected three finite numbers (linear Rec. 709)');
  }
}
