/** The path tracer's kernel for the models of one scene, as a program that a back end writes out. */
import type { SourceText, Transmission } from '../brdf/model.ts';
import { compileKernel, type Kernel, kernelSource } from '../glsl/kernel.ts';
import type { Model } from '../glsl/model.ts';
import air from '../lights/air.glsl?raw';
import camera from './kernel/camera.glsl?raw';
import constants from './kernel/constants.glsl?raw';
import distribution from './kernel/distribution.glsl?raw';
import genericSampler from './kernel/generic-sampler.glsl?raw';
import genericSurface from './kernel/generic-surface.glsl?raw';
import genericTable from './kernel/generic-table.glsl?raw';
import ground from './kernel/ground.glsl?raw';
import integrator from './kernel/integrator.glsl?raw';
import lightTree from './kernel/light-tree.glsl?raw';
import lights from './kernel/lights.glsl?raw';
import main from './kernel/main.glsl?raw';
import media from './kernel/media.glsl?raw';
import modelPrototypes from './kernel/models.glsl?raw';
import random from './kernel/random.glsl?raw';
import sky from './kernel/sky.glsl?raw';
import surface from './kernel/surface.glsl?raw';
import textures from './kernel/texture.glsl?raw';
import traverse from './kernel/traverse.glsl?raw';

/** Each file calls only what stands before it. */
const parts: readonly (readonly [name: string, text: string])[] = [
  ['constants.glsl', constants],
  ['random.glsl', random],
  ['models.glsl', modelPrototypes],
  ['texture.glsl', textures],
  ['traverse.glsl', traverse],
  ['surface.glsl', surface],
  ['distribution.glsl', distribution],
  ['generic-sampler.glsl', genericSampler],
  ['generic-surface.glsl', genericSurface],
  ['sky.glsl', sky],
  ['light-tree.glsl', lightTree],
  ['lights.glsl', lights],
  ['ground.glsl', ground],
  ['air.glsl', air],
  ['media.glsl', media],
  ['integrator.glsl', integrator],
  ['camera.glsl', camera],
  ['main.glsl', main],
];

/** The part of them that the tabulation of the generic sampler needs. */
const tableParts: typeof parts = [
  ['constants.glsl', constants],
  ['models.glsl', modelPrototypes],
  ['distribution.glsl', distribution],
  ['generic-sampler.glsl', genericSampler],
  ['generic-table.glsl', genericTable],
];

/**
 * @param models in the order of the numbers that the scene's materials have for them
 * @returns with the entries `renderPixel(int pixel, int film, uint first, uint count)` and
 *   `renderPixels(int from, int to, uint first, uint count)`
 */
export function pathTracerKernel(models: readonly Model[]): Kernel {
  const functions = [modelFunctions(models), samplerFunctions(models)].join('');
  return compileKernel(kernelOf(models, parts, functions), models);
}

/**
 * @returns with the entries `setMaterial(int slot, int count)` and `tabulateView(...)` of kernel/generic-table.glsl, and
 *   `genericSample()` and `genericPdf()` of kernel/generic-sampler.glsl
 */
export function genericTableKernel(model: Model): Kernel {
  return compileKernel(kernelOf([model], tableParts, modelFunctions([model])), [model]);
}

function kernelOf(models: readonly Model[], files: typeof parts, functions: string): SourceText {
  const most = Math.max(1, ...models.map(({ parameters }) => parameters.length));
  const texts = [['models', `const int MAX_PARAMETERS = ${most};`], ...files, ['models', functions]] as const;
  return { lines: texts.flatMap(([name, text]) => kernelSource(name, text).lines) };
}

const FRAME = 'surfaceV, surfaceN, surfaceX, surfaceY';

function eachModel(models: readonly Model[], write: (model: Model, index: number) => string): string {
  return models.map((model, i) => `if (model == ${i}u) { ${write(model, i)} }`).join('\n  else ');
}

/** The functions of kernel/models.glsl that sample. */
function samplerFunctions(models: readonly Model[]): string {
  return `
vec3 modelSample(uint model, vec2 u) {
  ${eachModel(models, ({ hasSampling }, i) =>
    hasSampling ? `return model${i}_sampleL(u, ${FRAME});` : 'return sampleGenerically(model, u);',
  )}
  return vec3(0.0);
}
float modelPdf(uint model, vec3 L) {
  ${eachModel(models, ({ hasSampling }, i) =>
    hasSampling ? `return model${i}_pdf(L, ${FRAME});` : 'return genericDensity(model, L);',
  )}
  return 0.0;
}
`;
}

/** The other functions of kernel/models.glsl. */
function modelFunctions(models: readonly Model[]): string {
  const through = (write: (transmission: Transmission, name: (parameter: string) => string) => string) =>
    models
      .flatMap(({ file: { transmission } }, i) =>
        transmission ? `if (model == ${i}u) { ${write(transmission, (name) => `model${i}_${name}`)} }` : [],
      )
      .join('\n  else ');
  const set = (model: Model, i: number) =>
    model.parameters
      .map(({ name, type }, k) => {
        const value = `surfaceParameters[${k}]`;
        const converted = type === 'color' ? value : type === 'bool' ? `${value}.x > 0.5` : `${value}.x`;
        return `model${i}_${name} = ${converted};`;
      })
      .join('\n    ');
  return `
void setParameters(uint model) {
  ${eachModel(models, set)}
}
vec3 modelBRDF(uint model, vec3 L) {
  ${eachModel(models, (_, i) => `return model${i}_BRDF(L, ${FRAME});`)}
  return vec3(0.0);
}
float modelIor(uint model) {
  ${through(({ ior }, name) => `return ${name(ior)};`)}
  return 1.0;
}
void setModelIor(uint model, float ior) {
  ${through(({ ior }, name) => `${name(ior)} = ior;`)}
}
bool modelIsThin(uint model) {
  ${through(({ thin }, name) => `return ${thin ? name(thin) : 'false'};`)}
  return false;
}
// What light loses on its way through, in 1/m (TransmissionMedium in src/brdf/model.ts); black is as dark as 1e-6.
vec3 modelExtinction(uint model) {
  ${through(({ medium }, name) =>
    medium
      ? `return ${name(medium.depth)} > 0.0
        ? -log(clamp(${name(medium.color)}, vec3(1e-6), vec3(1.0))) / ${name(medium.depth)} : vec3(0.0);`
      : 'return vec3(0.0);',
  )}
  return vec3(0.0);
}
vec3 modelScattering(uint model) {
  ${through(({ medium }, name) =>
    medium?.scatter
      ? `return ${name(medium.depth)} > 0.0 ? max(${name(medium.scatter)}, vec3(0.0)) / ${name(medium.depth)} : vec3(0.0);`
      : 'return vec3(0.0);',
  )}
  return vec3(0.0);
}
float modelAnisotropy(uint model) {
  ${through(({ medium }, name) => `return ${medium?.anisotropy ? `clamp(${name(medium.anisotropy)}, -0.99, 0.99)` : '0.0'};`)}
  return 0.0;
}
`;
}
