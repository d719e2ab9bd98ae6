import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../../models/index.ts';
import type { Check, Property, Verdict } from '../../../src/analysis/verdict/verdict.ts';
import { checkModel } from '../../../src/analysis/verdict/verdict.ts';
import type { Model } from '../../../src/glsl/model.ts';
import { FAULTS, facets, maskedFacets, model, sound, term } from './faults.ts';

type Checks = Record<Property, Check>;
/** Verdicts are the same each time: what one test has had computed serves the next one. */
const known = new Map<Model, Promise<Checks>>();

const outcomes = (subject: Model): Promise<Checks> => {
  const checks = known.get(subject) ?? checksOf(subject, 0.3);
  known.set(subject, checks);
  return checks;
};

const checksOf = async (subject: Model, effort: number): Promise<Checks> => {
  const { checks } = await checkModel(subject, { effort });
  return Object.fromEntries(checks.map((check) => [check.property, check])) as Checks;
};

const failures = (checks: Checks) =>
  Object.values(checks)
    .filter(({ outcome }) => outcome === 'fail')
    .map(({ property }) => property);

/** What each fault breaks, and nothing else. */
const EXPECTED: Record<keyof typeof FAULTS, readonly Property[]> = {
  'a factor 2': ['energy'],
  'a missing 1/pi': ['energy'],
  'too dark in a furnace': ['furnace'],
  'swapped L and V in one factor': ['reciprocity'],
  'a negative lobe': ['positivity'],
  'a NaN at grazing': ['finiteness'],
  'an infinity at grazing': ['finiteness'],
  'a hard edge': ['continuity'],
  'a slider with a step': ['continuity'],
  'a density off by the Jacobian': ['density', 'sampler'],
  'a density that is too uniform': ['sampler'],
  'samples below the surface': ['sampler'],
  'samples of any length': ['sampler'],
  'a negative density': ['density', 'sampler'],
  'a distribution that is not normalised': ['distribution'],
  'a masking of another roughness': ['weak furnace'],
  'a lobe that is counted twice': ['lobes'],
};

describe('planted faults are named rightly', () => {
  it.each(Object.entries(EXPECTED))('%s', async (name, expected) => {
    const checks = await outcomes(FAULTS[name as keyof typeof FAULTS]);
    expect(failures(checks)).toEqual(expected);
    for (const property of expected) {
      expect(checks[property].sentence).toMatch(/^[A-Za-z].*\.$/);
      expect(checks[property].worst).not.toBeNull();
    }
  });

  it('with figures that are right', async () => {
    const twice = await outcomes(FAULTS['a factor 2']);
    expect(twice.energy.figure).toBeCloseTo(2, 3);
    expect(twice.energy.worst?.parameters).toEqual({ albedo: [1, 1, 1] });
    expect((await outcomes(FAULTS['a missing 1/pi'])).energy.figure).toBeCloseTo(Math.PI, 3);
    const negative = (await outcomes(FAULTS['a negative lobe'])).positivity;
    // White, and h = n.
    expect(negative.figure).toBeCloseTo(-0.2 / Math.PI, 3);
    expect((await outcomes(FAULTS['a distribution that is not normalised'])).distribution.figure).toBeCloseTo(
      2 / 3,
      3,
    );
    expect((await outcomes(FAULTS['a hard edge'])).continuity.figure).toBeCloseTo(0.1, 3);
    expect((await outcomes(FAULTS['a lobe that is counted twice'])).lobes.figure).toBeCloseTo(0.1 / 1.1, 6);
  });
});

describe('what is sound passes', () => {
  it('a matte surface with its sampler', async () => {
    const checks = await checksOf(sound(), 1);
    expect(failures(checks)).toEqual([]);
    for (const property of ['furnace', 'lobes', 'density', 'sampler', 'energy'] as const)
      expect(checks[property].outcome, property).toBe('pass');
    expect(checks.energy.figure).toBeCloseTo(1, 4);
    for (const property of ['distribution', 'weak furnace', 'gpu'] as const)
      expect(checks[property].outcome, property).toBe('not applicable');
  });

  it('a distribution that is normalised', async () => {
    const { distribution } = await outcomes(facets('(2.0 * PI)'));
    expect(distribution).toMatchObject({ outcome: 'pass', figure: expect.closeTo(1, 3) });
  });

  it('facets with the masking that is theirs', async () => {
    const { 'weak furnace': furnace, reciprocity } = await outcomes(maskedFacets('1.0'));
    expect(furnace).toMatchObject({ outcome: 'pass', figure: expect.closeTo(1, 2) });
    // G1 is of one direction, which is no fault.
    expect(reciprocity.outcome).toBe('pass');
  });
});

