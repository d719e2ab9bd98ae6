/** Small documents for tests of the path tracer. */
import { parseDocument } from '../../src/scene/document.ts';
import type { Document } from '../../src/scene/schema.ts';

/** A document of the parts that matter; everything else has its default. */
export function scene(parts: Record<string, unknown>): Document {
  return parseDocument({ format: 'irradia', version: 1, name: 'test', ...parts }, 'test');
}

/** Light of radiance 1 from everywhere, which the camera sees, too. */
export const evenLight = {
  environment: { source: { type: 'constant', color: [1, 1, 1] } },
  background: { type: 'environment', blur: 0 },
};

export const material = (model: string, parameters: object = {}, more: object = {}) => ({
  name: model,
  model,
  parameters,
  ...more,
});

/** A square in the plane z = 0 that faces +z, far larger than what a narrow camera sees. */
export const wall = (more: object = {}) => ({
  name: 'wall',
  material: 'm',
  geometry: { type: 'plane', width: 2, height: 2 },
  ...more,
});

/** A camera that sees the origin alone, from a direction with this cosine to +z, in the plane of x and z. */
export const narrowCamera = (cosine: number) => ({
  fov: 1,
  position: [10 * Math.sqrt(1 - cosine * cosine), 0, 10 * cosine],
  target: [0, 0, 0],
  near: 0.1,
  far: 100,
});

/** The mean of a picture, RGB. */
export function meanOf(pixels: Float32Array): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (const [i, x] of pixels.entries()) sum[(i % 3) as 0 | 1 | 2] += x / (pixels.length / 3);
  return sum;
}
