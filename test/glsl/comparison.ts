import { createRandom } from '../../src/analysis/random.ts';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValue, ParameterValues } from '../../src/brdf/model.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { randomDirection, randomParameters } from '../models/hostile.ts';

/** Points at which a model is evaluated on a GPU and in float64, and how far the two are apart. */

export interface Point {
  readonly l: Vec3;
  readonly v: Vec3;
  readonly u: readonly [number, number];
  readonly parameters: ParameterValues;
}

/** Where a value is smaller than this, its error is taken as absolute: relative to this. */
const FLOOR = 1e-4;

/** Everything that the file offers: BRDF(), the terms, and `pdf` and `sampleL`. */
export function functionsOf(model: Model): string[] {
  return [...model.terms, ...(model.hasSampling ? ['pdf', 'sampleL'] : [])];
}

/** The same point as the GPU will see it. */
export function roundToFloat32(point: Point): Point {
  const round = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];
  const roundValue = (value: ParameterValue): ParameterValue => {
    if (typeof value === 'boolean') return value;
    return typeof value === 'number' ? Math.fround(value) : round(value);
  };
  return {
    l: round(point.l),
    v: round(point.v),
    u: [Math.fround(point.u[0]), Math.fround(point.u[1])],
    parameters: Object.fromEntries(
      Object.entries(point.parameters).map(([name, value]) => [name, roundValue(value)]),
    ),
  };
}

/** Random directions and parameters, the same ones every time. */
export function randomPoints(model: Model, count: number): Point[] {
  const random = createRandom(51);
  const evaluator = createEvaluator(model);
  return Array.from({ length: count }, (_, i): Point => {
    const parameters = randomParameters(random, model.parameters);
    const v = randomDirection(random, 1e-3);
    const u = [random(), random()] as const;
    // Every other point lies where the model reflects most: in a peak, if it has one.
    evaluator.set(parameters);
    const sampled = i % 2 === 0 && model.hasSampling ? evaluator.sampleL(u, v) : null;
    return roundToFloat32({ l: sampled ?? randomDirection(random, 1e-3), v, u, parameters });
  });
}

/** A point as numbers: l, v, u and the parameters in their order, a colour as three. */
export function packPoint(model: Model, { l, v, u, parameters }: Point): number[] {
  const values = model.parameters.flatMap(({ name, default: fallback }) => {
    const value = parameters[name] ?? fallback;
    return typeof value === 'object' ? [...value] : [Number(value)];
  });
  return [...l, ...v, ...u, ...values];
}

export interface Comparison {
  /** The largest relative error of BRDF(), each term and pdf(), and where it is. */
  readonly worst: Record<string, { error: number; gpu: Vec3; cpu: Vec3; point: Point }>;
  /** The share of samples that sampleL() sends elsewhere on the GPU. */
  readonly elsewhere: number;
}

/** Compares what the GPU gave (pdf as three equal numbers) with float64. */
export function compare(
  model: Model,
  points: readonly Point[],
  results: ReadonlyMap<string, readonly Vec3[]>,
): Comparison {
  const evaluator = createEvaluator(model);
  const worst: Comparison['worst'] = {};
  let elsewhere = 0;
  for (const [i, point] of points.entries()) {
    const { l, v, u, parameters } = point;
    evaluator.set(parameters);
    for (const [name, values] of results) {
      const gpu = values[i]!;
      if (name === 'sampleL') {
        const cpu = evaluator.sampleL(u, v) ?? [0, 0, 0];
        if (!cpu.every((value, c) => Math.abs(value - gpu[c]!) < 1e-3)) elsewhere++;
        continue;
      }
      const cpu = name === 'pdf' ? triple(evaluator.pdf(l, v)) : evaluator.f(l, v, undefined, name);
      const error = Math.max(...cpu.map((x, c) => Math.abs(gpu[c]! - x) / Math.max(Math.abs(x), FLOOR)));
      // Written so that an error that is not a number counts as the worst.
      if (!(error <= (worst[name]?.error ?? -1))) worst[name] = { error, gpu, cpu, point };
    }
  }
  return { worst, elsewhere: elsewhere / points.length };
}

function triple(x: number): Vec3 {
  return [x, x, x];
}
