import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import type { Expression, TypeRef } from './ast.ts';
import { isBuiltin, resolveBuiltin } from './builtins.ts';
import { checkConstruct, convert, convertBase, fold, literal } from './construct.ts';
import { evaluateExpression } from './float64.ts';
import type { ArithmeticOperator, BinaryOperator, Expr, FunctionIR, Variable } from './ir.ts';
import type { Scope } from './scope.ts';
import {
  arrayOf,
  BOOL,
  componentCount,
  convertsImplicitly,
  FLOAT,
  INT,
  isNumeric,
  matrix,
  type ScalarName,
  scalarOf,
  type Type,
  typeNamed,
  UINT,
  vector,
  widerScalar,
} from './types.ts';

/** Component names: position, colour and texture coordinates, each a set of its own. */
const COMPONENTS = ['xyzw', 'rgba', 'stpq'];
const BITWISE = new Set(['&', '|', '^', '<<', '>>']);

/** Resolves and types one expression. @throws BrdfError where a name is unknown or types do not fit */
export function checkExpression(e: Expression, scope: Scope): Expr {
  const { place } = e;
  switch (e.kind) {
    case 'number':
      return literal(place, e.type === 'float' ? FLOAT : e.type === 'int' ? INT : UINT, e.value);
    case 'bool':
      return literal(place, BOOL, e.value);
    case 'name':
      return checkName(e.name, place, scope);
    case 'unary':
      return checkUnary(e.operator, checkExpression(e.operand, scope), place);
    case 'binary':
      return checkBinary(
        e.operator as BinaryOperator,
        checkExpression(e.left, scope),
        checkExpression(e.right, scope),
        place,
      );
    case 'ternary':
      return checkTernary(e, scope);
    case 'assign':
      return checkAssign(e, scope);
    case 'step': {
      const target = checkTarget(checkExpression(e.target, scope));
      if (!isNumeric(target.type) || target.type.kind === 'matrix')
        throw new BrdfError(place, `'${e.operator}' on a ${target.type.name}`, 'a number');
      return {
        kind: 'step',
        place,
        type: target.type,
        constant: false,
        operator: e.operator,
        prefix: e.prefix,
        target,
      };
    }
    case 'sequence': {
      const items = e.items.map((item) => checkExpression(item, scope));
      return { kind: 'sequence', place, type: (items.at(-1) as Expr).type, constant: false, items };
    }
    case 'call':
      return checkCall(e.callee, e.args, place, scope);
    case 'list':
      throw new BrdfError(place, "a list in '{}' here", 'it as the initialiser of an array or struct');
    case 'member':
      return checkMember(checkExpression(e.object, scope), e.name, place);
    case 'index':
      return checkIndex(checkExpression(e.object, scope), checkExpression(e.index, scope), place);
  }
}

/** An initialiser for a variable of this type: an expression, or a list in braces for an array or struct. */
export function checkInitialiser(e: Expression, type: Type | { element: Type }, scope: Scope): Expr {
  if (e.kind !== 'list') {
    const value = checkExpression(e, scope);
    if ('element' in type && !('kind' in type)) {
      if (value.type.kind !== 'array' || value.type.element !== type.element)
        throw new BrdfError(e.place, `a ${value.type.name} here`, `an array of ${type.element.name}`);
      return value;
    }
    return expectType(value, type as Type);
  }
  if ('element' in type) {
    const full = 'kind' in type ? type : arrayOf(type.element, e.items.length);
    const args = e.items.map((item) => checkInitialiser(item, full.element, scope));
    return checkConstruct(full, args, e.place);
  }
  if (type.kind === 'struct') {
    if (e.items.length !== type.fields.length)
      throw new BrdfError(e.place, `${e.items.length} values for ${type.name}`, `${type.fields.length}`);
    return checkConstruct(
      type,
      e.items.map((item, i) => checkInitialiser(item, (type.fields[i] as { type: Type }).type, scope)),
      e.place,
    );
  }
  return checkConstruct(
    type,
    e.items.map((item) => checkExpression(item, scope)),
    e.place,
  );
}

