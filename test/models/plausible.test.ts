import { describe, expect, it } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { cornerParameters, hostilePairs, randomDirection, randomParameters } from './hostile.ts';

describe.each([...shippedModels])('%s', (_name, model) => {
  const evaluator = createEvaluator(model);

  it('is finite and not negative wherever its formulas might not be', { timeout: 120_000 }, () => {
    const pairs = hostilePairs();
    for (const p of cornerParameters(model.parameters, 4)) {
      evaluator.set(p);
      for (const [l, v] of pairs) {
        for (const term of model.terms) {
          const f = evaluator.f(l, v, undefined, term);
          if (!f.every((value) => value >= 0 && value < 1e30))
            expect.fail(`${term} is ${f} at ${JSON.stringify({ l, v, p })}`);
        }
        const density = evaluator.pdf(l, v);
        if (!(density >= 0 && density < 1e30))
          expect.fail(`pdf is ${density} at ${JSON.stringify({ l, v, p })}`);
      }
    }
  });

  const transmits = model.file.transmission !== null;

  it('is zero below the horizon', () => {
    for (const [l, v] of hostilePairs()) {
      if ((l[2] > 0 || transmits) && v[2] > 0) continue;
      for (const term of model.terms) expect(evaluator.f(l, v, undefined, term)).toEqual([0, 0, 0]);
      expect(evaluator.pdf(l, v)).toBe(0);
    }
  });

  it('is reciprocal: f(l, v) = f(v, l), in every term', () => {
    const random = createRandom(31);
    for (let i = 0; i < 1000; i++) {
      const p = randomParameters(random, model.parameters);
      evaluator.set(p);
      const [l, v] = [randomDirection(random), randomDirection(random)];
      for (const term of model.terms) {
        // The masking of one direction does not say what the other is.
        if (model.file.declarations.maskings.some(({ masking }) => masking === term)) continue;
        const forth = evaluator.f(l, v, undefined, term);
        const back = evaluator.f(v, l, undefined, term);
        for (const [c, value] of forth.entries()) {
          if (Math.abs(value - back[c]!) > 1e-12 * Math.abs(value)) {
            expect.fail(`${term} is ${forth}, backwards ${back} at ${JSON.stringify({ l, v, p })}`);
          }
        }
      }
    }
  });

  it('samples directions on the sides that it may, of unit length, with a density that is there', () => {
    const random = createRandom(32);
    const edges = [0, 1e-9, 0.5, 1 - 2 ** -24, 1 - 2 ** -53];
    for (const p of cornerParameters(model.parameters, 4)) {
      evaluator.set(p);
      for (const u of edges.flatMap((a) => edges.map((b) => [a, b] as const))) {
        for (const v of [
          [0, 0, 1] as const,
          randomDirection(random),
          [1, 0, 0] as const,
          [0, 0, -1] as const,
        ]) {
          const l = evaluator.sampleL(u, v);
          if (!l) continue;
          expect(v[2]).toBeGreaterThan(0);
          expect(transmits ? Math.abs(l[2]) : l[2]).toBeGreaterThan(0);
          expect(Math.hypot(...l)).toBeCloseTo(1, 9);
          expect(evaluator.pdf(l, v)).toBeGreaterThan(0);
        }
      }
    }
  });

  it('describes every parameter', () => {
    for (const { name, description } of model.parameters) expect(description, name).toMatch(/\w.*\.$/);
    expect(model.file.documentation).toContain('References');
  });
});
