import { createRandom } from '../../src/analysis/random.ts';
import { direction, type Vec3 } from '../../src/analysis/vector.ts';
import type { Parameter, ParameterValue, ParameterValues } from '../../src/brdf/model.ts';

/** Directions and parameters for the tests of models: random ones, and those where formulas break. */

type Random = () => number;

/** A direction spread evenly over the hemisphere about +z, not closer to the horizon than `lowest`. */
export function randomDirection(random: Random, lowest = 0): Vec3 {
  return direction(lowest + (1 - lowest) * random(), 2 * Math.PI * random());
}

/** A value in each parameter's range. */
export function randomParameters(random: Random, parameters: readonly Parameter[]): ParameterValues {
  const values: Record<string, ParameterValue> = {};
  for (const parameter of parameters) values[parameter.name] = randomValue(random, parameter);
  return values;
}

function randomValue(random: Random, parameter: Parameter): ParameterValue {
  if (parameter.type === 'bool') return random() < 0.5;
  if (parameter.type === 'color') return [random(), random(), random()];
  return parameter.min + (parameter.max - parameter.min) * random();
}

/** The ends of every parameter's range: all low, all high, each alone high, and random mixtures. */
export function cornerParameters(parameters: readonly Parameter[], mixtures = 60): ParameterValues[] {
  const corner = (high: (i: number) => boolean): ParameterValues =>
    Object.fromEntries(parameters.map((parameter, i) => [parameter.name, endOf(parameter, high(i))]));
  const random = createRandom(3);
  return [
    {},
    corner(() => false),
    corner(() => true),
    ...parameters.map((_, alone) => corner((i) => i === alone)),
    ...parameters.map((_, without) => corner((i) => i !== without)),
    ...Array.from({ length: mixtures }, () => corner(() => random() < 0.5)),
  ];
}

function endOf(parameter: Parameter, high: boolean): ParameterValue {
  if (parameter.type === 'bool') return high;
  if (parameter.type === 'color') return high ? [1, 1, 1] : [0, 0, 0];
  return high ? parameter.max : parameter.min;
}

/** Cosines to the normal from straight above to below the surface, through the last digits of float32. */
const COSINES = [1, 1 - 6e-8, 0.9, 0.5, 1e-2, 1e-4, 1e-6, 1.01e-7, 1e-8, 1e-30, 0, -1e-8, -0.5, -1];

/** Pairs (l, v) at which formulas divide by zero, overflow or cancel. */
export function hostilePairs(): [Vec3, Vec3][] {
  const pairs: [Vec3, Vec3][] = [];
  // In one plane l = v, h = n and l = -v all happen; 1e-4 is a little beside it.
  for (const azimuth of [0, Math.PI, Math.PI / 2, 1e-4, Math.PI + 1e-4]) {
    for (const cosL of COSINES)
      for (const cosV of COSINES) pairs.push([direction(cosL, 0.3), direction(cosV, 0.3 + azimuth)]);
  }
  // Exactly opposite, exactly equal and exactly on the axes, with no rounding in between.
  const axes: Vec3[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [-1, 0, 0],
    [0, 0, -1],
  ];
  for (const l of axes) for (const v of axes) pairs.push([l, v]);
  return pairs;
}
