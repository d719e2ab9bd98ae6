import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import type { Model } from '../../src/glsl/model.ts';
import { GpuEvaluation } from '../../src/realtime/gpu-evaluation.ts';
import { randomPoints } from '../glsl/comparison.ts';
import { testRenderer } from '../support/gpu.ts';

const { renderer } = await testRenderer(1, 1);

test('values come in the order of the queries, and as float64 has them', async () => {
  const model = shippedModels.get('principled') as Model;
  const evaluator = createEvaluator(model);
  // More than one run of the shader, the last one not full.
  const queries = randomPoints(model, 2100);
  const evaluation = new GpuEvaluation(renderer, model, 'BRDF');
  const values = await evaluation.evaluate(queries);
  expect(values).toHaveLength(queries.length);
  let worst = 0;
  for (const [i, { l, v, parameters }] of queries.entries()) {
    evaluator.set(parameters);
    const exact = evaluator.f(l, v);
    const scale = Math.max(1e-4, ...exact.map(Math.abs));
    for (const [c, value] of exact.entries())
      worst = Math.max(worst, Math.abs(values[i]![c]! - value) / scale);
  }
  expect(worst).toBeLessThan(0.01);
  evaluation.dispose();
});
