import type { ArithmeticOperator } from '../ir.ts';
import { componentCount, type MatrixType, type ScalarName, scalarOf, type Type, vector } from '../types.ts';
import type { Body } from './body.ts';
import { type Code, i32, op, select } from './code.ts';
import { cellsOf } from './layout.ts';
import { components, compose, dot, perCell, perComponent, prefixOf, splat, widen } from './vectors.ts';

/** GLSL's operators on cells. */

const PLAIN: Partial<Record<ArithmeticOperator, string>> = { '+': 'add', '-': 'sub', '*': 'mul' };
const BITWISE: Partial<Record<ArithmeticOperator, string>> = { '&': 'and', '|': 'or', '^': 'xor' };
const COMPARE: Record<string, string> = {
  '==': 'eq',
  '!=': 'ne',
  '<': 'lt',
  '>': 'gt',
  '<=': 'le',
  '>=': 'ge',
};

/** An arithmetic operation between scalars, vectors and matrices of one component type. */
export function arithmetic(
  body: Body,
  operator: ArithmeticOperator,
  left: readonly Code[],
  right: readonly Code[],
  leftType: Type,
  rightType: Type,
): readonly Code[] {
  if (leftType.kind === 'matrix' || rightType.kind === 'matrix')
    return matrixArithmetic(body, operator, left, right, leftType, rightType);
  const name = scalarOf(leftType) as ScalarName;
  const size = Math.max(componentCount(leftType), componentCount(rightType));
  const result = vector(name, size);
  if ((operator === '/' && name !== 'float') || operator === '%') {
    const f = (a: Code, b: Code) => divide(body, operator, name, a, b);
    return perComponent(body, [left, right], [leftType, rightType], result, f);
  }
  if (operator === '<<' || operator === '>>') {
    const suffix = operator === '<<' ? 'shl' : name === 'uint' ? 'shr_u' : 'shr_s';
    if (size === 4 && componentCount(leftType) === 4 && componentCount(rightType) === 1)
      return [op(`i32x4.${suffix}`, left[0] as Code, right[0] as Code)];
    const f = (a: Code, b: Code) => op(`i32.${suffix}`, a, b);
    return perComponent(body, [left, right], [leftType, rightType], result, f);
  }
  const a = widen(body, left, leftType, size);
  const b = widen(body, right, rightType, size);
  return perCell([a, b], (x, y) => cellArithmetic(operator, name, x, y));
}

function cellArithmetic(operator: ArithmeticOperator, name: ScalarName, a: Code, b: Code): Code {
  const bitwise = BITWISE[operator];
  if (bitwise) return op(a.type === 'v128' ? `v128.${bitwise}` : `i32.${bitwise}`, a, b);
  return op(`${prefixOf(a, name)}.${PLAIN[operator] ?? 'div'}`, a, b);
}

/** Whole division; by zero it gives the dividend, and a remainder of 0. */
function divide(body: Body, operator: '/' | '%', name: ScalarName, a: Code, b: Code): Code {
  const sign = name === 'uint' ? 'u' : 's';
  const instruction = `i32.${operator === '/' ? 'div' : 'rem'}_${sign}`;
  if (b.constant !== null && b.constant !== 0 && b.constant !== -1) return op(instruction, a, b);
  const divisor = body.pin(b);
  if (instruction !== 'i32.div_s') return op(instruction, a, select(op('i32.eqz', divisor), i32(1), divisor));
  // -2^31 / -1 is beyond the numbers there are, and the instruction would trap.
  const dividend = body.pin(a);
  const special = op('i32.lt_u', op('i32.add', divisor, i32(1)), i32(2));
  return select(
    op('i32.eq', divisor, i32(-1)),
    op('i32.sub', i32(0), dividend),
    op(instruction, dividend, select(special, i32(1), divisor)),
  );
}

