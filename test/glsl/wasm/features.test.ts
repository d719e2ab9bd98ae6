import { describe, expect, test } from 'vitest';
import { loadModel } from '../../../models/index.ts';
import { FEATURES, type FeatureCase, model } from '../features.ts';
import { modelCalls } from './calls.ts';

describe('GLSL as WebAssembly gives what GLSL defines', () => {
  test.each<FeatureCase>(FEATURES)('%s', (_, body, before, expected) => {
    const call = modelCalls(loadModel(model(body, before), 'test.brdf'), ['BRDF']);
    const got = call('BRDF', {}, [0.6, 0, 0.8], [0, 0, 1], [0, 0, 1], [1, 0, 0], [0, 1, 0]);
    for (let c = 0; c < 3; c++) expect(got[c]).toBeCloseTo(expected[c] as number, 6);
  });
});
