import { expect, test } from 'vitest';
import { testRenderer } from '../support/gpu.ts';
import { compareDeformed } from './deformed-mesh.ts';
import { SIZE } from './lit-sphere.ts';

const { renderer } = await testRenderer(SIZE, SIZE);
const results = await compareDeformed(renderer);

test.each(results)(
  'a mesh that is $deformation looks as if it were baked, $material',
  ({ count, different }) => {
    expect(count).toBeGreaterThan(1000);
    expect(different).toBeLessThan(0.01);
  },
);
