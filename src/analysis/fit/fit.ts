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
import { batchEvaluation, cpuEvaluation, type EvaluateSets } from './evaluate.ts';
import { derivatives } from './least-squares.ts';
import { createLook, distance, lookDifferences } from './look.ts';
import { meanSquare } from './metrics.ts';
import { type Axis, ParameterSpace } from './parameter-space.ts';
import { samplePairs } from './samples.ts';
import { type Differences, findBest, improve, type Place, type Search, withoutIdle } from './search.ts';
import type { Candidate, Fit, FitErrors, FitOptions, FitTarget, FittedNumber, Judge } from './types.ts';

export type * from './types.ts';

/** Pairs of directions: to find the way, and to fit by. */
const FEW = 160;
const MANY = 1000;
/** Pixels along the side of the sphere that fits are chosen by. */
const LOOK_SIZE = 14;
/** And of the one that the last fit is made by: another grid, so that the choice is not its own. */
const SMALL_LOOK_SIZE = 8;
/**
 * The lowest cosine: 89 degrees; for measurements 80 degrees, beyond which they are not to be trusted (B. Burley,
 * 2012, "Physically-Based Shading at Disney", section 3).
 */
const LOWEST = { formula: Math.cos((89 * Math.PI) / 180), measured: Math.cos((80 * Math.PI) / 180) };
/** A fit whose error is this share of the target is the target: no other metric has another. */
const EXACT = 1e-5;
/** Steps of differences that stand for derivatives. */
const STEP = { float64: 1e-6, float32: 1e-3 };
/** The search's share of the time; the rest is for the other metrics. */
const SEARCHING = 0.6;

/** @throws BrdfParameterError if a value does not suit its parameter; whatever the signal aborts with */
export async function fitModel(target: FitTarget, model: Model, options: FitOptions = {}): Promise<Fit> {
  const { seed = 1, fixed = {}, gpu } = options;
  const pace = new Pace(options.signal);
  const space = new ParameterSpace(model, fixed);
  const exact = { evaluate: cpuEvaluation(model, pace), step: STEP.float64 };
  const targetValues = resolveParameters(target.model.file, target.parameters);
  const ofTarget = cpuEvaluation(target.model, pace);
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
    quick: gpu ? { evaluate: batchEvaluation(gpu, pace), step: STEP.float32 } : exact,
    exact,
    report: (done, error) => report(SEARCHING * done, error),
  };

  const picture = await pictureOf(LOOK_SIZE, ofTarget, targetValues);
  const errorsOf = async (parameters: ParameterValues): Promise<FitErrors> => {
    const [roots] = await search.fine.differences('cube root', exact.evaluate, [parameters]);
    const [seen] = await picture(exact.evaluate, [parameters]);
    return {
      cubeRoot: Math.sqrt(meanSquare(roots as Float64Array)),
      look: distance(seen as Float64Array),
    };
  };
  const candidates: Found[] = [];
  const add = async (metric: Judge, place: Place) => {
    const parameters = space.values(place.point, place.switches);
    candidates.push({ metric, place, parameters, ...(await errorsOf(parameters)) });
  };
  const better = () => candidates.reduce((a, b) => (b.look < a.look ? b : a));

  const best = await findBest(search);
  const byRoots: Differences = (evaluate, sets) => search.fine.differences('cube root', evaluate, sets);
  await add('cube root', await withoutIdle(search, best, byRoots));
  if (Math.sqrt(best.error) > EXACT * search.fine.size('cube root')) {
    const part = (i: number): Search => ({
      ...search,
      report: (done, error) => report(SEARCHING + ((i + done) * (1 - SEARCHING)) / 3, error),
    });
    for (const [i, metric] of (['logarithm', 'cosine'] as const).entries()) {
      const differences: Differences = (evaluate, sets) => search.fine.differences(metric, evaluate, sets);
      await add(metric, await withoutIdle(search, await improve(part(i), best, differences), differences));
    }
    const [roots] = candidates as [Found];
    const small = await pictureOf(SMALL_LOOK_SIZE, ofTarget, targetValues);
    const both = together([
      { differences: small, scale: roots.look },
      { differences: byRoots, scale: roots.cubeRoot },
    ]);
    await add('look', await withoutIdle(search, await improve(part(2), better().place, both), both));
  }

  const chosen = better();
  const { play, loose } = await playAt(search, chosen.place);
  const fit: Fit = {
    model: model.name,
    parameters: inOrder(model, chosen.parameters),
    errors: { cubeRoot: chosen.cubeRoot, look: chosen.look },
    defaults: await errorsOf(resolveParameters(model.file, fixed)),
    size: search.fine.size('cube root'),
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
  ofTarget: EvaluateSets,
  target: ParameterValues,
): Promise<Differences> {
  const look = createLook(size);
  const [wanted] = (await ofTarget([target], look.pairs)).map(look.shade);
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

async function playAt({ space, fine, exact }: Search, { point, switches }: Place) {
  const residuals = (points: readonly Float64Array[]) => {
    const sets = points.map((next) => space.values(next, switches));
    return fine.differences('cube root', exact.evaluate, sets);
  };
  const [values] = (await residuals([point])) as [Float64Array];
  const columns = await derivatives(residuals, point, values, exact.step);
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
