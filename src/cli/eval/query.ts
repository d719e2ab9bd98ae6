import type { ParameterValues, Rgb } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import type { Vector3 } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';

/** One line of `brdf eval`: what to evaluate a model at, in the frame n = +z, x = +x, y = +y. */
export interface Query {
  l: Vector3;
  v: Vector3;
  parameters: ParameterValues;
}

/** Evaluates a model at many queries; one value each, in their order. */
export type Backend = (queries: readonly Query[]) => Promise<readonly Rgb[]>;

/** Throws an Error whose message tells the writer of the line what is wrong with it. */
export function parseQuery(line: string, model: Model): Query {
  let value: unknown;
  try {
    value = JSON.parse(line);
  } catch (cause) {
    throw new Error(`not JSON: ${(cause as Error).message}`, { cause });
  }
  if (!isObject(value)) throw new Error('expected an object {"parameters", "l", "v"}');
  const { l, v, parameters = {}, ...others } = value;
  const [unknown] = Object.keys(others);
  if (unknown !== undefined)
    throw new Error(`unknown field ${JSON.stringify(unknown)}; expected parameters, l, v`);
  if (!isObject(parameters)) throw new Error('parameters: expected an object');
  return {
    l: direction(l, 'l'),
    v: direction(v, 'v'),
    parameters: resolveParameters(model.file, parameters),
  };
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** How far from 1 a direction's length may be: components of two decimals, such as .58 .58 .57, are within. */
const LENGTH_TOLERANCE = 0.01;

/**
 * Models expect unit vectors, and decimals that a person typed are not quite: those are normalised. What is
 * further off is no direction but a mistake, whose value would be that of another direction.
 */
function direction(value: unknown, name: string): Vector3 {
  const isVector = Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
  if (!isVector) throw new Error(`${name}: expected three finite numbers`);
  const [x, y, z] = value as [number, number, number];
  const length = Math.hypot(x, y, z);
  if (!(Math.abs(length - 1) <= LENGTH_TOLERANCE))
    throw new Error(`${name}: the length is ${Number(length.toPrecision(4))}; expected a unit vector`);
  return Math.abs(length - 1) < 1e-12 ? [x, y, z] : [x / length, y / length, z / length];
}
