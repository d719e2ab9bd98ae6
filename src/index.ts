/**
 * What `import ... from 'irradia'` offers: materials from BRDF files, lights, and the models' evaluation on
 * the CPU. Rendering is three.js's WebGPURenderer, on WebGPU or WebGL 2.
 */
export { loadModel, shippedModels } from '../models/index.ts';
export { type Fit, type FitOptions, type FitTarget, fitModel } from './analysis/fit/fit.ts';
export {
  type Check,
  checkModel,
  type GpuEvaluation,
  type Outcome,
  type Property,
  type Verdict,
  type VerdictOptions,
  type WorstCase,
} from './analysis/verdict/verdict.ts';
export { BrdfError, BrdfParameterError } from './brdf/error.ts';
export type {
  BoolParameter,
  BrdfFile,
  ColorParameter,
  FloatParameter,
  Parameter,
  ParameterValue,
  ParameterValues,
  Rgb,
} from './brdf/model.ts';
export { parseBrdf } from './brdf/parse.ts';
export { createEvaluator, type Evaluator, type Frame, LOCAL_FRAME, type Vector3 } from './glsl/evaluator.ts';
export { compileModel, type Model } from './glsl/model.ts';
export { modelFunction, modelPdf, modelSampler, type ParameterNodes } from './glsl/tsl.ts';
export type { Falloff } from './lights/falloff.ts';
export { LampLighting } from './lights/many-lamps.ts';
export { BrdfPointLight } from './lights/point-light.ts';
export { BrdfRectLight } from './lights/rect-light.ts';
export { BrdfSpotLight } from './lights/spot-light.ts';
export * from './lights/units.ts';
export { BrdfMaterial } from './material/brdf-material.ts';
export * from './material/named.generated.ts';
export type { Channel } from './material/parameter-nodes.ts';
export { loadMeasured } from './scene/measured.ts';
