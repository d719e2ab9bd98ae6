/** The search for the parameters with the least cube-root difference, and from there for those of other metrics. */
import type { ParameterValues } from '../../brdf/model.ts';
import type { Comparison } from './comparison.ts';
import type { EvaluateSets } from './evaluate.ts';
import { leastSquares } from './least-squares.ts';
import { meanSquare } from './metrics.ts';
import type { ParameterSpace } from './parameter-space.ts';

/** Points that are tried, of which the best are starts. */
const SPREAD = 400;
const STARTS = 10;
/** Starts that are followed to the end. */
const FINALISTS = 3;
/** Errors that differ by less are one error, in float32. */
const SAME = 1e-4;

export interface Place {
  readonly point: Float64Array;
  readonly switches: ParameterValues;
  /** Mean square. */
  readonly error: number;
}

export interface Search {
  readonly space: ParameterSpace;
  readonly random: () => number;
  /** At few directions, to find the way; and at many. */
  readonly coarse: Comparison;
  readonly fine: Comparison;
  readonly evaluate: EvaluateSets;
  /** Of the differences that stand for derivatives. */
  readonly step: number;
  /** Called with the share of the search that is done and an error that was reached. */
  readonly report: (done: number, error: number) => void;
}

/** The model's differences from the target at several sets of parameters, under some metric. */
export type Differences = (
  evaluate: EvaluateSets,
  sets: readonly ParameterValues[],
) => Promise<Float64Array[]>;

interface Descent {
  readonly differences: Differences;
  readonly iterations: number;
  readonly tolerance: number;
  /** The share of the search that is done before and after. */
  readonly from: number;
  readonly to: number;
  /** Whether the errors on the way are those that the search is about. */
  readonly counts: boolean;
}

/** The best place under the cube root, of several that different starts lead to. */
export async function findBest(search: Search): Promise<Place> {
  const byFew: Differences = (evaluate, sets) => search.coarse.differences('cube root', evaluate, sets);
  const starts = await bestStarts(search, byFew);
  search.report(0.06, Number.POSITIVE_INFINITY);
  const found: Place[] = [];
  for (const [i, start] of starts.entries()) {
    found.push(
      await descend(search, start, {
        differences: byFew,
        iterations: 25,
        tolerance: 1e-2,
        counts: false,
        from: 0.06 + (0.5 * i) / starts.length,
        to: 0.06 + (0.5 * (i + 1)) / starts.length,
      }),
    );
  }
  const finalists = found.sort((a, b) => a.error - b.error).slice(0, FINALISTS);
  const ends: Place[] = [];
  for (const [i, start] of finalists.entries()) {
    ends.push(
      await descend(search, start, {
        differences: (evaluate, sets) => search.fine.differences('cube root', evaluate, sets),
        iterations: 30,
        tolerance: 1e-3,
        counts: true,
        from: 0.56 + (0.44 * i) / finalists.length,
        to: 0.56 + (0.44 * (i + 1)) / finalists.length,
      }),
    );
  }
  return ends.reduce((a, b) => (b.error < a.error ? b : a));
}

/** The best place near another under one more metric. */
export function improve(
  search: Search,
  start: Place,
  differences: Differences,
  iterations = 12,
): Promise<Place> {
  return descend(search, start, {
    differences,
    iterations,
    tolerance: 1e-3,
    counts: false,
    from: 0,
    to: 1,
  });
}

/** The place with every parameter at its default that makes no difference to the error there. */
export async function withoutIdle(search: Search, place: Place, differences: Differences): Promise<Place> {
  const { space } = search;
  const errorAt = async (point: Float64Array) => {
    const [values] = await differences(search.evaluate, [space.values(point, place.switches)]);
    return meanSquare(values as Float64Array);
  };
  const limit = (await errorAt(place.point)) * (1 + SAME);
  let { point } = place;
  for (const group of space.groups) {
    const moved = Float64Array.from(point);
    for (const i of group) moved[i] = space.defaults[i] as number;
    if ((await errorAt(moved)) <= limit) point = moved;
  }
  return { ...place, point };
}

/** The best of the defaults and of points spread over the box; of each combination of switches at least one. */
async function bestStarts(search: Search, differences: Differences) {
  const { space, random } = search;
  const all: Place[] = [];
  const firsts: Place[] = [];
  for (const switches of space.switches) {
    const count = Math.ceil(SPREAD / space.switches.length);
    const points = [space.defaults, ...(space.axes.length ? space.spread(count, random) : [])];
    const sets = points.map((point) => space.values(point, switches));
    const found = await differences(search.evaluate, sets);
    const places = found
      .map((values, k) => ({ point: points[k] as Float64Array, switches, error: meanSquare(values) }))
      .sort((a, b) => a.error - b.error);
    firsts.push(...places.slice(0, 1));
    all.push(...places.slice(1));
  }
  all.sort((a, b) => a.error - b.error);
  return [...firsts, ...all.slice(0, Math.max(0, STARTS - firsts.length))];
}

async function descend(search: Search, start: Place, descent: Descent): Promise<Place> {
  const { space, evaluate, step } = search;
  const { differences, iterations, tolerance, from, to, counts } = descent;
  const { switches } = start;
  const residuals = (points: readonly Float64Array[]) =>
    differences(
      evaluate,
      points.map((point) => space.values(point, switches)),
    );
  let done = 0;
  const onIteration = (error: number) => {
    done++;
    const share = Math.min(1, done / iterations);
    search.report(from + (to - from) * share, counts ? error : Number.POSITIVE_INFINITY);
  };
  const found = await leastSquares(residuals, start.point, { iterations, tolerance, step, onIteration });
  return { ...found, switches };
}
