import type { SourcePlace } from '../brdf/error.ts';
import type { Type } from './types.ts';

/**
 * The typed program: every name resolved, every implicit conversion explicit, every overload chosen.
 * The back ends (float64.ts, emit.ts) walk it and never have to guess.
 */

/** Scalars are numbers or booleans; a table of data is its array; vectors and (column by column) matrices, arrays and structs are lists. */
export type Value = number | boolean | Float32Array | readonly Value[];

export interface Variable {
  readonly id: number;
  readonly name: string;
  readonly type: Type;
  /**
   * `parameter` is one of the model's parameters; `constant` has a value known now and is declared nowhere;
   * `argument` and `local` belong to a function; `shared` belongs to the whole shader invocation, 0 at first:
   * what a split function keeps between its parts (hoist.ts), and a kernel's globals (kernel.ts);
   * `derived` is what a split function's caller computes from the parameters.
   */
  readonly role: 'parameter' | 'constant' | 'argument' | 'local' | 'shared' | 'derived';
  /** The value, if the role is `constant`. */
  readonly constant: Value | null;
  /** Set by the checker when anything assigns to it after its declaration. */
  assigned: boolean;
}

interface Typed {
  readonly place: SourcePlace;
  readonly type: Type;
  /** Whether the value is the same in every run: no variable but constants takes part. */
  readonly constant: boolean;
}

export type Expr = Typed &
  (
    | { readonly kind: 'literal'; readonly value: number | boolean }
    | { readonly kind: 'variable'; readonly variable: Variable }
    | { readonly kind: 'unary'; readonly operator: '-' | '!' | '~'; readonly operand: Expr }
    | {
        readonly kind: 'binary';
        readonly operator: BinaryOperator;
        readonly left: Expr;
        readonly right: Expr;
      }
    | { readonly kind: 'ternary'; readonly test: Expr; readonly yes: Expr; readonly no: Expr }
    | { readonly kind: 'call'; readonly callee: FunctionIR; readonly args: readonly Expr[] }
    | { readonly kind: 'builtin'; readonly name: string; readonly args: readonly Expr[] }
    /** Conversion or constructor: vec3(x), float(i), mat2(a, b), float[2](a, b), S(a, b). */
    | { readonly kind: 'construct'; readonly args: readonly Expr[] }
    | { readonly kind: 'swizzle'; readonly object: Expr; readonly components: readonly number[] }
    | { readonly kind: 'index'; readonly object: Expr; readonly index: Expr }
    | { readonly kind: 'field'; readonly object: Expr; readonly field: number }
    /** target = value, or target = target `operator` value; its value is the target's new one. */
    | {
        readonly kind: 'assign';
        readonly operator: ArithmeticOperator | null;
        readonly target: Expr;
        readonly value: Expr;
      }
    | {
        readonly kind: 'step';
        readonly operator: '++' | '--';
        readonly prefix: boolean;
        readonly target: Expr;
      }
    | { readonly kind: 'sequence'; readonly items: readonly Expr[] }
  );

export type ArithmeticOperator = '+' | '-' | '*' | '/' | '%' | '&' | '|' | '^' | '<<' | '>>';
export type BinaryOperator = ArithmeticOperator | '<' | '>' | '<=' | '>=' | '==' | '!=' | '&&' | '||' | '^^';

export type Stmt = { readonly place: SourcePlace } & (
  | { readonly kind: 'declare'; readonly variable: Variable; readonly init: Expr | null }
  | { readonly kind: 'expression'; readonly expression: Expr }
  | { readonly kind: 'block'; readonly body: readonly Stmt[] }
  | { readonly kind: 'if'; readonly test: Expr; readonly yes: Stmt; readonly no: Stmt | null }
  /** `for (variable = first; test; step)`, known to end after `count` turns. */
  | {
      readonly kind: 'for';
      readonly variable: Variable;
      readonly first: Expr;
      readonly test: Expr;
      readonly step: Expr;
      readonly body: Stmt;
      readonly count: number;
    }
  /** `while (test)`: kernels only. */
  | { readonly kind: 'loop'; readonly test: Expr; readonly body: Stmt }
  | { readonly kind: 'return'; readonly value: Expr | null }
  | { readonly kind: 'break' }
  | { readonly kind: 'continue' }
);

export interface ArgumentIR {
  readonly variable: Variable;
  readonly qualifier: 'in' | 'out' | 'inout';
}

export interface FunctionIR {
  readonly id: number;
  readonly name: string;
  readonly place: SourcePlace;
  readonly result: Type;
  readonly arguments: readonly ArgumentIR[];
  /** Filled when the body is checked, which is after every signature is known. */
  body: readonly Stmt[];
  /** Model parameters that it or what it calls reads, in the order of the file's table. */
  uses: readonly Variable[];
  /** What it calls directly. */
  calls: readonly FunctionIR[];
}

export interface Program {
  /** In the order of the file's table; last, if the model has measured data, the variable that stands for it. */
  readonly parameters: readonly Variable[];
  /** Every function with a body, each after those that it calls. */
  readonly functions: readonly FunctionIR[];
}
