/** A lit sphere of a model as a picture, without a renderer. */
import type { ParameterValues } from '../../brdf/model.ts';
import type { Model } from '../../glsl/model.ts';
import { Pace } from '../pace.ts';
import { quickEvaluation } from './evaluate.ts';
import { createLook, lookPixels } from './look.ts';

/** RGBA, sRGB, rows from the top; clear beside the sphere. */
export async function spherePicture(
  model: Model,
  parameters: ParameterValues,
  size: number,
): Promise<Uint8ClampedArray<ArrayBuffer>> {
  const look = createLook(size);
  const [values] = await quickEvaluation(model, new Pace())([parameters], look.pairs);
  return lookPixels(look, look.shade(values as Float64Array));
}