describe('models that ship', () => {
  const verdicts = new Map<string, Verdict>();

  it.each([...shippedModels])(
    '%s breaks no law but those that its header gives up',
    async (name, subject) => {
      const verdict = await checkModel(subject, { effort: 0.2 });
      verdicts.set(name, verdict);
      expect(verdict.checks.filter(({ outcome }) => outcome === 'fail')).toEqual([]);
      expect(verdict.sound).toBe(true);
    },
  );

  const given = (name: string) =>
    (verdicts.get(name)?.checks ?? []).filter(({ outcome }) => outcome === 'given up');

  it('lambert and cook-torrance give up nothing', () => {
    expect([...given('lambert'), ...given('cook-torrance')]).toEqual([]);
  });

  it('principled and principled-thesis give up energy; the product of the thesis costs far more', () => {
    const [burley, ...others] = given('principled');
    const [thesis, ...more] = given('principled-thesis');
    expect([burley?.property, thesis?.property, ...others, ...more]).toEqual(['energy', 'energy']);
    expect(burley?.figure).toBeGreaterThan(1.6);
    expect(burley?.figure).toBeLessThan(1.9);
    expect(thesis?.figure).toBeGreaterThan(60);
    expect(thesis?.worst?.parameters.subsurface).toBeGreaterThan(0.9);
  });
});

describe('what a header gives up', () => {
  const oneWay = (header: string) =>
    model({ header, terms: term('oneWay', 'return vec3(NdotL);'), body: 'return vec3(0.1);' });

  it('is said to be given up, in that term only', async () => {
    expect((await outcomes(oneWay(''))).reciprocity).toMatchObject({
      outcome: 'fail',
      worst: { term: 'oneWay' },
    });
    expect((await outcomes(oneWay('gives up: reciprocity of oneWay'))).reciprocity.outcome).toBe('given up');
    expect((await outcomes(oneWay('gives up: reciprocity'))).reciprocity.outcome).toBe('given up');
    expect((await outcomes(oneWay('gives up: reciprocity of BRDF'))).reciprocity.outcome).toBe('fail');
  });

  it('may name only terms that there are', async () => {
    await expect(outcomes(oneWay('lobes: missing'))).rejects.toThrow(
      "planted.brdf:1: the header names 'missing', which is no term; expected one of BRDF, oneWay",
    );
  });
});

describe('a run', () => {
  it('gives the same for the same seed, and other cases for another', async () => {
    const subject = FAULTS['swapped L and V in one factor'];
    const [first, again, other] = await Promise.all(
      [1, 1, 2].map((seed) => checkModel(subject, { effort: 0.2, seed })),
    );
    expect(again).toEqual(first);
    expect(other).not.toEqual(first);
  });

  it('tells how far it is, and can be stopped', async () => {
    const seen: number[] = [];
    await checkModel(sound(), { effort: 0.2, onProgress: (done) => seen.push(done) });
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    expect([seen[0], seen.at(-1)]).toEqual([0, 1]);

    const controller = new AbortController();
    const run = checkModel(sound(), {
      effort: 0.2,
      signal: controller.signal,
      onProgress: (_, property) => property === 'energy' && controller.abort(new Error('enough')),
    });
    await expect(run).rejects.toThrow('enough');
  });

  it('compares a GPU where one is given', async () => {
    const subject = sound();
    const answer = (factor: number) => async (_: string, points: readonly { parameters: unknown }[]) => {
      return points.map(({ parameters }) => {
        const { albedo } = parameters as { albedo: [number, number, number] };
        const share = (factor / Math.PI) * (_ === 'halfLobe' ? 0.25 : _ === 'otherLobe' ? 0.75 : 1);
        return [albedo[0] * share, albedo[1] * share, albedo[2] * share] as const;
      });
    };
    const gpuCheck = async (factor: number) =>
      (await checkModel(subject, { effort: 0.2, gpu: answer(factor) })).checks.at(-1);
    expect(await gpuCheck(1)).toMatchObject({ property: 'gpu', outcome: 'pass' });
    expect(await gpuCheck(1.1)).toMatchObject({ outcome: 'fail', figure: expect.closeTo(0.1, 6) });
  });
});
