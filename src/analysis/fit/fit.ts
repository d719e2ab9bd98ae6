/**
 * Fits a model to measured data or to another model, as docs/fit.md explains: the parameters within their
 * ranges that make it as similar as it can be.
 */
import type { ParameterValues } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import type { Model } from '../../glsl/model.ts';
import { Pace } from '../pace.ts';
import { createRandom } from '../random.ts';
import { Comparison } from './comparison.ts';
import { determinacy } from './determinacy.ts';
import { type EvaluateSets, exactEvaluation, quickEvaluation } from './evaluate.ts';
import { derivatives } from './least-squares.ts';
import { createLook, distance, lookDifferences } from './look.ts';
import { meanSquare } from './metrics.ts';
import { type Axis, ParameterSpace } from './parameter-space.ts';
import { samplePairs } from './samples.ts';
import { type Differences, findBest, improve, type Place, type Search, withoutIdle } from './search.ts';
import type { Candidate, Fit, FitErrors, FitOptions, FitTarget, FittedNumber, Judge } from './types.ts';

export type * from './types.ts';

/** Pairs of directions: to find the way, and to fit by. */
const FEW = 250;
const MANY = 2000;
/** Pixels along the side of the sphere that fits are chosen by. */
const LOOK_SIZE = 18;
/** And of the one that the last fit is made by: another grid, so that the choice is not its own. */
const SMALL_LOOK_SIZE = 11;
/**
 * The lowest cosine: 89 degrees; for measurements 80 degrees, beyond which they are not to be trusted (B. Burley,
 * 2012, "Physically-Based Shading at Disney", section 3).
 */
const LOWEST = { formula: Math.cos((89 * Math.PI) / 180), measured: Math.cos((80 * Math.PI) / 180) };
/**
 * A fit whose error is this share of the target, as far as float32 can tell, is the target: no other metric has
 * another, and the rest of the way is gone in float64.
 */
const EXACT = 1e-3;
const LAST_STEPS = 8;
/** Steps of differences that stand for derivatives. */
const STEP = { float64: 1e-6, float32: 1e-3 };
/** The search's share of the time; the rest is for the other metrics, or for the last steps. */
const SEARCHING = 0.5;

/** @throws BrdfParameterError if a value does not suit its parameter; whatever the signal aborts with */
export async function fitModel(target: FitTarget, model: Model, options: FitOptions = {}): Promise<Fit> {
  const { seed = 1, fixed = {} } = options;
  const pace = new Pace(options.signal);
  const space = new ParameterSpace(model, fixed);
  const [quick, exact] = [quickEvaluation(model, pace), exactEvaluation(model, pace)];
  const targetValues = resolveParameters(target.model.file, target.parameters);
  const ofTarget = exactEvaluation(target.model, pace);
  const compare = async (count: number, salt: number) => {
    const lowest = target.model.data ? LOWEST.measured : LOWEST.formula;
    const pairs = samplePairs(count, seed + salt, lowest);
    const [wanted] = await ofTarget([targetValues], pairs);
    return new Comparison(pairs, wanted as Float64Array);
  };
  let least = Number.POSITIVE_INFINITY;
  const report = (done: number, error: number) => {
    least = Math.min(least, Math.sqrt(error));
    options.onProgress?.(done, least);
  };
  const search: Search = {
    space,
    random: createRandom(seed),
    coarse: await compare(FEW, 0),
    fine: await compare(MANY, 1),
    evaluate: quick,
    step: STEP.float32,
    report: (done, error) => report(SEARCHING * done, error),
  };
  /** The search goes on after its own share; `i` of `count` parts. */
  const part = (i: number, count: number): Search => ({
    ...search,
    report: (done, error) => report(SEARCHING + ((i + done) * (1 - SEARCHING)) / count, error),
  });
  const size = search.fine.size('cube root');

  const picture = await pictureOf(LOOK_SIZE, target.model, targetValues, pace);
  const errorsOf = async (parameters: ParameterValues, evaluate: EvaluateSets): Promise<FitErrors> => {
    const [roots] = await search.fine.differences('cube root', evaluate, [parameters]);
    const [seen] = await picture(quick, [parameters]);
    return {
      cubeRoot: Math.sqrt(meanSquare(roots as Float64Array)),
      look: distance(seen as Float64Array),
    };
  };
  const candidates: Found[] = [];
  const add = async (metric: Judge, place: Place, evaluate = quick) => {
    const parameters = space.values(place.point, place.switches);
    candidates.push({ metric, place, parameters, ...(await errorsOf(parameters, evaluate)) });
  };
  const better = () => candidates.reduce((a, b) => (b.look < a.look ? b : a));

  const byRoots: Differences = (evaluate, sets) => search.fine.differences('cube root', evaluate, sets);
  const best = await withoutIdle(search, await findBest(search), byRoots);
  if (Math.sqrt(best.error) < EXACT * size) {
    const lastly = { ...part(0, 1), evaluate: exact, step: STEP.float64 };
    await add('cube root', await improve(lastly, best, byRoots, LAST_STEPS), exact);
  } else {
    await add('cube root', best);
    for (const [i, metric] of (['logarithm', 'cosine'] as const).entries()) {
      const differences: Differences = (evaluate, sets) => search.fine.differences(metric, evaluate, sets);
      await add(metric, await withoutIdle(search, await improve(part(i, 3), best, differences), differences));
    }
    const [roots] = candidates as [Found];
    const both = together([
      { differences: await pictureOf(SMALL_LOOK_SIZE, target.model, targetValues, pace), scale: roots.look },
      { differences: byRoots, scale: roots.cubeRoot },
    ]);
    await add('look', await withoutIdle(search, await improve(part(2, 3), better().place, both), both));
  }

  const chosen = better();
  const { play, loose } = await playAt(search, chosen.place);
  const fit: Fit = {
    model: model.name,
    parameters: inOrder(model, chosen.parameters),
    errors: { cubeRoot: chosen.cubeRoot, look: chosen.look },
    defaults: await errorsOf(resolveParameters(model.file, fixed), quick),
    size,
    metric: chosen.metric,
    candidates: candidates.map(({ place: _, ...candidate }) => candidate),
    numbers: space.axes.map((axis, i) => fittedNumber(axis, chosen.place.point[i], play[i])),
    loose: loose.map((set) => set.map((i) => (space.axes[i] as Axis).name)),
  };
  options.onProgress?.(1, fit.errors.cubeRoot);
  return fit;
}

