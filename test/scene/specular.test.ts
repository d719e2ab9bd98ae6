/** What is said of the models' parameters is what the models do. */
import { expect, test } from 'vitest';
import { shippedModels } from '../../models/index.ts';
import { createEvaluator } from '../../src/glsl/evaluator.ts';
import { iorOf, iorOfThesisSpecular, reflectanceOfIor } from '../../src/scene/specular.ts';

const UP = [0, 0, 1] as const;

test.each([
  ['principled', iorOf],
  ['principled-thesis', iorOfThesisSpecular],
] as const)('specular of %s is the index of refraction that is told', (name, ior) => {
  const model = shippedModels.get(name)!;
  for (const specular of [0.1, 0.5, 1]) {
    const evaluator = createEvaluator(model, { specular, metallic: 0 });
    // Of a facet that is seen and lit head-on.
    expect(evaluator.f(UP, UP, undefined, 'fresnel')[0]).toBeCloseTo(reflectanceOfIor(ior(specular)), 10);
  }
});