/** Converts implicitly to the wanted type. @throws BrdfError if GLSL does not convert so */
export function expectType(e: Expr, type: Type): Expr {
  if (!convertsImplicitly(e.type, type))
    throw new BrdfError(e.place, `a ${e.type.name} here`, `a ${type.name}`);
  return convert(e, type);
}

/** The type that a reference names, with its array lengths; `[]` takes its length from elsewhere. */
export function resolveType(
  ref: TypeRef,
  scope: Scope,
  more: readonly (Expression | null)[] = [],
): Type | { element: Type } {
  const base = typeNamed(ref.name) ?? scope.structs.get(ref.name);
  if (!base) throw new BrdfError(ref.place, `there is no type '${ref.name}'`);
  const lengths = [...more, ...ref.lengths];
  if (lengths.length > 1)
    throw new BrdfError(ref.place, 'an array of arrays', 'one array of vectors or structs');
  let type: Type = base;
  for (const length of lengths) {
    if (base.kind === 'void') throw new BrdfError(ref.place, 'an array of void');
    if (length === null) return { element: type };
    const value = checkExpression(length, scope);
    const count =
      value.constant && (value.type === INT || value.type === UINT) ? evaluateExpression(value) : null;
    if (typeof count !== 'number' || count < 1 || count > 4096)
      throw new BrdfError(length.place, 'this length of an array', 'a constant integer from 1 to 4096');
    type = arrayOf(type, count);
  }
  return type;
}

/** As resolveType, where a length must be written. */
export function resolveSizedType(
  ref: TypeRef,
  scope: Scope,
  more: readonly (Expression | null)[] = [],
): Type {
  const type = resolveType(ref, scope, more);
  if (!('kind' in type))
    throw new BrdfError(ref.place, 'an array without a length here', 'a constant integer');
  return type;
}

function checkName(name: string, place: SourcePlace, scope: Scope): Expr {
  const found = scope.lookup(name);
  if (!found) {
    const isFunction = scope.functions.has(name) || isBuiltin(name);
    throw new BrdfError(
      place,
      isFunction ? `'${name}' is a function` : `'${name}' is not declared`,
      isFunction ? `'${name}(...)'` : undefined,
    );
  }
  if ('body' in found)
    return {
      kind: 'call',
      place,
      type: found.result,
      constant: false,
      callee: scope.called(found),
      args: [],
    };
  if (found.role === 'constant') {
    return fold({ kind: 'variable', place, type: found.type, constant: true, variable: found });
  }
  if (found.role === 'parameter') scope.used.add(found);
  return { kind: 'variable', place, type: found.type, constant: false, variable: found };
}

function checkUnary(operator: string, operand: Expr, place: SourcePlace): Expr {
  const { type, constant } = operand;
  if (operator === '!') {
    if (type !== BOOL) throw new BrdfError(place, `'!' on a ${type.name}`, 'a bool');
    return fold({ kind: 'unary', place, type, constant, operator, operand });
  }
  const fits = operator === '~' ? scalarOf(type) === 'int' || scalarOf(type) === 'uint' : isNumeric(type);
  if (!fits) throw new BrdfError(place, `'${operator}' on a ${type.name}`, 'a number');
  if (operator === '+') return operand;
  return fold({ kind: 'unary', place, type, constant, operator: operator as '-' | '~', operand });
}

