import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import type { Expression, TypeRef } from './ast.ts';
import { isBuiltin } from './builtins.ts';
import { callFunction } from './calls.ts';
import { checkConstruct, convert, fold, literal } from './construct.ts';
import { evaluateExpression } from './float64.ts';
import type { ArithmeticOperator, BinaryOperator, Expr } from './ir.ts';
import { checkBinary, checkUnary, commonType } from './operators.ts';
import type { Scope } from './scope.ts';
import { checkTarget } from './target.ts';
import {
  arrayOf,
  BOOL,
  componentCount,
  convertsImplicitly,
  FLOAT,
  INT,
  isNumeric,
  type ScalarName,
  scalarOf,
  type Type,
  typeNamed,
  UINT,
  vector,
} from './types.ts';

/** Component names: position, colour and texture coordinates, each a set of its own. */
const COMPONENTS = ['xyzw', 'rgba', 'stpq'];

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
  return callFunction(callee.name, args, place, scope);
}