/** A comparison of scalars (a bool), or component by component (a bool each). */
export function compareCells(
  operator: string,
  left: readonly Code[],
  right: readonly Code[],
  name: ScalarName,
): readonly Code[] {
  const suffix = COMPARE[operator] as string;
  const ordered = suffix !== 'eq' && suffix !== 'ne' && name !== 'float';
  const full = ordered ? `${suffix}_${name === 'int' ? 's' : 'u'}` : suffix;
  return perCell([left, right], (a, b) => op(`${prefixOf(a, name)}.${full}`, a, b));
}

/** Whether two scalars or vectors are equal. */
export function equal(left: readonly Code[], right: readonly Code[], name: ScalarName): Code {
  return all(compareCells('==', left, right, name));
}

export function all(bools: readonly Code[]): Code {
  const [first] = bools as readonly [Code];
  if (first.type === 'v128') return op('i32x4.all_true', first);
  return bools.reduce((a, b) => op('i32.and', a, b));
}

export function any(bools: readonly Code[]): Code {
  const [first] = bools as readonly [Code];
  if (first.type === 'v128') return op('v128.any_true', first);
  return bools.reduce((a, b) => op('i32.or', a, b));
}

/** Minus a scalar, vector or matrix. */
export function negate(cells: readonly Code[], name: ScalarName): readonly Code[] {
  return cells.map((cell) => {
    if (name === 'float') return op(`${prefixOf(cell, name)}.neg`, cell);
    return cell.type === 'v128' ? op('i32x4.neg', cell) : op('i32.sub', i32(0), cell);
  });
}

/** The bits of whole numbers the other way round. */
export function complement(cells: readonly Code[]): readonly Code[] {
  return cells.map((cell) => (cell.type === 'v128' ? op('v128.not', cell) : op('i32.xor', cell, i32(-1))));
}

function columnsOf(cells: readonly Code[], type: MatrixType): readonly Code[][] {
  const count = cellsOf(vector('float', type.rows)).length;
  return Array.from({ length: type.columns }, (_, c) => cells.slice(c * count, (c + 1) * count));
}

function matrixArithmetic(
  body: Body,
  operator: ArithmeticOperator,
  left: readonly Code[],
  right: readonly Code[],
  a: Type,
  b: Type,
): readonly Code[] {
  if (a.kind === 'scalar' || b.kind === 'scalar') {
    const [matrix, cells, factor] = a.kind === 'scalar' ? [b, right, left] : [a, left, right];
    const scalar = body.pin(factor[0] as Code);
    const wide = (matrix as MatrixType).rows === 4 ? body.pin(splat(scalar, 'float')) : scalar;
    return cells.map((cell) => cellArithmetic(operator, 'float', cell, wide));
  }
  if (operator !== '*') return perCell([left, right], (x, y) => cellArithmetic(operator, 'float', x, y));
  if (a.kind !== 'matrix') {
    const matrix = b as MatrixType;
    const row = body.pinAll(left);
    const values = columnsOf(right, matrix).map((column) => dot(body, row, column, a));
    return compose(body, values, 'float');
  }
  const columns = columnsOf(body.pinAll(left), a);
  if (b.kind !== 'matrix') return transform(body, columns, right, b);
  const columnType = vector('float', b.rows);
  return columnsOf(right, b).flatMap((column) => transform(body, columns, column, columnType) as Code[]);
}

/** matrix * vector: the columns' sum, weighted by the vector's components. */
function transform(
  body: Body,
  columns: readonly (readonly Code[])[],
  cells: readonly Code[],
  type: Type,
): readonly Code[] {
  const weights = components(body, cells, type).map((weight) => body.pin(weight));
  const terms = columns.map((column, c) =>
    column.map((cell) => {
      const weight = weights[c] as Code;
      const factor = cell.type === 'v128' ? splat(weight, 'float') : weight;
      return op(`${prefixOf(cell, 'float')}.mul`, cell, factor);
    }),
  );
  return terms.reduce(
    (total, term) => perCell([total, term], (x, y) => op(`${prefixOf(x, 'float')}.add`, x, y)) as Code[],
  );
}