export function checkBinary(operator: BinaryOperator, left: Expr, right: Expr, place: SourcePlace): Expr {
  const constant = left.constant && right.constant;
  const wrong = (expected: string): never => {
    throw new BrdfError(place, `${left.type.name} ${operator} ${right.type.name}`, expected);
  };
  const make = (type: Type, l: Expr, r: Expr): Expr =>
    fold({ kind: 'binary', place, type, constant, operator, left: l, right: r });
  switch (operator) {
    case '&&':
    case '||':
    case '^^':
      if (left.type !== BOOL || right.type !== BOOL) wrong('two bools');
      return make(BOOL, left, right);
    case '==':
    case '!=':
    case '<':
    case '>':
    case '<=':
    case '>=': {
      const equality = operator === '==' || operator === '!=';
      const common = commonType(left.type, right.type);
      if (!common) return wrong('two values of one type');
      if (!equality && (common.kind !== 'scalar' || common === BOOL))
        wrong('two numbers (lessThan() and its like compare vectors)');
      if (common.kind !== 'scalar' && common.kind !== 'vector') wrong('numbers, bools or vectors');
      return make(BOOL, convert(left, common), convert(right, common));
    }
    default:
      return checkArithmetic(operator, left, right, wrong, make);
  }
}

function checkArithmetic(
  operator: ArithmeticOperator,
  left: Expr,
  right: Expr,
  wrong: (expected: string) => never,
  make: (type: Type, l: Expr, r: Expr) => Expr,
): Expr {
  if (!isNumeric(left.type) || !isNumeric(right.type)) wrong('two numbers');
  const base = widerScalar(scalarOf(left.type) as ScalarName, scalarOf(right.type) as ScalarName);
  if ((operator === '%' || BITWISE.has(operator)) && base === 'float')
    wrong('two integers (mod() serves floats)');
  const l = convertBase(left, base);
  const r = convertBase(right, base);
  const [a, b] = [l.type, r.type];
  if (a.kind === 'matrix' || b.kind === 'matrix') {
    if (operator === '*') {
      if (a.kind === 'matrix' && b.kind === 'matrix' && a.columns === b.rows)
        return make(matrix(b.columns, a.rows), l, r);
      if (a.kind === 'matrix' && b.kind === 'vector' && a.columns === b.size)
        return make(vector('float', a.rows), l, r);
      if (a.kind === 'vector' && b.kind === 'matrix' && a.size === b.rows)
        return make(vector('float', b.columns), l, r);
      if (a.kind === 'scalar') return make(b, l, r);
    }
    if (a.kind === 'matrix' && b.kind === 'scalar' && (operator === '*' || operator === '/'))
      return make(a, l, r);
    if (a === b && (operator === '+' || operator === '-')) return make(a, l, r);
    return wrong('operands whose sizes fit');
  }
  if (a.kind === 'scalar') return make(b, l, r);
  if (b.kind === 'scalar' || a === b) return make(a, l, r);
  return wrong('operands of one size');
}

/** The type to which both convert implicitly. */
export function commonType(a: Type, b: Type): Type | null {
  return convertsImplicitly(a, b) ? b : convertsImplicitly(b, a) ? a : null;
}

function checkTernary(e: Extract<Expression, { kind: 'ternary' }>, scope: Scope): Expr {
  const test = checkExpression(e.test, scope);
  if (test.type !== BOOL) throw new BrdfError(test.place, `a ${test.type.name} as a condition`, 'a bool');
  const yes = checkExpression(e.yes, scope);
  const no = checkExpression(e.no, scope);
  const type = commonType(yes.type, no.type);
  if (!type || type.kind === 'void')
    throw new BrdfError(e.place, `'?:' between ${yes.type.name} and ${no.type.name}`, 'one type');
  return fold({
    kind: 'ternary',
    place: e.place,
    type,
    constant: test.constant && yes.constant && no.constant,
    test,
    yes: convert(yes, type),
    no: convert(no, type),
  });
}

