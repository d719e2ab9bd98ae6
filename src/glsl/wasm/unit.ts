import type { FunctionIR, Value, Variable } from '../ir.ts';
import { constantBytes, globalGet } from './code.ts';
import { addressedVariables, isLarge, weightOf } from './effects.ts';
import { argumentCells, FunctionWriter, resultCells } from './function.ts';
import { cellsOf, constantCells, zeroCells } from './layout.ts';
import type { WasmFunction, WasmModule } from './module.ts';
import {
  END,
  GLOBAL_GET,
  GLOBAL_SET,
  I32_CONST,
  LOCAL_GET,
  LOCAL_SET,
  MEMORY_INIT,
  opcode,
  signed,
  unsigned,
  type WasmType,
} from './opcodes.ts';
import type { Place } from './places.ts';

/**
 * Functions of at most this many nodes, with all that they call, stand in the place of their calls: V8 inlines
 * none. The path tracer's speed on two scenes, for 0, 100, 200, 400 and 1000: 100 %, 113 and 120 %, 109 and
 * 126 %, 114 and 134 %, 107 and 128 %.
 */
const MAX_INLINED = 400;

const ALIGNMENT = 16;
const FIXED_GLOBALS = 5;

/** What the functions of one module share: its functions, imports, globals and data. */
export class Unit {
  /** Globals: where the scene and the film start, the end of the stack, and where the data start. */
  readonly scene = 0;
  readonly film = 1;
  private readonly top = 2;
  readonly stack = 3;
  private readonly dataStart = 4;
  /** Of the variables, after the fixed ones. */
  private readonly globals: WasmType[] = [];

  private readonly symbols = new Map<FunctionIR | string, number>();
  private readonly functions = new Map<number, WasmFunction>();
  private readonly imports: { module: string; name: string; symbol: number }[] = [];
  private readonly places = new Map<Variable, Place>();
  private readonly addressed = new Set<Variable>();
  private readonly data: number[] = [];

  constructor(entries: readonly FunctionIR[]) {
    for (const f of reachable(entries))
      for (const variable of addressedVariables(f)) this.addressed.add(variable);
  }

  /** The number that stands for a function until all are known; it is written at the first call. */
  symbol(f: FunctionIR): number {
    let symbol = this.symbols.get(f);
    if (symbol === undefined) {
      symbol = this.symbols.size;
      this.symbols.set(f, symbol);
      const signature = { name: f.name, arguments: argumentCells(f), results: resultCells(f) };
      this.functions.set(symbol, { ...signature, ...new FunctionWriter(this, f).write(f) });
    }
    return symbol;
  }

  /** A function of JavaScript's Math, of one float64. */
  math(name: string): number {
    const key = `Math.${name}`;
    let symbol = this.symbols.get(key);
    if (symbol === undefined) {
      symbol = this.symbols.size;
      this.symbols.set(key, symbol);
      this.imports.push({ module: 'm', name, symbol });
    }
    return symbol;
  }

  inlines(f: FunctionIR): boolean {
    return weightOf(f) <= MAX_INLINED;
  }

  /** Where a variable of the whole invocation is kept, or a constant whose elements are chosen while running. */
  place(variable: Variable): Place | undefined {
    let place = this.places.get(variable);
    if (!place && (variable.role === 'shared' || variable.role === 'constant')) {
      place = this.newPlace(variable);
      this.places.set(variable, place);
    }
    return place;
  }

  private newPlace(variable: Variable): Place {
    const { type } = variable;
    const value = variable.role === 'constant' ? (variable.constant as Value) : null;
    if (value !== null || this.addressed.has(variable) || isLarge(variable)) {
      const offset = this.data.length;
      const codes = value === null ? zeroCells(type) : constantCells(value, type);
      for (const code of codes) this.data.push(...constantBytes(code));
      while (this.data.length % ALIGNMENT !== 0) this.data.push(0);
      return { kind: 'memory', base: globalGet(this.dataStart, 'i32'), offset };
    }
    const refs = cellsOf(type).map((cell) => {
      const index = FIXED_GLOBALS + this.globals.push(cell) - 1;
      return { get: globalGet(index, cell), before: [], after: [GLOBAL_SET, ...unsigned(index)] };
    });
    return { kind: 'cells', refs };
  }

  /** The module, once every entry has its symbol. */
  module(exports: ReadonlyMap<string, number>, memory: WasmModule['memory']): WasmModule {
    const start = this.symbols.size;
    return {
      memory,
      importedGlobals: ['scene', 'film', 'stack'],
      importedFunctions: this.imports.map((f) => ({
        ...f,
        arguments: ['f64'],
        results: ['f64'],
      })),
      functions: new Map([...this.functions, [start, this.start()]]),
      globals: ['i32', 'i32', ...this.globals],
      exports,
      start,
      data: this.data,
    };
  }

  /** Puts the data at the end of the stack's memory, and the stack below them. */
  private start(): WasmFunction {
    const size = [I32_CONST, ...signed(this.data.length)];
    const address = [LOCAL_GET, 0];
    const bytes = [GLOBAL_GET, this.top, ...size, ...opcode('i32.sub'), LOCAL_SET, 0];
    bytes.push(...address, GLOBAL_SET, this.dataStart, ...address, GLOBAL_SET, this.stack);
    bytes.push(...address, I32_CONST, 0, ...size, ...MEMORY_INIT, END);
    return { name: 'start', arguments: [], results: [], locals: ['i32'], bytes };
  }
}

function reachable(entries: readonly FunctionIR[]): ReadonlySet<FunctionIR> {
  const found = new Set(entries);
  for (const f of found) for (const callee of f.calls) found.add(callee);
  return found;
}
