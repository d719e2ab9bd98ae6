import type { FunctionIR, Variable } from './ir.ts';
import type { StructType } from './types.ts';

/** What a name means at one place of the program. */
export class Scope {
  readonly functions: Map<string, FunctionIR[]>;
  readonly structs: Map<string, StructType>;
  /** What fetchData() reads; null if the model has no measured data. */
  readonly table: Variable | null;
  /** Whether this is a kernel, which may read memory (kernel.ts). */
  readonly isKernel: boolean;
  /** Parameters read and functions called so far by the function that is being checked. */
  readonly used: Set<Variable>;
  readonly calls: Set<FunctionIR>;
  private readonly names = new Map<string, Variable | FunctionIR>();
  private readonly parent: Scope | null;

  private constructor(
    parent: Scope | null,
    shared: Pick<Scope, 'functions' | 'structs' | 'table' | 'isKernel' | 'used' | 'calls'>,
  ) {
    this.parent = parent;
    this.functions = shared.functions;
    this.structs = shared.structs;
    this.table = shared.table;
    this.isKernel = shared.isKernel;
    this.used = shared.used;
    this.calls = shared.calls;
  }

  static global(table: Variable | null, isKernel: boolean): Scope {
    return new Scope(null, {
      functions: new Map(),
      structs: new Map(),
      table,
      isKernel,
      used: new Set(),
      calls: new Set(),
    });
  }

  /** The scope of a function's body: what it reads and calls is collected afresh. */
  enterFunction(): Scope {
    return new Scope(this, {
      functions: this.functions,
      structs: this.structs,
      table: this.table,
      isKernel: this.isKernel,
      used: new Set(),
      calls: new Set(),
    });
  }

  enterBlock(): Scope {
    return new Scope(this, this);
  }

  /** Declares a name here; false if this very scope has it already. */
  declare(name: string, meaning: Variable | FunctionIR): boolean {
    if (this.names.has(name)) return false;
    this.names.set(name, meaning);
    return true;
  }

  /** A variable, or the function that computes a global from the parameters. */
  lookup(name: string): Variable | FunctionIR | undefined {
    return this.names.get(name) ?? this.parent?.lookup(name);
  }

  called(callee: FunctionIR): FunctionIR {
    this.calls.add(callee);
    return callee;
  }
}