interface Found extends Candidate {
  readonly place: Place;
}

/** The differences of a model's lit sphere from the target's, pixel by pixel in Oklab. */
async function pictureOf(
  size: number,
  model: Model,
  parameters: ParameterValues,
  pace: Pace,
): Promise<Differences> {
  const look = createLook(size);
  const [wanted] = (await quickEvaluation(model, pace)([parameters], look.pairs)).map(look.shade);
  return async (evaluate, sets) => {
    const found = await evaluate(sets, look.pairs);
    return found.map((values) => lookDifferences(look.shade(values), wanted as Float64Array));
  };
}

/** Differences of several kinds, each with the same weight where it is as large as its scale. */
function together(kinds: readonly { differences: Differences; scale: number }[]): Differences {
  return async (evaluate, sets) => {
    const found: Float64Array[][] = [];
    for (const { differences } of kinds) found.push(await differences(evaluate, sets));
    return sets.map((_, s) =>
      Float64Array.from(
        kinds.flatMap(({ scale }, k) => {
          const values = (found[k] as Float64Array[])[s] as Float64Array;
          const weight = 1 / (scale * Math.sqrt(values.length));
          return Array.from(values, (x) => weight * x);
        }),
      ),
    );
  };
}

async function playAt({ space, fine, evaluate, step }: Search, { point, switches }: Place) {
  const residuals = (points: readonly Float64Array[]) => {
    const sets = points.map((next) => space.values(next, switches));
    return fine.differences('cube root', evaluate, sets);
  };
  const [values] = (await residuals([point])) as [Float64Array];
  const columns = await derivatives(residuals, point, values, step);
  return determinacy(columns, fine.size('cube root'));
}

function fittedNumber({ name, min, max }: Axis, x = 0, play = 0): FittedNumber {
  const range = max - min;
  const bound = x <= 0 ? 'min' : x >= 1 ? 'max' : null;
  return { name, value: min + range * x, play: range * play, bound };
}

/** As the model's file lists them. */
function inOrder({ parameters }: Model, values: ParameterValues): ParameterValues {
  return Object.fromEntries(
    parameters.flatMap(({ name }) => (name in values ? [[name, values[name]!]] : [])),
  );
}
