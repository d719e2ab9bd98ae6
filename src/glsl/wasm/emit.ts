import type { FunctionIR } from '../ir.ts';
import { encodeModule } from './module.ts';
import { Unit } from './unit.ts';

/** The most that a 32 bit module can address: 4 GiB. */
const MAX_PAGES = 65536;

export interface WasmOptions {
  /** Whether the memory is shared between workers; true unless said otherwise. */
  readonly shared?: boolean;
}

/**
 * A WebAssembly module of these functions and all that they call, each exported under its GLSL name.
 *
 * A function takes its in and inout arguments, then the model parameters that it reads, component by component
 * (a vec4 as one v128), and gives its value, then its out and inout arguments. Variables of the invocation are
 * 0 when the module is instantiated and keep their values between calls. The module imports from `env` its
 * memory and the addresses, in bytes, of the scene, of the film and of the end of its stack, which grows down
 * from there (multiples of 16); instantiate.ts provides them.
 *
 * @throws RangeError if two entries have one name
 */
export function emitWasm(entries: readonly FunctionIR[], options: WasmOptions = {}): Uint8Array<ArrayBuffer> {
  const unit = new Unit(entries);
  const exports = new Map<string, number>();
  for (const f of entries) {
    if (exports.has(f.name)) throw new RangeError(`two functions to be exported are named ${f.name}`);
    exports.set(f.name, unit.symbol(f));
  }
  return encodeModule(unit.module(exports, { shared: options.shared ?? true, maximum: MAX_PAGES }));
}
