import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import { convert, convertBase, fold } from './construct.ts';
import type { ArithmeticOperator, BinaryOperator, Expr } from './ir.ts';
import {
  BOOL,
  convertsImplicitly,
  isNumeric,
  matrix,
  type ScalarName,
  scalarOf,
  type Type,
  vector,
  widerScalar,
} from './types.ts';

const BITWISE = new Set(['&', '|', '^', '<<', '>>']);

/** A typed unary operation; folded if it is constant. @throws BrdfError if the operand does not suit */
export function checkUnary(operator: string, operand: Expr, place: SourcePlace): Expr {
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

/** A typed binary operation, its operands converted; folded if it is constant. @throws BrdfError */
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
