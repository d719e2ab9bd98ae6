import type { SourcePlace } from '../brdf/error.ts';

/** What the parser yields: GLSL as written, names and types not yet resolved. */

export interface TypeRef {
  readonly place: SourcePlace;
  readonly name: string;
  /** Array dimensions after the type's name; null is `[]`, whose length the initialiser gives. */
  readonly lengths: readonly (Expression | null)[];
}

export type Expression = { readonly place: SourcePlace } & (
  | { readonly kind: 'number'; readonly type: 'int' | 'uint' | 'float'; readonly value: number }
  | { readonly kind: 'bool'; readonly value: boolean }
  | { readonly kind: 'name'; readonly name: string }
  | { readonly kind: 'unary'; readonly operator: string; readonly operand: Expression }
  | {
      readonly kind: 'step';
      readonly operator: '++' | '--';
      readonly prefix: boolean;
      readonly target: Expression;
    }
  | {
      readonly kind: 'binary';
      readonly operator: string;
      readonly left: Expression;
      readonly right: Expression;
    }
  | { readonly kind: 'ternary'; readonly test: Expression; readonly yes: Expression; readonly no: Expression }
  | {
      readonly kind: 'assign';
      readonly operator: string;
      readonly target: Expression;
      readonly value: Expression;
    }
  | { readonly kind: 'sequence'; readonly items: readonly Expression[] }
  | { readonly kind: 'call'; readonly callee: TypeRef; readonly args: readonly Expression[] }
  | { readonly kind: 'list'; readonly items: readonly Expression[] }
  | { readonly kind: 'member'; readonly object: Expression; readonly name: string }
  | { readonly kind: 'index'; readonly object: Expression; readonly index: Expression }
);

export interface Declarator {
  readonly place: SourcePlace;
  readonly name: string;
  readonly lengths: readonly (Expression | null)[];
  readonly init: Expression | null;
}

export interface Declaration {
  readonly kind: 'declare';
  readonly place: SourcePlace;
  readonly constant: boolean;
  readonly type: TypeRef;
  readonly declarators: readonly Declarator[];
}

export type Statement = { readonly place: SourcePlace } & (
  | Declaration
  | { readonly kind: 'expression'; readonly expression: Expression }
  | { readonly kind: 'block'; readonly body: readonly Statement[] }
  | { readonly kind: 'if'; readonly test: Expression; readonly yes: Statement; readonly no: Statement | null }
  | {
      readonly kind: 'for';
      readonly init: Statement | null;
      readonly test: Expression | null;
      readonly step: Expression | null;
      readonly body: Statement;
    }
  /** Kernels only. */
  | { readonly kind: 'while'; readonly test: Expression; readonly body: Statement }
  | { readonly kind: 'return'; readonly value: Expression | null }
  | { readonly kind: 'break' }
  | { readonly kind: 'continue' }
);

export interface FunctionDefinition {
  readonly kind: 'function';
  readonly place: SourcePlace;
  readonly type: TypeRef;
  readonly name: string;
  readonly parameters: readonly {
    readonly place: SourcePlace;
    readonly qualifier: 'in' | 'out' | 'inout';
    readonly type: TypeRef;
    readonly name: string;
    readonly lengths: readonly (Expression | null)[];
  }[];
  /** null for a prototype. */
  readonly body: readonly Statement[] | null;
}

export interface StructDefinition {
  readonly kind: 'struct';
  readonly place: SourcePlace;
  readonly name: string;
  readonly fields: readonly {
    readonly place: SourcePlace;
    readonly type: TypeRef;
    readonly name: string;
    readonly lengths: readonly (Expression | null)[];
  }[];
}

export type TopLevel = FunctionDefinition | StructDefinition | Declaration;
