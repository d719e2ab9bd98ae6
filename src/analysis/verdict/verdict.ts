/**
 * The verdict: a model held to the laws of physics and to its own promises. docs/verdict.md explains each law
 * with its reference.
 */
import { BrdfError } from '../../brdf/error.ts';
import type { Model } from '../../glsl/model.ts';
import { checkEnergy, checkFurnace } from './albedo-checks.ts';
import { Context } from './context.ts';
import { checkContinuity } from './continuity.ts';
import { checkDistribution, checkWeakFurnace } from './facet-checks.ts';
import { checkGpu } from './gpu-agreement.ts';
import { checkFiniteness, checkLobes, checkPositivity, checkReciprocity } from './pointwise.ts';
import { checkDensity, checkSampler } from './sampling.ts';
import type { Check, Property, Verdict, VerdictOptions } from './types.ts';

export type * from './types.ts';

/** Each law, with the share of the time that it takes (measured with principled). */
const CHECKS: readonly {
  property: Property;
  share: number;
  run: (c: Context, o: VerdictOptions) => Promise<Check>;
}[] = [
  { property: 'finiteness', share: 0.1, run: checkFiniteness },
  { property: 'positivity', share: 0.05, run: checkPositivity },
  { property: 'reciprocity', share: 0.1, run: checkReciprocity },
  { property: 'energy', share: 0.3, run: checkEnergy },
  { property: 'furnace', share: 0.02, run: checkFurnace },
  { property: 'distribution', share: 0.08, run: checkDistribution },
  { property: 'weak furnace', share: 0.02, run: checkWeakFurnace },
  { property: 'lobes', share: 0.03, run: checkLobes },
  { property: 'continuity', share: 0.1, run: checkContinuity },
  { property: 'density', share: 0.05, run: checkDensity },
  { property: 'sampler', share: 0.1, run: checkSampler },
  { property: 'gpu', share: 0.05, run: (context, { gpu }) => checkGpu(context, gpu) },
];

/**
 * Holds a model to every law.
 *
 * @throws BrdfError if the header names a term that the model does not have; whatever the signal aborts with
 */
export async function checkModel(model: Model, options: VerdictOptions = {}): Promise<Verdict> {
  checkDeclaredTerms(model);
  const checks: Check[] = [];
  let before = 0;
  for (const { property, share, run } of CHECKS) {
    options.signal?.throwIfAborted();
    const report = (done: number) => options.onProgress?.(before + share * done, property);
    report(0);
    checks.push(await run(new Context(model, property, options, report), options));
    before = Math.min(1, before + share);
  }
  options.onProgress?.(1, 'gpu');
  return { model: model.name, checks, sound: checks.every(({ outcome }) => outcome !== 'fail') };
}

function checkDeclaredTerms({ file, terms }: Model): void {
  const { givesUp, lobes, distributions, maskings } = file.declarations;
  const masked = maskings.flatMap(({ masking, distribution }) => [masking, distribution]);
  const named = [...givesUp.flatMap(({ term }) => term ?? []), ...lobes, ...distributions, ...masked];
  const unknown = named.find((name) => !terms.includes(name));
  if (unknown === undefined) return;
  const place = { file: file.fileName, line: 1 };
  throw new BrdfError(place, `the header names '${unknown}', which is no term`, `one of ${terms.join(', ')}`);
}
