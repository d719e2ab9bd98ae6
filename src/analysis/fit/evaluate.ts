/** The values of a model for several sets of parameters at many pairs of directions. */
import type { ParameterValue, ParameterValues } from '../../brdf/model.ts';
import { createEvaluator, LOCAL_FRAME } from '../../glsl/evaluator.ts';
import type { FunctionIR, Variable } from '../../glsl/ir.ts';
import { findFunction, type Model } from '../../glsl/model.ts';
import { TABLE } from '../../glsl/types.ts';
import { emitWasm } from '../../glsl/wasm/emit.ts';
import { instantiateWasm } from '../../glsl/wasm/instantiate.ts';
import type { Pace } from '../pace.ts';
import type { Pair } from './samples.ts';

/**
 * For each set f (n.l) of each pair in turn, red, green, blue; in 1/sr. What is negative or no number counts
 * as 0: no metric could compare it.
 */
export type EvaluateSets = (
  sets: readonly ParameterValues[],
  pairs: readonly Pair[],
) => Promise<Float64Array[]>;

const reflected = (f: number, cosine: number) => (f > 0 && f < Number.POSITIVE_INFINITY ? f * cosine : 0);

/** In float64. */
export function exactEvaluation(model: Model, pace: Pace): EvaluateSets {
  const evaluator = createEvaluator(model);
  return async (sets, pairs) => {
    const results: Float64Array[] = [];
    for (const set of sets) {
      const values = new Float64Array(3 * pairs.length);
      evaluator.set(set);
      for (const [i, { l, v }] of pairs.entries()) {
        if (i % 128 === 127) await pace.rest();
        const f = evaluator.f(l, v);
        for (let c = 0; c < 3; c++) values[3 * i + c] = reflected(f[c] as number, l[2]);
      }
      results.push(values);
    }
    return results;
  };
}

/** Bytes of the module's stack, after which the data of a measured model lie. */
const STACK = 1 << 16;
const PAGE = 1 << 16;
/** What emitWasm() declares: 4 GiB, of which only what is needed is taken. */
const MAX_PAGES = 65536;

/** In float32, as WebAssembly: some forty times as fast. */
export function quickEvaluation(model: Model, pace: Pace): EvaluateSets {
  const brdf = findFunction(model, 'BRDF') as FunctionIR;
  const data = model.data ?? new Float32Array(0);
  const film = STACK + 16 * Math.ceil(data.byteLength / 16);
  const memory = new WebAssembly.Memory({ initial: Math.ceil(film / PAGE) + 1, maximum: MAX_PAGES });
  new Float32Array(memory.buffer, STACK, data.length).set(data);
  const module = emitWasm([brdf], { shared: false });
  const { exports } = instantiateWasm(module, { memory, scene: STACK, film, stack: STACK });
  const f = exports.BRDF as (...args: number[]) => readonly number[];
  const { N, X, Y } = LOCAL_FRAME;
  return async (sets, pairs) => {
    const results: Float64Array[] = [];
    for (const set of sets) {
      const values = new Float64Array(3 * pairs.length);
      const rest = [...N, ...X, ...Y, ...brdf.uses.flatMap((variable) => wordsOf(variable, set, data))];
      for (const [i, { l, v }] of pairs.entries()) {
        if (i % 1024 === 1023) await pace.rest();
        const rgb = f(l[0], l[1], l[2], v[0], v[1], v[2], ...rest);
        for (let c = 0; c < 3; c++) values[3 * i + c] = reflected(rgb[c] as number, l[2]);
      }
      await pace.rest();
      results.push(values);
    }
    return results;
  };
}

/** A parameter as the module takes it; a table is where it starts and how many triples it has. */
function wordsOf({ name, type }: Variable, set: ParameterValues, data: Float32Array): number[] {
  if (type === TABLE) return [0, data.length / 3];
  return [set[name] as ParameterValue].flat().map(Number);
}
