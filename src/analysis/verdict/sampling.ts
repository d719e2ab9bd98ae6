import type { ParameterValues } from '../../brdf/model.ts';
import { sidakLevel } from '../chi-squared.ts';
import { integrateReflection } from '../reflection-quadrature.ts';
import { type SamplerTestResult, testSampler } from '../sampler-test.ts';
import { direction, type Vec3 } from '../vector.ts';
import { type Context, percent, placeOf, short } from './context.ts';
import { cornerParameters, randomParameters, randomPoint } from './space.ts';
import type { Check } from './types.ts';

/** Laws about the sampling that a file brings along: pdf() is a density, and it is that of sampleL(). */

const NONE = 'The file has no section for sampling; a general sampler serves it.';

const mirrorOf = (v: Vec3): Vec3 => [-v[0], -v[1], v[2]];

/** The density as a quadrature and a test of counts take it: a number, and not negative. */
const usable = (pdf: number) => (Number.isFinite(pdf) ? Math.max(0, pdf) : 0);

/** The integral of pdf over all directions: in float32 to find where it is largest, in float64 to state it. */
function mass(context: Context, parameters: ParameterValues, v: Vec3, exact: boolean) {
  if (exact) context.use(parameters);
  const pdf = exact ? context.evaluator.pdf : context.quickPdf(parameters);
  const options = { tolerance: 1e-3, maxEvaluations: 6000 };
  const { value, error } = integrateReflection((l) => [usable(pdf(l, v))], v, options);
  return { value: value[0] as number, error, parameters, v };
}

export async function checkDensity(context: Context): Promise<Check> {
  const { model, random } = context;
  if (!model.hasSampling) return context.notApplicable(NONE);
  let lowest = {
    value: 0,
    parameters: {} as ParameterValues,
    l: null as Vec3 | null,
    v: null as Vec3 | null,
  };
  for (let i = context.trials(3000); i > 0; i--) {
    const { parameters, l, v } = randomPoint(random, model.parameters);
    context.use(parameters);
    const value = context.evaluator.pdf(l, v);
    if (value < lowest.value) lowest = { value, parameters, l, v };
  }
  if (lowest.value < -1e-9) {
    return context.check(
      'fail',
      lowest.value,
      `${short(lowest.value)} /sr`,
      `pdf is ${short(lowest.value)} ${placeOf(lowest)}: no direction is less likely than impossible.`,
      { term: 'pdf', parameters: lowest.parameters, l: lowest.l, v: lowest.v },
    );
  }
  const sets = [
    ...cornerParameters(model.parameters).slice(0, 4),
    ...Array.from({ length: context.trials(8) }, () => randomParameters(random, model.parameters)),
  ];
  const masses: ReturnType<typeof mass>[] = [];
  for (const [i, parameters] of sets.entries()) {
    for (const v of [direction(0.9, 0.5), direction(0.2, 4)]) {
      await context.pulse(i / sets.length);
      masses.push(mass(context, parameters, v, false));
    }
  }
  const sure = ({ value, error }: { value: number; error: number }) => value - error;
  const largest = masses.reduce((a, b) => (sure(b) > sure(a) ? b : a));
  const worst = mass(context, largest.parameters, largest.v, true);
  const broken = worst.value - worst.error > 1.002;
  const place = { l: null, v: worst.v };
  return context.check(
    broken ? 'fail' : 'pass',
    worst.value,
    `integral up to ${short(worst.value)}`,
    broken
      ? `The probabilities of all directions together are ${percent(worst.value)}, not at most 100 %, ${placeOf(place)}: ` +
          'pictures come out too dark.'
      : 'The probabilities of all directions together are at most 100 %; what lacks are samples below the surface.',
    { term: 'pdf', parameters: worst.parameters, ...place },
  );
}

/** The chance that all tests together condemn a sound sampler; with a fixed seed they do so always or never. */
const LEVEL = 1e-4;
const CASES = 8;
/** More than this share of misplaced density would be the quadrature's fault and not the sampler's. */
const UNRESOLVED = 0.02;

const WRONG_DIRECTIONS = {
  'below the surface': 'no light comes from there, and the sample should be given up as vec3(0)',
  'not of length 1': 'a direction is a unit vector',
};

export async function checkSampler(context: Context): Promise<Check> {
  const { model, random } = context;
  if (!model.hasSampling) return context.notApplicable(NONE);
  const views = [direction(1, 0), direction(0.7, 0.5), direction(0.2, 4)];
  const wanted = context.trials(CASES);
  const level = sidakLevel(LEVEL, wanted);
  let worst: { result: SamplerTestResult; parameters: ParameterValues; v: Vec3 } | null = null;
  let done = 0;
  for (let attempt = 0; done < wanted && attempt < 2 * wanted; attempt++) {
    await context.pulse(done / wanted);
    const v = views[attempt % views.length] as Vec3;
    const defaults = attempt < views.length;
    const parameters = defaults ? {} : randomParameters(random, model.parameters);
    context.use(parameters);
    let wrong: keyof typeof WRONG_DIRECTIONS | null = null;
    const result = testSampler(
      {
        sample: (u) => {
          const l = context.evaluator.sampleL(u, v);
          if (l && !(Math.abs(Math.hypot(...l) - 1) < 1e-6)) wrong = 'not of length 1';
          else if (l && !(l[2] >= 0)) {
            // Where light passes through, the other side is as good; what is tested is this one.
            if (model.file.transmission) return null;
            wrong = 'below the surface';
          }
          return wrong ? null : l;
        },
        pdf: (l) => usable(context.evaluator.pdf(l, v)),
      },
      { samples: context.trials(5000), random, cells: [6, 12], focus: [mirrorOf(v)], maxEvaluations: 400 },
    );
    const place = { l: null, v };
    if (wrong) {
      const kind = wrong as keyof typeof WRONG_DIRECTIONS;
      const sentence = `sampleL gives directions that are ${kind} ${placeOf(place)}: ${WRONG_DIRECTIONS[kind]}.`;
      return context.check('fail', 0, kind, sentence, { term: 'sampleL', parameters, ...place });
    }
    // A lobe much narrower than a cell of the histogram cannot be judged by it.
    if (result.error > UNRESOLVED) continue;
    done++;
    if (!worst || result.pValue < worst.result.pValue) worst = { result, parameters, v };
  }
  if (!worst)
    return context.notApplicable('All lobes that were tried are narrower than the cells of the histogram.');
  const { result, parameters, v } = worst as {
    result: SamplerTestResult;
    parameters: ParameterValues;
    v: Vec3;
  };
  const broken = result.pValue < level;
  const place = { l: null, v };
  return context.check(
    broken ? 'fail' : 'pass',
    result.pValue,
    `p = ${short(result.pValue)} in ${done} tests`,
    broken
      ? `sampleL does not choose directions as pdf says ${placeOf(place)}: a path tracer would light this surface wrongly.`
      : 'sampleL chooses directions as often as pdf says: a path tracer lights this surface rightly.',
    { term: 'sampleL', parameters, ...place },
  );
}
