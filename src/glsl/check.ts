import { BrdfError } from '../brdf/error.ts';
import type { Parameter } from '../brdf/model.ts';
import type { Declaration, FunctionDefinition, Statement, StructDefinition, TopLevel } from './ast.ts';
import {
  checkExpression,
  checkInitialiser,
  expectType,
  resolveSizedType,
  resolveType,
} from './check-expression.ts';
import { convert } from './construct.ts';
import { evaluateExpression } from './float64.ts';
import type { Expr, FunctionIR, Program, Stmt, Variable } from './ir.ts';
import { countTurns } from './loops.ts';
import { orderFunctions } from './order.ts';
import { Scope } from './scope.ts';
import { BOOL, FLOAT, INT, TABLE, type Type, typeNamed, VOID } from './types.ts';

export interface CheckOptions {
  /** Whether the GLSL may read measured data by fetchData(). */
  readonly hasData?: boolean;
  /** Set for a kernel and for what is linked into one. */
  readonly kernel?: KernelContext;
}

/** What a part of a kernel is checked against. */
export interface KernelContext {
  /** Functions and variables of the whole kernel need different numbers: those of this part start here. */
  readonly firstId: number;
  /** Programs that this one may call, each complete. */
  readonly programs: readonly Program[];
  /** Their functions and variables, by the names that they have here. */
  readonly functions: ReadonlyMap<string, FunctionIR>;
  readonly variables: ReadonlyMap<string, Variable>;
}

/** Resolves and types a parsed shader. @throws BrdfError */
export function checkProgram(
  tree: readonly TopLevel[],
  parameters: readonly Parameter[],
  options: CheckOptions = {},
): Program {
  return new Checker(options.kernel ?? null).program(tree, parameters, options.hasData ?? false);
}

const PARAMETER_TYPES = { float: FLOAT, color: typeNamed('vec3') as Type, bool: BOOL } as const;

class Checker {
  private nextId: number;
  private readonly functions: FunctionIR[] = [];
  private readonly kernel: KernelContext | null;

  constructor(kernel: KernelContext | null) {
    this.kernel = kernel;
    this.nextId = kernel?.firstId ?? 0;
  }

  program(tree: readonly TopLevel[], parameters: readonly Parameter[], hasData: boolean): Program {
    const table = hasData ? this.variable('data', TABLE, 'parameter') : null;
    const scope = Scope.global(table, this.kernel !== null);
    // In a kernel a model's parameters are variables that the kernel sets.
    const role = this.kernel ? 'shared' : 'parameter';
    const variables = parameters.map((parameter) =>
      this.variable(parameter.name, PARAMETER_TYPES[parameter.type], role),
    );
    for (const variable of variables) scope.declare(variable.name, variable);
    for (const [name, variable] of this.kernel?.variables ?? []) scope.declare(name, variable);
    for (const [name, f] of this.kernel?.functions ?? []) scope.functions.set(name, [f]);
    // A shader's own globals may hide parameters of the same name.
    const globals = scope.enterBlock();
    for (const item of tree) {
      if (item.kind === 'struct') this.struct(item, globals);
      else if (item.kind === 'declare') this.global(item, globals);
      else this.function(item, globals);
    }
    if (table) variables.push(table);
    if (!this.kernel) return { parameters: variables, functions: orderFunctions(this.functions, variables) };
    const linked = new Set(this.kernel.programs.flatMap((program) => program.functions));
    const functions = orderFunctions([...linked, ...this.functions], [], Number.POSITIVE_INFINITY);
    return { parameters: variables, functions };
  }

  private variable(
    name: string,
    type: Type,
    role: Variable['role'],
    constant: Variable['constant'] = null,
  ): Variable {
    return { id: this.nextId++, name, type, role, constant, assigned: false };
  }

  private struct(item: StructDefinition, scope: Scope): void {
    if (scope.structs.has(item.name)) throw new BrdfError(item.place, `a second struct '${item.name}'`);
    const fields: { name: string; type: Type }[] = [];
    for (const field of item.fields) {
      const type = resolveSizedType(field.type, scope, field.lengths);
      if (type.kind === 'void' || fields.some((f) => f.name === field.name))
        throw new BrdfError(
          field.place,
          `field '${field.name}' of struct '${item.name}'`,
          'a type with values and a name of its own',
        );
      fields.push({ name: field.name, type });
    }
    if (fields.length === 0) throw new BrdfError(item.place, `struct '${item.name}' is empty`, 'a field');
    scope.structs.set(item.name, { kind: 'struct', name: item.name, fields });
  }

