import type { ParameterValues } from '../../brdf/model.ts';
import { directionalAlbedo } from '../albedo.ts';
import type { Reflectance } from '../plots/curve.ts';
import { direction, type Vec3 } from '../vector.ts';
import { type Context, percent, placeOf, short } from './context.ts';
import { cornerParameters, endsOf, moved, nearParameters, randomParameters } from './space.ts';
import type { Check } from './types.ts';

/** Laws about the light that goes anywhere: energy and the white furnace. */

/** The lowest cosine at which albedos are integrated: 0.6 degrees above the horizon. */
const LOWEST = 0.01;
/** What quadrature may be wrong by before a law counts as broken. */
const TOLERANCE = 1e-3;

interface Albedo {
  readonly parameters: ParameterValues;
  readonly v: Vec3;
  /** The brightest channel. */
  readonly value: number;
  readonly error: number;
}

const finite = (x: number) => (Number.isFinite(x) ? x : 0);

/** What is not finite is another check's to report; here it would only keep the quadrature from ending. */
function finiteBrdf(f: Reflectance): Reflectance {
  return (l, v) => {
    const [r, g, b] = f(l, v);
    return [finite(r), finite(g), finite(b)];
  };
}

/** One pass of quadrature in float32: some 1600 evaluations, enough to tell a dangerous case from a harmless one. */
function rough(context: Context, parameters: ParameterValues, v: Vec3): Albedo {
  const f = finiteBrdf(context.quick(parameters));
  const { value, error } = directionalAlbedo(f, v, { backward: false, maxEvaluations: 1 });
  return { parameters, v, value: Math.max(...value), error };
}

/** An albedo to be stated. */
function precise(context: Context, parameters: ParameterValues, v: Vec3, maxEvaluations = 6000): Albedo {
  const options = { tolerance: TOLERANCE, maxEvaluations };
  context.use(parameters);
  const f = finiteBrdf((l, w) => context.evaluator.f(l, w));
  const { value, error } = directionalAlbedo(f, v, options);
  return { parameters, v, value: Math.max(...value), error };
}

const larger = (a: Albedo, b: Albedo) => (b.value > a.value ? b : a);
/** The one that is surely larger: a wild figure with a wild error must not displace a sound one. */
const surer = (a: Albedo, b: Albedo) => (b.value - b.error > a.value - a.error ? b : a);

export async function checkEnergy(context: Context): Promise<Check> {
  const { parameters } = context.model;
  const { random } = context;
  const sets = cornerParameters(parameters).map((set) => ({ set, cosines: [1, LOWEST] }));
  for (let i = context.trials(parameters.length ? 24 : 1); i > 0; i--)
    sets.push({ set: randomParameters(random, parameters), cosines: [LOWEST + (1 - LOWEST) * random()] });

  const found: Albedo[] = [];
  for (const [i, { set, cosines }] of sets.entries()) {
    for (const cosine of cosines) {
      await context.pulse((0.6 * i) / sets.length);
      // Two azimuths would show what depends on the tangent; one oblique to both axes shows some of it.
      found.push(rough(context, set, direction(cosine, 0.4)));
    }
  }
  const confirmed = await confirm(context, found);
  const top = await refine(context, confirmed);
  const worst = top === confirmed ? confirmed : surer(confirmed, precise(context, top.parameters, top.v));
  const broken = worst.value - worst.error > 1 + TOLERANCE;
  const place = { l: null, v: worst.v };
  return context.check(
    context.outcome(broken),
    worst.value,
    `albedo up to ${short(worst.value)}`,
    broken
      ? `${placeOf(place).replace(/^w/, 'W')}, the surface gives back ${short(worst.value)} times the light that ` +
          'it receives: in a white room it would glow.'
      : `The surface gives back at most ${percent(Math.max(0, worst.value))} of the light that it receives: it makes none.`,
    { term: 'BRDF', parameters: worst.parameters, ...place },
  );
}

/** What confirming may cost, in precise quadratures. */
const CONFIRMATIONS = 6;

/**
 * The largest albedo of those found. Rough figures of narrow lobes can be too high by far, so whatever leads
 * is measured again, at first with a little more care, until one leads that has been measured with all care.
 */
async function confirm(context: Context, found: readonly Albedo[]): Promise<Albedo> {
  const queue = found.map((albedo) => ({ albedo, level: albedo.error < 0.01 ? 1 : 0 }));
  let best: Albedo | null = null;
  for (let spent = 0; spent < CONFIRMATIONS; ) {
    await context.pulse(0.6 + (0.2 * spent) / CONFIRMATIONS);
    const lead = queue.reduce((a, b) => (b.albedo.value > a.albedo.value ? b : a));
    if (best && best.value >= lead.albedo.value) return best;
    const { parameters, v } = lead.albedo;
    if (lead.level === 0) {
      lead.albedo = precise(context, parameters, v, 2500);
      lead.level = 1;
      spent += 0.5;
      continue;
    }
    const careful = precise(context, parameters, v);
    spent++;
    best = best ? surer(best, careful) : careful;
    lead.albedo = { ...careful, value: Number.NEGATIVE_INFINITY };
  }
  return best ?? precise(context, (found[0] as Albedo).parameters, (found[0] as Albedo).v);
}

/** Climbs from the worst case: each parameter to either end of its range, then small steps of all of them. */
async function refine(context: Context, start: Albedo): Promise<Albedo> {
  const { parameters } = context.model;
  let top = start;
  for (const [i, parameter] of parameters.entries()) {
    await context.pulse(0.8 + (0.1 * i) / parameters.length);
    for (const value of endsOf(parameter)) {
      if (JSON.stringify(value) === JSON.stringify(top.parameters[parameter.name])) continue;
      top = larger(top, rough(context, { ...top.parameters, [parameter.name]: value }, top.v));
    }
  }
  let reach = 0.3;
  for (let i = 0, steps = context.trials(24); i < steps; i++) {
    await context.pulse(0.9 + (0.1 * i) / steps);
    const set = nearParameters(context.random, parameters, top.parameters, reach);
    const next = rough(context, set, moved(context.random, top.v, reach, LOWEST));
    if (next.value > top.value) top = next;
    else reach = Math.max(0.01, reach * 0.9);
  }
  return top;
}

export async function checkFurnace(context: Context): Promise<Check> {
  const { lossless } = context.model.file.declarations;
  if (!lossless) {
    return context.notApplicable(
      "The header has no line 'lossless:', so the model does not claim to give back all light for any parameters.",
    );
  }
  let worst: Albedo | null = null;
  const sets = context.trials(6);
  for (let i = 0; i < sets; i++) {
    const parameters = { ...randomParameters(context.random, context.model.parameters), ...lossless };
    for (const cosine of [1, 0.7, 0.3, 0.1, LOWEST]) {
      await context.pulse(i / sets);
      const next = precise(context, parameters, direction(cosine, 2 * Math.PI * context.random()));
      if (!worst || Math.abs(next.value - 1) > Math.abs(worst.value - 1)) worst = next;
    }
  }
  const { value, error, v, parameters } = worst as unknown as Albedo;
  const broken = Math.abs(value - 1) > TOLERANCE + error;
  const place = { l: null, v };
  return context.check(
    broken ? 'fail' : 'pass',
    value,
    `albedo ${short(value)}`,
    broken
      ? `In a furnace that glows white all over, the surface gives back ${percent(value)} of the light ${placeOf(place)}, ` +
          'where the header promises all of it.'
      : 'In a furnace that glows white all over, the surface cannot be seen: it gives back exactly what it receives.',
    { term: 'BRDF', parameters, ...place },
  );
}
