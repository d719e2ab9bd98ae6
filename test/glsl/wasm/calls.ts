import type { ParameterValues } from '../../../src/brdf/model.ts';
import type { FunctionIR } from '../../../src/glsl/ir.ts';
import { findFunction, type Model } from '../../../src/glsl/model.ts';
import { TABLE } from '../../../src/glsl/types.ts';
import { emitWasm } from '../../../src/glsl/wasm/emit.ts';
import { instantiateWasm, type WasmExports } from '../../../src/glsl/wasm/instantiate.ts';

/** Bytes of the stack, after which the data lie. */
const STACK = 1 << 16;

/** Exports of a module of these functions, with these words as the scene and room for a film of 16 slots. */
export function instantiate(
  entries: readonly FunctionIR[],
  scene: Float32Array | Uint32Array = new Float32Array(0),
): { exports: WasmExports; film: Float32Array } {
  const bytes = emitWasm(entries, { shared: false });
  const film = STACK + 16 * Math.ceil(scene.byteLength / 16);
  const pages = Math.ceil((film + 256) / 65536);
  const memory = new WebAssembly.Memory({ initial: pages, maximum: 65536 });
  new Uint8Array(memory.buffer, STACK).set(new Uint8Array(scene.buffer, scene.byteOffset, scene.byteLength));
  const { exports } = instantiateWasm(bytes, { memory, scene: STACK, film, stack: STACK });
  return { exports, film: new Float32Array(memory.buffer, film, 64) };
}

/** BRDF(), a term, sampleL() or pdf() of a model, with lists of numbers for vectors. */
export function modelCalls(
  model: Model,
  names: readonly string[],
): (name: string, parameters: ParameterValues, ...args: (readonly number[])[]) => readonly number[] {
  const functions = new Map(names.map((name) => [name, findFunction(model, name) as FunctionIR] as const));
  const { exports } = instantiate([...functions.values()], model.data ?? undefined);
  const numbersOf = (name: string, parameters: ParameterValues): readonly number[] =>
    (functions.get(name) as FunctionIR).uses
      .flatMap((variable) =>
        variable.type === TABLE
          ? [0, (model.data as Float32Array).length / 3]
          : [parameters[variable.name]].flat(),
      )
      .map(Number);
  // Of a material there are thousands of calls.
  const known = new WeakMap<ParameterValues, Map<string, readonly number[]>>();
  return (name, parameters, ...args) => {
    const ofParameters = known.get(parameters) ?? new Map<string, readonly number[]>();
    known.set(parameters, ofParameters);
    const values = ofParameters.get(name) ?? numbersOf(name, parameters);
    ofParameters.set(name, values);
    const result = exports[name]?.(...args.flat(), ...values);
    return Array.isArray(result) ? result : [result as number];
  };
}
