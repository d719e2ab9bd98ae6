import { materialReference } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Model } from '../glsl/model.ts';
import { modelPdf, modelSampler, type ParameterNodes, type PdfCall, type SamplerCall } from '../glsl/tsl.ts';
import { genericSampler } from './generic-sampler.ts';

/** Directions drawn about as the model reflects, and their density in 1/sr. */
export interface Sampler {
  readonly sampleL: SamplerCall;
  readonly pdf: PdfCall;
}

/** The model's own sampler, or the generic one, whose width the material keeps in `highlightAlpha`. */
export function createSampler(model: Model, parameters: ParameterNodes): Sampler {
  if (model.hasSampling)
    return { sampleL: modelSampler(model, parameters), pdf: modelPdf(model, parameters) };
  const alpha = materialReference('highlightAlpha', 'float') as unknown as Node<'float'>;
  return { sampleL: modelSampler(genericSampler, { alpha }), pdf: modelPdf(genericSampler, { alpha }) };
}

/** The i-th of n points that fill the unit square evenly: a Fibonacci lattice. */
export function latticePoint(
  i: Node<'float'>,
  n: number | Node<'float'>,
): { x: Node<'float'>; y: Node<'float'> } {
  const shifted = i.add(0.5);
  return { x: shifted.div(n), y: shifted.mul(GOLDEN_FRACTION).fract() };
}

/** (sqrt(5) - 1) / 2. */
const GOLDEN_FRACTION = 0.6180339887498949;
