import { materialReference } from 'three/tsl';
import type { Node } from 'three/webgpu';
import type { Model } from '../glsl/model.ts';
import { modelFunctionByLight, type ParameterNodes, type PdfCall, type SamplerCall } from '../glsl/tsl.ts';
import { genericSampler } from './generic-sampler.ts';
import { run } from './statements.ts';

type Vec3 = Node<'vec3'>;

/** Directions drawn about as the model reflects, and their density in 1/sr; many at one point. */
export interface Sampler {
  /** To be put on the stack before the first sample: computes what all samples of one view have in common. */
  start(V: Vec3, N: Vec3, X: Vec3, Y: Vec3): void;
  readonly sampleL: SamplerCall;
  readonly pdf: PdfCall;
}

/** The model's own sampler, or the generic one, whose width the material keeps in `highlightAlpha`. */
export function createSampler(model: Model, parameters: ParameterNodes): Sampler {
  if (model.hasSampling) return samplerOf(model, parameters);
  const alpha = materialReference('highlightAlpha', 'float') as unknown as Node<'float'>;
  return samplerOf(genericSampler, { alpha });
}

function samplerOf(model: Model, parameters: ParameterNodes): Sampler {
  // As the BRDF is split by its light, so is a sampler by its first argument: u of sampleL(), L of pdf().
  const sampleL = modelFunctionByLight(model, 'sampleL', parameters, null);
  const pdf = modelFunctionByLight(model, 'pdf', parameters, null);
  return {
    start: (V, N, X, Y) => {
      for (const { perView } of [sampleL, pdf]) run(perView(V, N, X, Y));
    },
    sampleL: sampleL.perLight as unknown as SamplerCall,
    pdf: pdf.perLight as unknown as PdfCall,
  };
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
