/** The generic sampler for tests: as the kernel's WebAssembly, over the table that the packer makes. */

import { loadModel, modelSources } from '../../models/index.ts';
import type { Sampler } from '../../src/analysis/sampler-test.ts';
import type { Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { resolveParameters } from '../../src/brdf/values.ts';
import type { Model } from '../../src/glsl/model.ts';
import { genericTableKernel } from '../../src/pathtracer/kernel.ts';
import { tabulate } from '../../src/pathtracer/scene/generic-table.ts';
import { GENERIC_TABLE, WORDS_PER_SLOT } from '../../src/pathtracer/scene/layout.ts';
import { Pace } from '../../src/pathtracer/scene/pace.ts';
import { instantiate } from '../glsl/wasm/calls.ts';

/** The text of a shipped model without its sampler. */
export function textWithoutSampler(name: string): string {
  const text = modelSources.get(`${name}.brdf`);
  if (text === undefined) throw new RangeError(`no model ${name} ships`);
  return text.replace(/::begin sampling[\s\S]*?::end sampling\n?/, '');
}

const withoutSamplers = new Map<string, Model>();

export function modelWithoutSampler(name: string): Model {
  const model =
    withoutSamplers.get(name) ?? loadModel(textWithoutSampler(name), `${name}-without-sampler.brdf`);
  withoutSamplers.set(name, model);
  return model;
}

/** A material without textures, as its table sees it. */
export function placesWith(values: ParameterValues): readonly ParameterValues[] {
  return Array.from({ length: GENERIC_TABLE.points }, () => values);
}

export interface GenericSampler {
  /** What the analysis calls a sampler. */
  seenFrom(v: Vec3): Sampler;
}

const samplers = new WeakMap<Model, Map<string, Promise<GenericSampler>>>();

/** One for all tests that ask for these parameters: its table takes far longer than their samples. @param model without a sampler */
export function genericSamplerOf(model: Model, parameters: ParameterValues): Promise<GenericSampler> {
  const ofModel = samplers.get(model) ?? new Map<string, Promise<GenericSampler>>();
  samplers.set(model, ofModel);
  const key = JSON.stringify(parameters);
  const sampler = ofModel.get(key) ?? makeSampler(model, parameters);
  ofModel.set(key, sampler);
  return sampler;
}

async function makeSampler(model: Model, parameters: ParameterValues): Promise<GenericSampler> {
  const values = resolveParameters(model.file, parameters);
  const pace = new Pace();
  const table = await tabulate({ model, places: placesWith(values), isTextured: false }, pace);
  pace.end();
  return samplerOfTable(model, table, values);
}

const kernels = new WeakMap<Model, ReturnType<typeof genericTableKernel>>();

export function samplerOfTable(
  model: Model,
  table: Uint32Array<ArrayBuffer>,
  values: ParameterValues,
): GenericSampler {
  const kernel = kernels.get(model) ?? genericTableKernel(model);
  kernels.set(model, kernel);
  // A table's slot is never 0.
  const scene = new Uint32Array(WORDS_PER_SLOT + table.length);
  scene.set(table, WORDS_PER_SLOT);
  const { exports } = instantiate([kernel.entry('genericSample'), kernel.entry('genericPdf')], scene);
  const { transmission } = model.file;
  const ior = transmission ? Number(values[transmission.ior]) : 1;
  const isThin = Number(transmission?.thin ? values[transmission.thin] : false);
  return {
    seenFrom: (v) => ({
      sample(u) {
        const l = exports.genericSample?.(1, ...u, ...v, ior, isThin) as readonly number[] as Vec3;
        return l[0] === 0 && l[1] === 0 && l[2] === 0 ? null : l;
      },
      pdf: (l) => exports.genericPdf?.(1, ...l, ...v, ior, isThin) as number,
    }),
  };
}