  /** A global is a constant, or is computed from the parameters wherever it is read. */
  private global(item: Declaration, scope: Scope): void {
    for (const declarator of item.declarators) {
      if (!declarator.init && this.kernel) {
        const type = resolveSizedType(item.type, scope, declarator.lengths);
        if (!scope.declare(declarator.name, this.variable(declarator.name, type, 'shared')))
          throw new BrdfError(declarator.place, `a second '${declarator.name}'`);
        continue;
      }
      if (!declarator.init)
        throw new BrdfError(declarator.place, `global '${declarator.name}' has no value`, 'an initialiser');
      const inner = scope.enterFunction();
      const init = this.initialiser(item, declarator, inner);
      const meaning = init.constant
        ? this.variable(declarator.name, init.type, 'constant', evaluateExpression(init))
        : this.newFunction(
            declarator.name,
            item,
            init.type,
            [{ kind: 'return', place: init.place, value: init }],
            inner,
          );
      if (!scope.declare(declarator.name, meaning))
        throw new BrdfError(declarator.place, `a second '${declarator.name}'`);
    }
  }

  private initialiser(item: Declaration, declarator: Declaration['declarators'][number], scope: Scope): Expr {
    const type = resolveType(item.type, scope, declarator.lengths);
    if ('kind' in type && type.kind === 'void')
      throw new BrdfError(item.place, `'${declarator.name}' is void`, 'a type with values');
    return checkInitialiser(declarator.init as NonNullable<typeof declarator.init>, type, scope);
  }

  private newFunction(
    name: string,
    at: Pick<FunctionIR, 'place'>,
    result: Type,
    body: readonly Stmt[],
    scope: Scope,
  ): FunctionIR {
    const f: FunctionIR = {
      id: this.nextId++,
      name,
      place: at.place,
      result,
      arguments: [],
      body,
      uses: [...scope.used],
      calls: [...scope.calls],
    };
    this.functions.push(f);
    return f;
  }

  private function(item: FunctionDefinition, scope: Scope): void {
    const result = resolveSizedType(item.type, scope);
    const args = item.parameters.map(({ place, qualifier, type: ref, name, lengths }) => {
      const type = resolveSizedType(ref, scope, lengths);
      if (type.kind === 'void')
        throw new BrdfError(place, `argument '${name}' is void`, 'a type with values');
      return { variable: this.variable(name, type, 'argument'), qualifier };
    });
    const overloads = scope.functions.get(item.name) ?? [];
    let f = overloads.find(
      (other) =>
        other.arguments.length === args.length &&
        other.arguments.every((arg, i) => arg.variable.type === args[i]?.variable.type),
    );
    if (f && item.body && this.functions.includes(f))
      throw new BrdfError(item.place, `a second function ${item.name} with these arguments`);
    if (f && f.result !== result)
      throw new BrdfError(item.place, `${item.name} was declared to return ${f.result.name}`, f.result.name);
    if (!item.body) {
      f ??= {
        id: this.nextId++,
        name: item.name,
        place: item.place,
        result,
        arguments: args,
        body: [],
        uses: [],
        calls: [],
      };
      if (!overloads.includes(f)) scope.functions.set(item.name, [...overloads, f]);
      return;
    }
    // A prototype's arguments are unknown to the body: the definition's take their place in the same object.
    const definition = Object.assign(
      f ?? { id: this.nextId++, name: item.name, result, body: [], uses: [], calls: [] },
      { place: item.place, arguments: args },
    ) as FunctionIR;
    if (!f) scope.functions.set(item.name, [...overloads, definition]);
    const inner = scope.enterFunction();
    for (const [i, { variable }] of args.entries()) {
      if (!inner.declare(variable.name, variable))
        throw new BrdfError(item.parameters[i]?.place ?? item.place, `a second argument '${variable.name}'`);
    }
    definition.body = this.statements(item.body, inner.enterBlock(), result, false);
    definition.uses = [...inner.used];
    definition.calls = [...inner.calls];
    this.functions.push(definition);
  }

  private statements(body: readonly Statement[], scope: Scope, result: Type, inLoop: boolean): Stmt[] {
    return body.flatMap((statement) => this.statement(statement, scope, result, inLoop));
  }