/** Checks that an expression can be assigned to, and marks its variable. */
export function checkTarget(target: Expr): Expr {
  let root = target;
  while (root.kind === 'swizzle' || root.kind === 'index' || root.kind === 'field') {
    if (root.kind === 'swizzle' && new Set(root.components).size !== root.components.length) {
      throw new BrdfError(root.place, 'a component is assigned twice', 'different components');
    }
    root = root.object;
  }
  if (root.kind !== 'variable' || root.variable.role === 'parameter' || root.variable.role === 'constant') {
    const what =
      root.kind === 'variable'
        ? `'${root.variable.name}' (a ${root.variable.role})`
        : root.kind === 'literal'
          ? 'a constant'
          : root.kind === 'call'
            ? `'${root.callee.name}'`
            : 'this';
    throw new BrdfError(target.place, `${what} cannot be assigned`, 'a local variable');
  }
  root.variable.assigned = true;
  return target;
}

function checkAssign(e: Extract<Expression, { kind: 'assign' }>, scope: Scope): Expr {
  const target = checkTarget(checkExpression(e.target, scope));
  const value = checkExpression(e.value, scope);
  const { place } = e;
  if (e.operator === '=') {
    return {
      kind: 'assign',
      place,
      type: target.type,
      constant: false,
      operator: null,
      target,
      value: expectType(value, target.type),
    };
  }
  const operator = e.operator.slice(0, -1) as ArithmeticOperator;
  const result = checkBinary(operator, target, value, place);
  if (result.kind !== 'binary' || result.type !== target.type) {
    throw new BrdfError(
      place,
      `${target.type.name} ${e.operator} ${value.type.name}`,
      `a result of type ${target.type.name}`,
    );
  }
  return { kind: 'assign', place, type: target.type, constant: false, operator, target, value: result.right };
}

function checkMember(object: Expr, name: string, place: SourcePlace): Expr {
  const { type, constant } = object;
  if (type.kind === 'struct') {
    const field = type.fields.findIndex((f) => f.name === name);
    if (field < 0)
      throw new BrdfError(
        place,
        `${type.name} has no field '${name}'`,
        type.fields.map((f) => f.name).join(', '),
      );
    return fold({
      kind: 'field',
      place,
      type: (type.fields[field] as { type: Type }).type,
      constant,
      object,
      field,
    });
  }
  const size = componentCount(type);
  const set = COMPONENTS.find((letters) => [...name].every((letter) => letters.includes(letter)));
  if (type.kind !== 'vector' || !set || name.length > 4)
    throw new BrdfError(
      place,
      `a ${type.name} has no '.${name}'`,
      type.kind === 'vector' ? 'components such as .xyz' : undefined,
    );
  const components = [...name].map((letter) => set.indexOf(letter));
  if (components.some((c) => c >= size))
    throw new BrdfError(place, `a ${type.name} has no '.${name}'`, `components of ${set.slice(0, size)}`);
  return fold({
    kind: 'swizzle',
    place,
    type: vector(type.scalar, name.length),
    constant,
    object,
    components,
  });
}

function checkIndex(object: Expr, index: Expr, place: SourcePlace): Expr {
  const { type } = object;
  const length =
    type.kind === 'vector'
      ? type.size
      : type.kind === 'matrix'
        ? type.columns
        : type.kind === 'array'
          ? type.length
          : 0;
  if (length === 0) throw new BrdfError(place, `'[]' on a ${type.name}`, 'an array, vector or matrix');
  if (index.type !== INT && index.type !== UINT)
    throw new BrdfError(index.place, `a ${index.type.name} as an index`, 'an integer');
  if (index.kind === 'literal' && ((index.value as number) < 0 || (index.value as number) >= length)) {
    throw new BrdfError(index.place, `index ${index.value} of a ${type.name}`, `0 to ${length - 1}`);
  }
  const constant = object.constant && index.constant;
  if (type.kind === 'vector' && index.kind === 'literal') {
    return fold({
      kind: 'swizzle',
      place,
      type: vector(type.scalar, 1),
      constant,
      object,
      components: [index.value as number],
    });
  }
  const element =
    type.kind === 'array'
      ? type.element
      : type.kind === 'matrix'
        ? vector('float', type.rows)
        : vector(scalarOf(type) as ScalarName, 1);
  return fold({ kind: 'index', place, type: element, constant, object, index });
}

