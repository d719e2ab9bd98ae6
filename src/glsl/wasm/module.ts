import { TYPE_CODES, unsigned, type WasmType } from './opcodes.ts';

/** The binary format of a module (WebAssembly 2.0, section 5.5). */

export interface Signature {
  readonly arguments: readonly WasmType[];
  readonly results: readonly WasmType[];
}
export interface WasmFunction extends Signature {
  /** For profilers and the stacks of errors. */
  readonly name: string;
  readonly locals: readonly WasmType[];
  /** Its instructions; a negative number -k is the function with symbol k - 1. */
  readonly bytes: readonly number[];
}
export interface WasmModule {
  readonly memory: { readonly shared: boolean; readonly maximum: number };
  /** Immutable i32 globals from the host, the first ones. */
  readonly importedGlobals: readonly string[];
  /** Functions from the host: module, name and symbol. */
  readonly importedFunctions: readonly (Signature & { module: string; name: string; symbol: number })[];
  readonly functions: ReadonlyMap<number, WasmFunction>;
  /** Mutable globals, 0 at first, after the imported ones. */
  readonly globals: readonly WasmType[];
  /** Function symbols by name. */
  readonly exports: ReadonlyMap<string, number>;
  /** The symbol of the function that runs at first. */
  readonly start: number;
  /** What the start function copies into memory: the one passive data segment. */
  readonly data: readonly number[];
}

const FUNCTION_TYPE = 0x60;
/** The part of the custom section `name`. */
const FUNCTION_NAMES = 1;
const ZERO: Record<WasmType, readonly number[]> = {
  i32: [0x41, 0],
  f32: [0x43, 0, 0, 0, 0],
  f64: [0x44, 0, 0, 0, 0, 0, 0, 0, 0],
  v128: [0xfd, 0x0c, ...new Array<number>(16).fill(0)],
};
const END = 0x0b;

function section(id: number, content: readonly number[]): number[] {
  return [id, ...unsigned(content.length)].concat(content);
}

function vector(items: readonly (readonly number[])[]): number[] {
  return unsigned(items.length).concat(...items);
}

function text(s: string): number[] {
  const bytes = [...new TextEncoder().encode(s)];
  return [...unsigned(bytes.length), ...bytes];
}

/** A module's bytes. */
export function encodeModule(module: WasmModule): Uint8Array<ArrayBuffer> {
  const signatures = new Map<string, number>();
  const types: number[][] = [];
  const typeIndex = ({ arguments: args, results }: Signature): number => {
    const codes = [args, results].map((list) => vector(list.map((type) => [TYPE_CODES[type]])));
    const bytes = [FUNCTION_TYPE, ...codes.flat()];
    const key = bytes.join();
    const index = signatures.get(key) ?? types.push(bytes) - 1;
    signatures.set(key, index);
    return index;
  };
  const { memory, importedFunctions, functions } = module;
  const symbols = [...importedFunctions.map(({ symbol }) => symbol), ...functions.keys()];
  const indices = new Map(symbols.map((symbol, i) => [symbol, i] as const));
  const indexOf = (symbol: number) => unsigned(indices.get(symbol) as number);

  const imports = [
    [...text('env'), ...text('memory'), 2, memory.shared ? 3 : 1, 1, ...unsigned(memory.maximum)],
    ...module.importedGlobals.map((name) => [...text('env'), ...text(name), 3, TYPE_CODES.i32, 0]),
    ...importedFunctions.map((f) => [...text(f.module), ...text(f.name), 0, ...unsigned(typeIndex(f))]),
  ];
  const declared = [...functions.values()].map((f) => unsigned(typeIndex(f)));
  const globals = module.globals.map((type) => [TYPE_CODES[type], 1, ...ZERO[type], END]);
  const exported = [...module.exports].map(([name, symbol]) => [...text(name), 0, ...indexOf(symbol)]);
  const code = [...functions.values()].map(({ locals, bytes }) => {
    const resolved = bytes.flatMap((byte) => (byte < 0 ? indexOf(-1 - byte) : byte));
    const content = vector(runs(locals)).concat(resolved);
    return unsigned(content.length).concat(content);
  });
  const names = [...functions].map(([symbol, { name }]) => [...indexOf(symbol), ...text(name)]);
  return new Uint8Array(
    [0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0].concat(
      section(1, vector(types)),
      section(2, vector(imports)),
      section(3, vector(declared)),
      section(6, vector(globals)),
      section(7, vector(exported)),
      section(8, indexOf(module.start)),
      section(12, unsigned(1)),
      section(10, vector(code)),
      section(11, vector([[1, ...unsigned(module.data.length), ...module.data]])),
      section(0, [...text('name'), ...section(FUNCTION_NAMES, vector(names))]),
    ),
  );
}

/** Locals as runs of one type: how many, and of which type. */
function runs(locals: readonly WasmType[]): number[][] {
  const found: { type: WasmType; count: number }[] = [];
  for (const type of locals) {
    const last = found.at(-1);
    if (last?.type === type) last.count++;
    else found.push({ type, count: 1 });
  }
  return found.map(({ type, count }) => [...unsigned(count), TYPE_CODES[type]]);
}
