import type { EmittedFunction } from './emit.ts';
import { GlslEmitter } from './emit-glsl.ts';
import { WgslEmitter } from './emit-wgsl.ts';
import type { FunctionIR } from './ir.ts';
import type { Model } from './model.ts';

export type ShadingLanguage = 'wgsl' | 'glsl';

const prefixes = new WeakMap<Model, string>();
let dataModels = 0;

/**
 * What starts every global name of a model's shader code: the same for equal sources, so that materials
 * of equal models share pipelines, and different for different ones, so that they can share a shader.
 */
export function shaderPrefix(model: Model): string {
  let prefix = prefixes.get(model);
  if (prefix === undefined) {
    const lines = [...model.file.shader.lines, ...(model.file.sampling?.lines ?? [])].map(
      (line) => line.text,
    );
    const table = model.parameters.map(({ type, name }) => `${type} ${name}`);
    // Measured data is in no text: such models share nothing.
    const data = model.data ? `d${dataModels++}` : '';
    prefix = textPrefix([...table, ...lines].join('\n')) + data;
    prefixes.set(model, prefix);
  }
  return prefix;
}

/** As shaderPrefix(), for functions of this source. */
export function textPrefix(source: string): string {
  return `brdf${fnv1a(source)}`;
}

/** One function as text; what it calls is not included. @param prefix starts its global names */
export function emitFunction(prefix: string, f: FunctionIR, language: ShadingLanguage): EmittedFunction {
  return (language === 'wgsl' ? new WgslEmitter(f, prefix) : new GlslEmitter(f, prefix)).emit();
}

/** Fowler, Noll and Vo's hash, 1a, twice 32 bits: names need to differ, not to be secret. */
function fnv1a(text: string): string {
  const hash = (seed: number) => {
    let h = seed;
    for (let i = 0; i < text.length; i++) h = Math.imul(h ^ text.charCodeAt(i), 0x01000193);
    return (h >>> 0).toString(36);
  };
  return hash(0x811c9dc5) + hash(0x1b873593);
}
