import type { ParameterValues } from '../../brdf/model.ts';
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

/** f(l, v) of a term with some parameters. */
type Term = (l: Vec3, v: Vec3) => number;

/** An integral over h that is to be 1. */
interface Case {
  readonly worst: WorstCase;
  readonly maxEvaluations: number;
  density(term: (name: string) => Term): (h: Vec3) => number;
}

function integral(terms: (name: string) => Term, { worst, maxEvaluations, density }: Case): Integral {
  const weight = density(terms);
  const options = { focus: [[0, 0, 1] as const], tolerance: TOLERANCE, maxEvaluations };
  const { value, error } = integrateHemisphere((h) => [weight(h)], options);
  return { value: value[0] as number, error, worst };
}

function inFloat64(context: Context, parameters: ParameterValues): (name: string) => Term {
  context.use(parameters);
  return (name) => (l, v) => finite(context.evaluator.f(l, v, undefined, name)[0]);
}

function inFloat32(context: Context, parameters: ParameterValues): (name: string) => Term {
  return (name) => {
    const f = context.quick(parameters, name);
    return (l, v) => finite(f(l, v)[0]);
  };
}

/** So many of those that are furthest off in float32 are integrated again: narrow lobes are rounded there. */
const SUSPECTS = 3;

async function furthest(context: Context, cases: readonly Case[]): Promise<Integral> {
  const off = ({ value }: Integral) => Math.abs(value - 1);
  const found: { one: Case; off: number }[] = [];
  for (const [i, one] of cases.entries()) {
    await context.pulse(i / cases.length);
    found.push({ one, off: off(integral(inFloat32(context, one.worst.parameters), one)) });
  }
  found.sort((a, b) => b.off - a.off);
  const exact: Integral[] = [];
  for (const { one } of found.slice(0, SUSPECTS)) {
    await context.pulse(1);
    exact.push(integral(inFloat64(context, one.worst.parameters), one));
  }
  return exact.reduce((a, b) => (off(b) > off(a) ? b : a));
}

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
  const cases: Case[] = [];
  // Most parameters are none of the distribution's: what looks the same at a few places is done once.
  const seen = new Set<string>();
  for (const set of sets) {
    const terms = inFloat64(context, set);
    for (const name of distributions) {
      const at = terms(name);
      const key = `${name} ${PROBES.map((h) => at(h, h)).join()}`;
      if (seen.has(key)) continue;
      seen.add(key);
      cases.push({
        worst: { term: name, parameters: set, l: null, v: null },
        maxEvaluations: 20_000,
        // With light and viewer both along h, the half vector is h.
        density: (term) => {
          const D = term(name);
          return (h) => D(h, h) * h[2];
        },
      });
    }
  }
  const found = await furthest(context, cases);
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
  const cases: Case[] = [];
  const seen = new Set<string>();
  for (const set of sets) {
    const terms = inFloat64(context, set);
    for (const { masking, distribution } of maskings) {
      const [G1, D] = [terms(masking), terms(distribution)];
      const key = `${masking} ${PROBES.map((h) => G1(h, direction(0.5, 0.7)) * D(h, h)).join()}`;
      if (seen.has(key)) continue;
      seen.add(key);
      for (const cosine of VIEWS) {
        const v = direction(cosine, 0.4);
        cases.push({
          worst: { term: masking, parameters: set, l: null, v },
          maxEvaluations: 12_000,
          density: (term) => {
            const [g1, d] = [term(masking), term(distribution)];
            return (h) => {
              const facing = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
              return facing > 0 ? (g1(h, v) * d(h, h) * facing) / cosine : 0;
            };
          },
        });
      }
    }
  }
  const found = await furthest(context, cases);
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
