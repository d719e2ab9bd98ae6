import type { Rgb } from '../../brdf/model.ts';
import { type Context, type Found, percent, placeOf, short, worstOf } from './context.ts';
import { cornerParameters, hostilePairs, randomPair, randomPoint } from './space.ts';
import type { Check, Outcome, Point } from './types.ts';

/** Laws that every value of the model obeys by itself: it is a number, not negative, the same both ways. */

/** Beyond this a 32 bit float, which is what GPUs compute with, is infinite. */
const LARGEST_FLOAT32 = 3.4e38;

const isNumber = (x: number) => Math.abs(x) < LARGEST_FLOAT32;

export async function checkFiniteness(context: Context): Promise<Check> {
  const { model, random } = context;
  const functions = [...model.terms, ...(model.hasSampling ? ['pdf'] : [])];
  const corners = cornerParameters(model.parameters);
  const pairs = hostilePairs();
  const values = (point: Point, name: string): readonly number[] => {
    if (name !== 'pdf') return context.f(point, name);
    context.use(point.parameters);
    return [context.evaluator.pdf(point.l, point.v)];
  };
  const seen = { count: 0, bad: 0 };
  let worst: { point: Point; name: string; value: number } | null = null;
  const look = (point: Point, name: string) => {
    seen.count++;
    const value = values(point, name).find((x) => !isNumber(x));
    if (value === undefined) return;
    seen.bad++;
    // The first is kept, for it is the simplest; but one above the horizon says more than one on it.
    const onHorizon = ({ l, v }: Point) => Math.min(l[2], v[2]) < 1e-6;
    if (!worst || (onHorizon(worst.point) && !onHorizon(point))) worst = { point, name, value };
  };
  for (const [i, parameters] of corners.slice(0, context.trials(corners.length)).entries()) {
    await context.pulse(i / corners.length);
    for (const pair of pairs) for (const name of functions) look({ parameters, ...pair }, name);
  }
  for (let i = context.trials(1500); i > 0; i--) {
    const point = randomPoint(random, model.parameters);
    for (const name of functions) look(point, name);
  }
  const found = worst as { point: Point; name: string; value: number } | null;
  if (!found) {
    const sentence = 'Every value is an ordinary number, even where light or view grazes the surface.';
    return context.check('pass', 0, `0 of ${seen.count} not finite`, sentence, null);
  }
  const what = Number.isNaN(found.value) ? 'is not a number' : 'grows beyond what a GPU can hold';
  return context.check(
    'fail',
    seen.bad / seen.count,
    `${seen.bad} of ${seen.count} not finite`,
    `${found.name} ${what} ${placeOf(found.point)}: such a pixel turns black or white and spreads when blurred.`,
    worstOf(found.point, found.name),
  );
}

export async function checkPositivity(context: Context): Promise<Check> {
  const found = await searchTerms(context, (point, term) => {
    const lowest = Math.min(...context.f(point, term));
    return Number.isFinite(lowest) ? -lowest : Number.NEGATIVE_INFINITY;
  });
  // Rounding may leave a few 1e-16 below zero.
  const { term, point, value, outcome } = judge(context, found, (negative) => negative > 1e-9);
  const figure = Math.min(0, -value) || 0;
  return context.check(
    outcome,
    figure,
    outcome === 'pass' ? 'none below 0' : `${short(figure)} /sr`,
    outcome === 'pass'
      ? 'The surface never takes away more light than there is: no value is negative.'
      : `${term} is ${short(figure)} ${placeOf(point)}: a surface cannot reflect less than no light.`,
    worstOf(point, term),
  );
}

/** Rounding of the steepest lobes stays below 1e-8; an asymmetry in a formula is seldom below 1e-2. */
const RECIPROCITY_LIMIT = 1e-6;

