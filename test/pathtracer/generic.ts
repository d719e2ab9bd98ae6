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

export function modelWithoutSampler(name: string): Model {
  return loadModel(textWithoutSampler(name), `${name}-without-sampler.brdf`);
}

/** A material without textures, as its table sees it. */
export function placesWith(values: ParameterValues): readonly ParameterValues[] {
  return Array.from({ length: GENERIC_TABLE.points }, () => values);
}

export interface GenericSampler {
  /** What the analysis calls a sampler. */
  seenFrom(v: Vec3): Sampler;
}

/** @param model without a sampler */
export async function genericSamplerOf(model: Model, parameters: ParameterValues): Promise<GenericSampler> {
  const values = resolveParameters(model.file, parameters);
  const pace = new Pace();
  const table = await tabulate({ model, places: placesWith(values), isTextured: false }, pace);
  pace.end();
  return samplerOfTable(model, table, values);
}

export function samplerOfTable(
  model: Model,
  table: Uint32Array<ArrayBuffer>,
  values: ParameterValues,
): GenericSampler {
  const kernel = genericTableKernel(model);
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
