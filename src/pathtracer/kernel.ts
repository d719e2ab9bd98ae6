/** The path tracer's kernel for the models of one scene, as a program that a back end writes out. */
import type { SourceText, Transmission } from '../brdf/model.ts';
import { compileKernel, type Kernel, kernelSource } from '../glsl/kernel.ts';
import type { Model } from '../glsl/model.ts';
import { genericSampler } from '../material/generic-sampler.ts';
import camera from './kernel/camera.glsl?raw';
import constants from './kernel/constants.glsl?raw';
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
  ['sky.glsl', sky],
  ['light-tree.glsl', lightTree],
  ['lights.glsl', lights],
  ['media.glsl', media],
  ['integrator.glsl', integrator],
  ['camera.glsl', camera],
  ['main.glsl', main],
];

/**
 * @param models in the order of the numbers that the scene's materials have for them
 * @returns with the entries `renderPixel(int pixel, int film, uint first, uint count)` and
 *   `renderPixels(int from, int to, uint first, uint count)`
 */
export function pathTracerKernel(models: readonly Model[]): Kernel {
  const source: SourceText = {
    lines: [
      ...kernelSource('models', `const int MAX_PARAMETERS = ${Math.max(1, ...models.map(parameterSlots))};`)
        .lines,
      ...parts.flatMap(([name, text]) => kernelSource(name, text).lines),
      ...kernelSource('models', modelFunctions(models)).lines,
    ],
  };
  return compileKernel(source, [...models, genericSampler]);
}

/**
 * How many slots of parameters a material of this model has: one for each, and one for the width of the generic
 * sampler's highlight where the model brings no sampler.
 */
export function parameterSlots(model: Model): number {
  return model.parameters.length + (model.hasSampling ? 0 : 1);
}

const FRAME = 'surfaceV, surfaceN, surfaceX, surfaceY';

/** The functions of kernel/models.glsl. */
function modelFunctions(models: readonly Model[]): string {
  const generic = models.length;
  const each = (write: (model: Model, index: number) => string) =>
    models.map((model, i) => `if (model == ${i}u) { ${write(model, i)} }`).join('\n  else ');
  const through = (write: (transmission: Transmission, name: (parameter: string) => string) => string) =>
    models
      .flatMap(({ file: { transmission } }, i) =>
        transmission ? `if (model == ${i}u) { ${write(transmission, (name) => `model${i}_${name}`)} }` : [],
      )
      .join('\n  else ');
  const sampler = (model: Model, i: number) => `model${model.hasSampling ? i : generic}`;
  const set = (model: Model, i: number) => {
    const assignments = model.parameters.map(({ name, type }, k) => {
      const value = `surfaceParameters[${k}]`;
      const converted = type === 'color' ? value : type === 'bool' ? `${value}.x > 0.5` : `${value}.x`;
      return `model${i}_${name} = ${converted};`;
    });
    if (!model.hasSampling)
      assignments.push(`model${generic}_alpha = surfaceParameters[${model.parameters.length}].x;`);
    return assignments.join('\n    ');
  };
  return `
void setParameters(uint model) {
  ${each(set)}
}
vec3 modelBRDF(uint model, vec3 L) {
  ${each((_, i) => `return model${i}_BRDF(L, ${FRAME});`)}
  return vec3(0.0);
}
vec3 modelSample(uint model, vec2 u) {
  ${each((model, i) => `return ${sampler(model, i)}_sampleL(u, ${FRAME});`)}
  return vec3(0.0);
}
float modelPdf(uint model, vec3 L) {
  ${each((model, i) => `return ${sampler(model, i)}_pdf(L, ${FRAME});`)}
  return 0.0;
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
