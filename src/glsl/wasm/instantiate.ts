/** What a module of emitWasm() is given: byte addresses in its memory, multiples of 16. */
export interface WasmEnvironment {
  readonly memory: WebAssembly.Memory;
  readonly scene: number;
  readonly film: number;
  /** The end of the stack, which grows down from here. */
  readonly stack: number;
}

export type WasmExports = Readonly<
  Record<string, (...args: number[]) => number | readonly number[] | undefined>
>;

/** Instantiates a module of emitWasm(): in Node, a page or a worker. */
export function instantiateWasm(
  module: BufferSource | WebAssembly.Module,
  environment: WasmEnvironment,
): { readonly exports: WasmExports } {
  const compiled = module instanceof WebAssembly.Module ? module : new WebAssembly.Module(module);
  const { exports } = new WebAssembly.Instance(compiled, {
    env: { ...environment },
    m: { ...functionsOfMath() },
  });
  return { exports: exports as WasmExports };
}

function functionsOfMath(): Record<string, WebAssembly.ImportValue> {
  return Object.fromEntries(
    Object.getOwnPropertyNames(Math).map((name) => [name, Math[name as 'sin'] as WebAssembly.ImportValue]),
  );
}
