/**
 * A model in float32, as WebAssembly: some twenty to forty times as fast as float64, which stays the measure of what is
 * right (docs/decisions/analysis-evaluation.md).
 */
import type { ParameterValue, ParameterValues } from '../brdf/model.ts';
import { resolveParameters } from '../brdf/values.ts';
import { LOCAL_FRAME } from '../glsl/evaluator.ts';
import type { Variable } from '../glsl/ir.ts';
import { findFunction, type Model } from '../glsl/model.ts';
import { TABLE } from '../glsl/types.ts';
import { emitWasm } from '../glsl/wasm/emit.ts';
import { instantiateWasm } from '../glsl/wasm/instantiate.ts';
import type { Reflectance } from './plots/curve.ts';
import type { Vec3 } from './vector.ts';

export interface QuickEvaluator {
  readonly model: Model;
  /** New values; parameters that are not named take their defaults. @throws BrdfParameterError */
  set(values: Readonly<Record<string, unknown>>): void;
  /**
   * The model, or one of its terms, in 1/sr, in the local frame. The same function always: it follows set().
   *
   * @throws RangeError for an unknown term
   */
  term(name: string): Reflectance;
  /** The density of sampleL(), in 1/sr; it follows set(), too. @throws RangeError without a sampling section */
  pdf(): (l: Vec3, v: Vec3) => number;
}

/** Bytes of a module's stack, after which the data of a measured model lie. */
const STACK = 1 << 16;
const PAGE = 1 << 16;
/** What emitWasm() declares: 4 GiB, of which only what is needed is taken. */
const MAX_PAGES = 65536;

const FRAME = [...LOCAL_FRAME.N, ...LOCAL_FRAME.X, ...LOCAL_FRAME.Y];

interface CompiledTerm {
  readonly uses: readonly Variable[];
  readonly call: (...args: number[]) => unknown;
}

/** What all evaluators of a model share: compiling takes milliseconds, the data of measured models are megabytes. */
interface Compiled {
  readonly data: Float32Array;
  term(name: string): CompiledTerm;
}

const compiledModels = new WeakMap<Model, Compiled>();

function compiled(model: Model): Compiled {
  const known = compiledModels.get(model);
  if (known) return known;
  const data = model.data ?? new Float32Array(0);
  const film = STACK + 16 * Math.ceil(data.byteLength / 16);
  const memory = new WebAssembly.Memory({ initial: Math.ceil(film / PAGE) + 1, maximum: MAX_PAGES });
  new Float32Array(memory.buffer, STACK, data.length).set(data);
  const terms = new Map<string, CompiledTerm>();
  const compile = (name: string): CompiledTerm => {
    const known = model.terms.includes(name) || (name === 'pdf' && model.hasSampling);
    const ir = known ? findFunction(model, name) : undefined;
    if (!ir)
      throw new RangeError(`${model.name} has no term ${name}; its terms are ${model.terms.join(', ')}`);
    const module = emitWasm([ir], { shared: false });
    const { exports } = instantiateWasm(module, { memory, scene: STACK, film, stack: STACK });
    return { uses: ir.uses, call: exports[name] as CompiledTerm['call'] };
  };
  const fresh: Compiled = {
    data,
    term(name) {
      const term = terms.get(name) ?? compile(name);
      terms.set(name, term);
      return term;
    },
  };
  compiledModels.set(model, fresh);
  return fresh;
}

/** @throws BrdfParameterError if a value does not suit its parameter */
export function createQuickEvaluator(
  model: Model,
  values: Readonly<Record<string, unknown>> = {},
): QuickEvaluator {
  const { data, term: compiledTerm } = compiled(model);
  let set = resolveParameters(model.file, values);
  const functions = new Map<string, (l: Vec3, v: Vec3) => unknown>();
  const make = (name: string) => {
    const { uses, call } = compiledTerm(name);
    const fill = () => [...FRAME, ...uses.flatMap((variable) => wordsOf(variable, set, data))];
    // What follows l and v.
    let rest = fill();
    let of = set;
    return (l: Vec3, v: Vec3) => {
      if (of !== set) [rest, of] = [fill(), set];
      return call(l[0], l[1], l[2], v[0], v[1], v[2], ...rest);
    };
  };
  const named = (name: string) => {
    const f = functions.get(name) ?? make(name);
    functions.set(name, f);
    return f;
  };
  return {
    model,
    set(next) {
      set = resolveParameters(model.file, next);
    },
    term(name) {
      return named(name) as Reflectance;
    },
    pdf() {
      return named('pdf') as (l: Vec3, v: Vec3) => number;
    },
  };
}

/** A parameter as the module takes it; a table is where it starts and how many triples it has. */
function wordsOf({ name, type }: Variable, set: ParameterValues, data: Float32Array): number[] {
  if (type === TABLE) return [0, data.length / 3];
  return [set[name] as ParameterValue].flat().map(Number);
}
