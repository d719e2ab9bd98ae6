import type { Parameter, ParameterValue, ParameterValues } from '../../brdf/model.ts';
import { direction, type Vec3 } from '../vector.ts';
import type { Point } from './types.ts';

/** What is searched: all parameters within their ranges (colours 0 to 1) and all pairs of directions. */

type Random = () => number;

/** How near to the horizon the search goes. Models cut light off below some 1e-7, which is no fault. */
export const LOWEST_COSINE = 1e-3;

export function randomParameters(random: Random, parameters: readonly Parameter[]): ParameterValues {
  return Object.fromEntries(parameters.map((parameter) => [parameter.name, randomValue(random, parameter)]));
}

function randomValue(random: Random, parameter: Parameter): ParameterValue {
  if (parameter.type === 'bool') return random() < 0.5;
  if (parameter.type === 'color') return [random(), random(), random()];
  return parameter.min + (parameter.max - parameter.min) * random();
}

/**
 * The defaults, the defaults in white, and the ends of the ranges: all low, all high, each alone low or high
 * among white defaults and among the other ends. What is worst is often at a corner.
 */
export function cornerParameters(parameters: readonly Parameter[]): ParameterValues[] {
  const make = (value: (parameter: Parameter) => ParameterValue): ParameterValues =>
    Object.fromEntries(parameters.map((parameter) => [parameter.name, value(parameter)]));
  const white = (parameter: Parameter) =>
    parameter.type === 'color' ? end(parameter, true) : parameter.default;
  const corners = [
    make((parameter) => parameter.default),
    make(white),
    make((parameter) => end(parameter, false)),
    make((parameter) => end(parameter, true)),
  ];
  for (const alone of parameters) {
    for (const high of [false, true]) {
      corners.push(make((parameter) => (parameter === alone ? end(parameter, high) : white(parameter))));
      corners.push(make((parameter) => end(parameter, (parameter === alone) === high)));
    }
  }
  const seen = new Set<string>();
  return corners.filter((corner) => {
    const key = JSON.stringify(corner);
    return !seen.has(key) && seen.add(key);
  });
}

/** The ends of a parameter's range. */
export function endsOf(parameter: Parameter): readonly ParameterValue[] {
  return [end(parameter, false), end(parameter, true)];
}

function end(parameter: Parameter, high: boolean): ParameterValue {
  if (parameter.type === 'bool') return high;
  if (parameter.type === 'color') return high ? [1, 1, 1] : [0, 0, 0];
  return high ? parameter.max : parameter.min;
}

/** Spread evenly over the hemisphere, or, every third time, close to the horizon. */
export function randomDirection(random: Random): Vec3 {
  const share = random();
  const cosine = random() < 1 / 3 ? LOWEST_COSINE ** share : LOWEST_COSINE + (1 - LOWEST_COSINE) * share;
  return direction(cosine, 2 * Math.PI * random());
}

/** A pair of directions: any, or one near the other's mirror image, where reflection peaks. */
export function randomPair(random: Random): { l: Vec3; v: Vec3 } {
  const v = randomDirection(random);
  if (random() < 0.5) return { l: randomDirection(random), v };
  const [cosine, phi] = angles(v);
  return { v, l: moved(random, direction(cosine, phi + Math.PI), 0.5 * 1e-3 ** random()) };
}

export function randomPoint(random: Random, parameters: readonly Parameter[]): Point {
  return { parameters: randomParameters(random, parameters), ...randomPair(random) };
}

/** A neighbour of a point: each coordinate moves with probability 1/2, by up to `reach` of its range. */
export function neighbour(
  random: Random,
  parameters: readonly Parameter[],
  point: Point,
  reach: number,
): Point {
  return {
    parameters: nearParameters(random, parameters, point.parameters, reach),
    l: random() < 0.5 ? moved(random, point.l, reach) : point.l,
    v: random() < 0.5 ? moved(random, point.v, reach) : point.v,
  };
}

export function nearParameters(
  random: Random,
  parameters: readonly Parameter[],
  values: ParameterValues,
  reach: number,
): ParameterValues {
  const near = (x: number, min: number, max: number) =>
    clamp(x + (max - min) * reach * (2 * random() - 1), min, max);
  const result: Record<string, ParameterValue> = { ...values };
  for (const parameter of parameters) {
    const value = values[parameter.name] ?? parameter.default;
    if (random() < 0.5) continue;
    if (typeof value === 'boolean') result[parameter.name] = random() < 0.25 ? !value : value;
    else if (typeof value === 'number' && parameter.type === 'float')
      result[parameter.name] = near(value, parameter.min, parameter.max);
    else if (typeof value === 'object')
      result[parameter.name] = [near(value[0], 0, 1), near(value[1], 0, 1), near(value[2], 0, 1)];
  }
  return result;
}

/** A direction up to `reach` away, in the cosine (its logarithm near the horizon) and in azimuth. */
export function moved(random: Random, w: Vec3, reach: number, lowest = LOWEST_COSINE): Vec3 {
  const [cosine, phi] = angles(w);
  const step = (scale: number) => scale * reach * (2 * random() - 1);
  const next = random() < 0.5 ? cosine + step(1) : cosine * Math.exp(step(2));
  return direction(clamp(next, lowest, 1), phi + step(Math.PI));
}

function angles([x, y, z]: Vec3): [number, number] {
  return [z, Math.atan2(y, x)];
}

function clamp(x: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, x));
}

/** Pairs at which formulas divide by zero, overflow or cancel, from straight above to the horizon itself. */
export function hostilePairs(): { l: Vec3; v: Vec3 }[] {
  const cosines = [1, 1 - 6e-8, 0.9, 0.5, 1e-2, 1e-4, 1e-6, 1e-8, 0];
  const pairs: { l: Vec3; v: Vec3 }[] = [];
  for (const azimuth of [0, Math.PI, Math.PI / 2, 1e-4]) {
    for (const a of cosines)
      for (const b of cosines) pairs.push({ l: direction(a, 0.3), v: direction(b, 0.3 + azimuth) });
  }
  return pairs;
}