export async function checkReciprocity(context: Context): Promise<Check> {
  // G1 is of one direction; it does not say what the other is.
  const oneSided = new Set(context.model.file.declarations.maskings.map(({ masking }) => masking));
  const found = await searchTerms(context, (point, term) => {
    if (oneSided.has(term)) return 0;
    const forth = context.f(point, term);
    return difference(forth, context.f({ ...point, l: point.v, v: point.l }, term));
  });
  const { term, point, value, outcome } = judge(context, found, (error) => error > RECIPROCITY_LIMIT);
  return context.check(
    outcome,
    value,
    outcome === 'pass' ? `differs by ${short(value)}` : `differs by ${percent(value)}`,
    outcome === 'pass'
      ? 'Light and viewer can change places and nothing changes, as nature has it (Helmholtz).'
      : `${term} changes by ${percent(value)} when light and viewer change places, ${placeOf(point)}: light ` +
          'traced from the lamp and light traced from the eye would give two different pictures.',
    worstOf(point, term),
  );
}

/** Sums of a dozen terms round to 1e-15 of the largest; a lobe that is missing is more than that. */
const SUM_LIMIT = 1e-9;

export async function checkLobes(context: Context): Promise<Check> {
  const { lobes } = context.model.file.declarations;
  if (lobes.length === 0) {
    return context.notApplicable(
      "The header has no line 'lobes:', so no terms are meant to add up to the model.",
    );
  }
  const objective = (point: Point) => {
    const whole = context.f(point);
    const sum: [number, number, number] = [0, 0, 0];
    for (const lobe of lobes) for (const [c, x] of context.f(point, lobe).entries()) sum[c as 0] += x;
    return difference(whole, sum);
  };
  const { point, value } = await context.maximise(startPoints(context), objective);
  const broken = value > SUM_LIMIT;
  return context.check(
    broken ? 'fail' : 'pass',
    value,
    `differs by ${broken ? percent(value) : short(value)}`,
    broken
      ? `The lobes ${lobes.join(', ')} do not add up to BRDF: the sum is off by ${percent(value)} ${placeOf(point)}.`
      : `Its ${lobes.length} lobes add up to the model: light that one of them reflects is counted once.`,
    worstOf(point),
  );
}

/** The largest difference of two values, relative to the larger; values below 1e-9 are as good as 0. */
function difference(a: Rgb, b: Rgb): number {
  let largest = 0;
  let scale = 1e-9;
  for (const c of [0, 1, 2] as const) {
    largest = Math.max(largest, Math.abs(a[c] - b[c]));
    scale = Math.max(scale, Math.abs(a[c]), Math.abs(b[c]));
  }
  // What is not finite is the first check's to report.
  return Number.isFinite(largest) && Number.isFinite(scale) ? largest / scale : 0;
}

function startPoints(context: Context): Point[] {
  const { model, random } = context;
  const points = Array.from({ length: context.trials(1500) }, () => randomPoint(random, model.parameters));
  for (const parameters of cornerParameters(model.parameters)) {
    for (let i = context.trials(6); i > 0; i--) points.push({ parameters, ...randomPair(random) });
  }
  return points;
}

interface TermFound extends Found {
  readonly term: string;
}

/** The largest value of an objective for BRDF and each term. */
async function searchTerms(
  context: Context,
  objective: (point: Point, term: string) => number,
): Promise<TermFound[]> {
  const points = startPoints(context);
  const results: TermFound[] = [];
  for (const term of context.model.terms) {
    results.push({ term, ...(await context.maximise(points, (point) => objective(point, term))) });
  }
  return results;
}

/**
 * What is worst of what the header does not give up; else of what it does. BRDF goes before its terms: where
 * a term breaks a law and the sum does too, the sum is what matters.
 */
function judge(
  context: Context,
  found: readonly TermFound[],
  broken: (value: number) => boolean,
): TermFound & { outcome: Outcome } {
  const judged = found.map((one) => ({ ...one, outcome: context.outcome(broken(one.value), one.term) }));
  const pick = (outcome: Outcome) => judged.filter((one) => one.outcome === outcome);
  const candidates = [pick('fail'), pick('given up'), judged].find((list) => list.length > 0) ?? judged;
  const largest = candidates.reduce((a, b) => (b.value > a.value ? b : a));
  const whole = candidates.find(({ term }) => term === 'BRDF');
  return largest.outcome !== 'pass' && whole ? whole : largest;
}
