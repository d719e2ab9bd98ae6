import { integrateHemisphere } from '../quadrature.ts';
import { direction, type Vec3 } from '../vector.ts';
import { type Context, percent, placeOf, short } from './context.ts';
import { cornerParameters, randomParameters } from './space.ts';
import type { Check, WorstCase } from './types.ts';

/** Laws of microfacets: D's normalisation, and the weak white furnace. */

/** What quadrature may be wrong by before a law counts as broken. */
const TOLERANCE = 1e-3;

const finite = (x: number) => (Number.isFinite(x) ? x : 0);

interface Integral {
  readonly value: number;
  readonly error: number;
  readonly worst: WorstCase;
}

/** An integral over h that is to be 1. */
function integral(density: (h: Vec3) => number, worst: WorstCase, maxEvaluations: number): Integral {
  const { value, error } = integrateHemisphere((h) => [density(h)], {
    focus: [[0, 0, 1]],
    tolerance: TOLERANCE,
    maxEvaluations,
  });
  return { value: value[0] as number, error, worst };
}

const further = (a: Integral | null, b: Integral) =>
  a && Math.abs(a.value - 1) >= Math.abs(b.value - 1) ? a : b;
const isBroken = ({ value, error }: Integral) => Math.abs(value - 1) > 2 * TOLERANCE + Math.min(error, 0.01);

function parameterSets(context: Context, random: number) {
  const { parameters } = context.model;
  const drawn = Array.from({ length: context.trials(random) }, () =>
    randomParameters(context.random, parameters),
  );
  return [...cornerParameters(parameters), ...drawn];
}

const PROBES: readonly Vec3[] = [direction(1, 0), direction(0.9, 0.3), direction(0.4, 1)];

export async function checkDistribution(context: Context): Promise<Check> {
  const { distributions } = context.model.file.declarations;
  if (distributions.length === 0) {
    return context.notApplicable(
      "The header has no line 'distributions:', so no term is known to count facets.",
    );
  }
  const sets = parameterSets(context, 10);
  let worst: Integral | null = null;
  // Most parameters are none of the distribution's: what looks the same at a few places is done once.
  const seen = new Set<string>();
  for (const [i, set] of sets.entries()) {
    await context.pulse(i / sets.length);
    context.use(set);
    for (const term of distributions) {
      const looks = PROBES.map((h) => context.evaluator.f(h, h, undefined, term)[0]);
      const key = `${term} ${looks.join()}`;
      if (seen.has(key)) continue;
      seen.add(key);
      // With light and viewer both along h, the half vector is h.
      const density = (h: Vec3) => finite(context.evaluator.f(h, h, undefined, term)[0]) * h[2];
      worst = further(worst, integral(density, { term, parameters: set, l: null, v: null }, 20_000));
    }
  }
  const found = worst as unknown as Integral;
  const broken = isBroken(found);
  return context.check(
    broken ? 'fail' : 'pass',
    found.value,
    `integral ${short(found.value)}`,
    broken
      ? `The facets of ${found.worst.term}, seen from above, cover ${percent(found.value)} of the surface, not 100 %: ` +
          'some are counted too often, or are missing.'
      : 'The tiny facets, seen from above, cover the surface exactly once: the distribution is normalised.',
    found.worst,
  );
}

/** From nearly above to 3 degrees above the horizon. */
const VIEWS = [0.9, 0.3, 0.05];

/**
 * E. Heitz, 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2): the facets
 * that are seen cover the view, whose area is n.v: the integral of G1(v, h) D(h) max(v.h, 0)/(n.v) over h is 1.
 */
export async function checkWeakFurnace(context: Context): Promise<Check> {
  const { maskings } = context.model.file.declarations;
  if (maskings.length === 0) {
    return context.notApplicable(
      "The header has no line 'masking:', so no term is known to say which facets are seen from one side.",
    );
  }
  const sets = parameterSets(context, 4);
  let worst: Integral | null = null;
  const seen = new Set<string>();
  for (const [i, set] of sets.entries()) {
    context.use(set);
    for (const { masking, distribution } of maskings) {
      const at = (h: Vec3, v: Vec3) =>
        finite(context.evaluator.f(h, v, undefined, masking)[0]) *
        finite(context.evaluator.f(h, h, undefined, distribution)[0]);
      const key = `${masking} ${PROBES.map((h) => at(h, direction(0.5, 0.7))).join()}`;
      if (seen.has(key)) continue;
      seen.add(key);
      for (const cosine of VIEWS) {
        await context.pulse(i / sets.length);
        const v = direction(cosine, 0.4);
        const density = (h: Vec3) => {
          const facing = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
          return facing > 0 ? (at(h, v) * facing) / cosine : 0;
        };
        worst = further(worst, integral(density, { term: masking, parameters: set, l: null, v }, 12_000));
      }
    }
  }
  const found = worst as unknown as Integral;
  const broken = isBroken(found);
  return context.check(
    broken ? 'fail' : 'pass',
    found.value,
    `integral ${short(found.value)}`,
    broken
      ? `The facets that ${found.worst.term} leaves to be seen cover ${percent(found.value)} of the view ` +
          `${placeOf(found.worst)}, not 100 %: masking and distribution do not belong to one surface.`
      : 'Wherever one looks from, the facets that are seen cover the view exactly once: masking and distribution ' +
          'belong to one surface.',
    found.worst,
  );
}