  private statement(s: Statement, scope: Scope, result: Type, inLoop: boolean): Stmt[] {
    const { place } = s;
    switch (s.kind) {
      case 'declare':
        return s.declarators.flatMap((declarator) => this.local(s, declarator, scope));
      case 'expression':
        return [{ kind: 'expression', place, expression: checkExpression(s.expression, scope) }];
      case 'block':
        return [{ kind: 'block', place, body: this.statements(s.body, scope.enterBlock(), result, inLoop) }];
      case 'if': {
        const test = this.condition(checkExpression(s.test, scope));
        const branch = (b: Statement): Stmt => ({
          kind: 'block',
          place: b.place,
          body: this.statement(b, scope.enterBlock(), result, inLoop),
        });
        return [{ kind: 'if', place, test, yes: branch(s.yes), no: s.no && branch(s.no) }];
      }
      case 'for':
        return [this.forLoop(s, scope.enterBlock(), result)];
      case 'while': {
        const test = this.condition(checkExpression(s.test, scope));
        const body = this.statement(s.body, scope.enterBlock(), result, true);
        return [{ kind: 'loop', place, test, body: { kind: 'block', place: s.body.place, body } }];
      }
      case 'return': {
        if (!s.value) {
          if (result !== VOID) throw new BrdfError(place, 'return without a value', `a ${result.name}`);
          return [{ kind: 'return', place, value: null }];
        }
        if (result === VOID) throw new BrdfError(place, 'a void function returns a value', 'return;');
        return [{ kind: 'return', place, value: expectType(checkExpression(s.value, scope), result) }];
      }
      default:
        if (!inLoop) throw new BrdfError(place, `'${s.kind}' outside a loop`);
        return [s];
    }
  }

  private condition(test: Expr): Expr {
    if (test.type !== BOOL) throw new BrdfError(test.place, `a ${test.type.name} as a condition`, 'a bool');
    return test;
  }

  private local(item: Declaration, declarator: Declaration['declarators'][number], scope: Scope): Stmt[] {
    const { place, name } = declarator;
    let init: Expr | null = null;
    let type: Type;
    if (declarator.init) {
      init = this.initialiser(item, declarator, scope);
      type = init.type;
    } else {
      if (item.constant) throw new BrdfError(place, `constant '${name}' has no value`, 'an initialiser');
      type = resolveSizedType(item.type, scope, declarator.lengths);
      if (type.kind === 'void') throw new BrdfError(place, `'${name}' is void`, 'a type with values');
    }
    const value = item.constant && init?.constant ? evaluateExpression(init) : null;
    const variable =
      value === null ? this.variable(name, type, 'local') : this.variable(name, type, 'constant', value);
    if (!scope.declare(name, variable)) throw new BrdfError(place, `a second '${name}' in one block`);
    return value === null ? [{ kind: 'declare', place, variable, init }] : [];
  }

  private forLoop(s: Extract<Statement, { kind: 'for' }>, scope: Scope, result: Type): Stmt {
    const bounded = 'for (int i = A; i < B; i += C) with constants A, B, C';
    const { place, init } = s;
    const declarator =
      init?.kind === 'declare' && init.declarators.length === 1 ? init.declarators[0] : undefined;
    if (init?.kind !== 'declare' || !declarator?.init || !s.test || !s.step)
      throw new BrdfError(place, 'a loop without constant bounds', bounded);
    const type = resolveSizedType(init.type, scope, declarator.lengths);
    if (type !== INT && type !== FLOAT && type.name !== 'uint')
      throw new BrdfError(init.place, `a ${type.name} as a loop's variable`, bounded);
    const first = convert(this.initialiser(init, declarator, scope), type);
    const variable = this.variable(declarator.name, type, 'local');
    scope.declare(variable.name, variable);
    const test = this.condition(checkExpression(s.test, scope));
    const step = checkExpression(s.step, scope);
    const count = countTurns(variable, first, test, step);
    if (count === null)
      throw new BrdfError(place, 'a loop without constant bounds', `${bounded}, at most 4096 turns`);
    variable.assigned = false;
    const body: Stmt = {
      kind: 'block',
      place: s.body.place,
      body: this.statement(s.body, scope.enterBlock(), result, true),
    };
    if (variable.assigned)
      throw new BrdfError(place, `the loop assigns its own variable '${variable.name}'`, bounded);
    variable.assigned = true;
    return { kind: 'for', place, variable, first, test, step, body, count };
  }
}