function checkCall(
  callee: TypeRef,
  argExpressions: readonly Expression[],
  place: SourcePlace,
  scope: Scope,
): Expr {
  const args = argExpressions.map((arg) => checkExpression(arg, scope));
  const typeName = typeNamed(callee.name) ?? scope.structs.get(callee.name);
  if (typeName) {
    const type = resolveType(callee, scope);
    return checkConstruct(
      'kind' in type ? type : arrayOf(type.element, Math.max(1, args.length)),
      args,
      place,
    );
  }
  const user = chooseOverload(scope.functions.get(callee.name) ?? [], args, callee.name, place);
  if (user) {
    const converted = user.arguments.map(({ variable, qualifier }, i) => {
      const arg = args[i] as Expr;
      return qualifier === 'in' ? convert(arg, variable.type) : checkTarget(arg);
    });
    return {
      kind: 'call',
      place,
      type: user.result,
      constant: false,
      callee: scope.called(user),
      args: converted,
    };
  }
  if (callee.name === 'fetchData' && scope.table) return fetchData(scope.table, args, place, scope);
  const builtin = resolveBuiltin(
    callee.name,
    args.map((arg) => arg.type),
  );
  if (builtin) {
    const converted = args.map((arg, i) => convert(arg, builtin.args[i] as Type));
    return fold({
      kind: 'builtin',
      place,
      type: builtin.result,
      constant: args.every((arg) => arg.constant),
      name: callee.name,
      args: converted,
    });
  }
  const types = args.map((arg) => arg.type.name).join(', ');
  const known = scope.functions.get(callee.name)?.map(signature) ?? [];
  throw new BrdfError(
    place,
    `there is no function ${callee.name}(${types})`,
    known.length > 0
      ? known.join(' or ')
      : isBuiltin(callee.name)
        ? 'arguments that GLSL defines for it'
        : undefined,
  );
}

/** vec3 fetchData(int i): the i-th triple of the model's measured data. */
function fetchData(table: Variable, args: readonly Expr[], place: SourcePlace, scope: Scope): Expr {
  const [index] = args;
  if (args.length !== 1 || index?.type !== INT) {
    throw new BrdfError(place, `fetchData(${args.map((arg) => arg.type.name).join(', ')})`, 'fetchData(int)');
  }
  scope.used.add(table);
  const data: Expr = { kind: 'variable', place, type: table.type, constant: false, variable: table };
  return {
    kind: 'builtin',
    place,
    type: vector('float', 3),
    constant: false,
    name: 'fetchData',
    args: [data, index],
  };
}

function chooseOverload(
  overloads: readonly FunctionIR[],
  args: readonly Expr[],
  name: string,
  place: SourcePlace,
): FunctionIR | null {
  const ranked = overloads
    .filter(
      (f) =>
        f.arguments.length === args.length &&
        f.arguments.every(({ variable, qualifier }, i) =>
          qualifier === 'in'
            ? convertsImplicitly((args[i] as Expr).type, variable.type)
            : (args[i] as Expr).type === variable.type,
        ),
    )
    .map((f) => ({
      f,
      conversions: f.arguments.filter(({ variable }, i) => (args[i] as Expr).type !== variable.type).length,
    }))
    .sort((a, b) => a.conversions - b.conversions);
  const [best, next] = ranked;
  if (best && next && best.conversions === next.conversions)
    throw new BrdfError(
      place,
      `this call of ${name} fits two overloads`,
      `${signature(best.f)} or ${signature(next.f)} alone`,
    );
  return best?.f ?? null;
}

function signature(f: FunctionIR): string {
  return `${f.name}(${f.arguments.map(({ variable }) => (variable as Variable).type.name).join(', ')})`;
}
